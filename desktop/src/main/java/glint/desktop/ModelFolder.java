package glint.desktop;

import glint.desktop.window.FileWatch;
import glint.image.ByteImage;
import glint.io.SceneFolder;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Opens the models and images that one scene file names, and keeps what tells whether one has
 * changed.
 */
final class ModelFolder implements SceneFolder {

  private final Path sceneFile;
  private final List<MessageDigest> digests = new ArrayList<>();
  private final Map<Path, FileTime> parts;
  private FileTime newest;

  /**
   * Makes the folder of a scene file.
   *
   * @param parts is told of every file that is looked for, and when it was last changed
   */
  ModelFolder(Path sceneFile, Map<Path, FileTime> parts) throws IOException {
    this.sceneFile = sceneFile;
    this.parts = parts;
    newest = modified(sceneFile);
  }

  private FileTime modified(Path file) throws IOException {
    parts.put(file, FileWatch.MISSING);
    FileTime modified = Files.getLastModifiedTime(file);
    parts.put(file, modified);
    return modified;
  }

  @Override
  public InputStream open(String path) throws IOException {
    try {
      Path file = sceneFile.resolveSibling(path);
      if (Files.isDirectory(file)) {
        throw new IOException("is a folder, not a file");
      }
      FileTime modified = modified(file);
      MessageDigest digest = Digests.begin();
      InputStream in = new DigestInputStream(Files.newInputStream(file), digest);
      newest = newest.compareTo(modified) < 0 ? modified : newest;
      digests.add(digest);
      return in;
    } catch (IOException | InvalidPathException e) {
      throw new IOException(Reasons.of(e), e);
    }
  }

  @Override
  public String name(String path) {
    return sceneFile.resolveSibling(path).toString();
  }

  @Override
  public ByteImage decode(InputStream in, Consumer<String> remarks) throws IOException {
    try {
      return TextureFiles.decode(in, remarks);
    } catch (IOException e) {
      throw new IOException(Reasons.of(e), e);
    }
  }

  /** Returns when the last change was made to the scene file or to another that was opened. */
  FileTime newest() {
    return newest;
  }

  /** Returns the digest of all that was read, that of the scene file's bytes being given. */
  String digest(String ofSceneFile) {
    if (digests.isEmpty()) {
      return ofSceneFile;
    }
    StringBuilder all = new StringBuilder(ofSceneFile);
    digests.forEach(digest -> all.append('\n').append(Digests.end(digest)));
    return Digests.of(all.toString());
  }
}
