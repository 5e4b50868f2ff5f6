package glint.android;

import android.content.Context;
import android.content.pm.PackageManager;
import android.graphics.Bitmap;
import android.graphics.BitmapFactory;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.Comparator;
import java.util.UUID;

/** Small pictures on disk, by what the scene's file holds; what cannot be kept is made again. */
final class ThumbnailCache {

  /** More are not kept: the oldest go first. */
  private static final int MOST = 500;

  private static final int LOSSLESS = 100;

  private final Path folder;
  private final long installed;

  /** Sets up the cache of an app: what a version of it has made is of no use to another. */
  ThumbnailCache(Context context) {
    folder = context.getCacheDir().toPath().resolve("thumbnails");
    try {
      String app = context.getPackageName();
      installed = context.getPackageManager().getPackageInfo(app, 0).lastUpdateTime;
    } catch (PackageManager.NameNotFoundException e) {
      throw new IllegalStateException("an app that runs is installed", e);
    }
  }

  /** Returns a scene's picture if it is there, or null. */
  Bitmap read(String digest, String scene) {
    return BitmapFactory.decodeFile(file(digest, scene).toString());
  }

  /**
   * Keeps a scene's picture.
   *
   * @param digest a hash of the bytes of the scene's file
   */
  void write(String digest, String scene, Bitmap picture) {
    try {
      Files.createDirectories(folder);
      Path temporary = Files.createTempFile(folder, "", ".tmp");
      try (OutputStream out = Files.newOutputStream(temporary)) {
        picture.compress(Bitmap.CompressFormat.PNG, LOSSLESS, out);
      }
      Files.move(temporary, file(digest, scene), StandardCopyOption.REPLACE_EXISTING);
      prune();
    } catch (IOException e) {
      return; // a full disk
    }
  }

  private void prune() throws IOException {
    File[] files = folder.toFile().listFiles();
    Arrays.sort(files, Comparator.comparingLong(File::lastModified));
    for (int i = 0; i < files.length - MOST; i++) {
      Files.deleteIfExists(files[i].toPath());
    }
  }

  private Path file(String digest, String scene) {
    String key = installed + "\n" + digest + "\n" + scene;
    UUID name = UUID.nameUUIDFromBytes(key.getBytes(StandardCharsets.UTF_8));
    return folder.resolve(name + ".png");
  }
}
