package glint.io;

import glint.image.ByteImage;
import glint.optics.ImageTexture;
import glint.optics.Material;
import java.util.ArrayList;
import java.util.List;

/** A library of materials while the parts of a model are found in it, with its images. */
final class ModelLibrary {

  private final Beside beside;
  private final Images images;
  private final Problems remarks;

  /**
   * Begins with no image.
   *
   * @param folder that of the scene file
   * @param path the library's, from there
   */
  ModelLibrary(SceneFolder folder, String path, Images images, int mostNotes) {
    beside = new Beside(folder, path);
    this.images = images;
    remarks = new Problems(folder.name(path), mostNotes);
  }

  /** Returns a material of this library, with its image laid on. */
  Material finished(MtlMaterial material) {
    return material
        .map()
        .map(m -> material.material().textured(texture(m)))
        .orElse(material.material());
  }

  private ImageTexture texture(MtlMap map) {
    Place place = new Place(map.line(), map.column());
    String last = map.file().substring(map.file().lastIndexOf('/') + 1);
    List<String> paths = new ArrayList<>(List.of(beside.path(map.file())));
    if (!last.equals(map.file()) && !last.isEmpty()) {
      paths.add(beside.path(last)); // it may be of somebody's own disk
    }
    ByteImage image = images.find(paths, map.file(), note -> tell(place, note));
    return map.texture(image);
  }

  private void tell(Place place, String note) {
    if (remarks.takesMore()) {
      remarks.report(place, note);
    }
  }

  /** Returns what was left aside of images, or is missing. */
  List<Problem> notes() {
    return remarks.inFileOrder();
  }
}
