package glint.desktop;

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

/** Opens the models that one scene file names, and keeps what tells whether one has changed. */
final class ModelFolder implements SceneFolder {

  private final Path sceneFile;
  private final List<MessageDigest> digests = new ArrayList<>();
  private FileTime newest;

  ModelFolder(Path sceneFile) throws IOException {
    this.sceneFile = sceneFile;
    newest = Files.getLastModifiedTime(sceneFile);
  }

  @Override
  public InputStream open(String path) throws IOException {
    try {
      Path model = sceneFile.resolveSibling(path);
      if (Files.isDirectory(model)) {
        throw new IOException("is a folder, not a model");
      }
      FileTime modified = Files.getLastModifiedTime(model);
      MessageDigest digest = Digests.begin();
      InputStream in = new DigestInputStream(Files.newInputStream(model), digest);
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

  /** Returns when the last change was made to the scene file or to a model that was opened. */
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
