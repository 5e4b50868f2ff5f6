package glint.io;

import glint.image.ByteImage;
import java.io.IOException;
import java.io.InputStream;
import java.util.function.Consumer;

/**
 * The files beside one that a scene file names, such as a model's materials.
 *
 * @param folder that of the scene file
 * @param file a path from there
 */
record Beside(SceneFolder folder, String file) implements SceneFolder {

  @Override
  public InputStream open(String name) throws IOException {
    return folder.open(path(name));
  }

  @Override
  public String name(String name) {
    return folder.name(path(name));
  }

  @Override
  public ByteImage decode(InputStream in, Consumer<String> remarks) throws IOException {
    return folder.decode(in, remarks);
  }

  /** Returns the path, from the scene file's folder, of a file beside. */
  String path(String name) {
    boolean isWhole = name.startsWith("/") || name.matches("[A-Za-z]:.*");
    int end = Math.max(file.lastIndexOf('/'), file.lastIndexOf('\\')) + 1;
    return isWhole ? name : file.substring(0, end) + name;
  }
}
