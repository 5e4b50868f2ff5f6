package glint.android;

import android.content.Context;
import android.net.Uri;
import glint.io.Problem;
import glint.io.SceneFile;
import glint.io.SceneFiles;
import glint.io.SceneFolder;
import java.io.IOException;
import java.io.InputStream;
import java.math.BigInteger;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.List;
import java.util.stream.Collectors;

/** Reads a scene file that is packed into the app, or one that a person picked. */
final class SceneReader {

  /** The scenes that the app begins with. */
  static final Uri GALLERY = Uri.parse("asset:/gallery.yaml");

  /** More that are packed into it, of models. */
  static final Uri STORIES = Uri.parse("asset:/stories.yaml");

  private static final String ASSET = "asset";

  private final Context context;

  SceneReader(Context context) {
    this.context = context;
  }

  /** Reads a file; what cannot be read becomes a problem. */
  Reading read(Uri file) {
    boolean packed = ASSET.equals(file.getScheme());
    String name = packed ? file.getLastPathSegment() : Document.name(context, file);
    try {
      if (!packed) {
        Document.checkSize(context, file, name);
      }
      SceneFolder folder = packed ? new SceneAssets(context.getAssets()) : new Alone(context);
      try (InputStream in = packed ? folder.open(name) : Document.open(context, file)) {
        DigestInputStream hashed = new DigestInputStream(in, sha256());
        return reading(name, SceneFiles.read(hashed, name, folder), hashed.getMessageDigest());
      }
    } catch (IOException e) {
      return failed(name, context.getString(R.string.cannot_read, name, e.getMessage()));
    } catch (OutOfMemoryError e) {
      return failed(name, context.getString(R.string.no_memory_to_read, name));
    } catch (StackOverflowError e) {
      return failed(name, context.getString(R.string.nested_too_deeply, name));
    }
  }

  private static Reading reading(String name, SceneFile file, MessageDigest digest) {
    List<String> problems =
        file.problems().stream().map(Problem::toString).collect(Collectors.toList());
    String hex = new BigInteger(1, digest.digest()).toString(16);
    return new Reading(name, hex, file.scenes(), problems);
  }

  private static Reading failed(String name, String why) {
    return new Reading(name, "", List.of(), List.of(why));
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Android has SHA-256", e);
    }
  }

  /** Where a picked document lies: nothing else there may be read. */
  private record Alone(Context context) implements SceneFolder {
    @Override
    public InputStream open(String path) throws IOException {
      throw new IOException(context.getString(R.string.beside_document));
    }
  }
}
