package glint.desktop;

import glint.render.Aov;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** The files that a scene becomes; immutable. */
record OutputFiles(Optional<Path> png, Optional<Path> pfm, Map<Aov, Path> aovs) {

  /** Returns the paths of a scene's files. */
  static OutputFiles of(String scene, RenderOptions options) {
    Map<Aov, Path> aovs = new EnumMap<>(Aov.class);
    for (Aov aov : options.aovs) {
      aovs.put(aov, options.out.resolve(name(scene, aov)));
    }
    Path png = options.png() ? options.out.resolve(scene + ".png") : null;
    Path pfm = options.pfm() ? options.out.resolve(scene + ".pfm") : null;
    return new OutputFiles(Optional.ofNullable(png), Optional.ofNullable(pfm), aovs);
  }

  /** Returns the names of a scene's files, which need not be paths that this system can express. */
  static List<String> names(String scene, RenderOptions options) {
    List<String> names = new ArrayList<>();
    if (options.png()) {
      names.add(scene + ".png");
    }
    if (options.pfm()) {
      names.add(scene + ".pfm");
    }
    options.aovs.forEach(aov -> names.add(name(scene, aov)));
    return names;
  }

  /** Returns the PFM files. */
  List<Path> pfms() {
    List<Path> all = new ArrayList<>(aovs.values());
    pfm.ifPresent(all::add);
    return all;
  }

  /** Returns all files, the picture for people first. */
  List<Path> all() {
    List<Path> all = new ArrayList<>();
    png.ifPresent(all::add);
    pfm.ifPresent(all::add);
    all.addAll(aovs.values());
    return all;
  }

  private static String name(String scene, Aov aov) {
    return scene + "." + aov.name().toLowerCase(Locale.ROOT) + ".pfm";
  }
}
