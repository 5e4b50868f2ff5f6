package glint.models;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;

/** Writes the models of the scenes. */
public final class Main {

  private static final Map<String, Supplier<Model>> MODELS = new TreeMap<>();

  static {
    MODELS.put("astronaut", Astronaut::model);
    MODELS.put("candle", Candle::candle);
    MODELS.put("flame", Candle::flame);
    MODELS.put("house", Street::house);
    MODELS.put("lamp", Street::lamp);
    MODELS.put("limousine", Limousine::model);
    MODELS.put("petal", Rose::petal);
    MODELS.put("planet", Space::planet);
    MODELS.put("rain", Street::rain);
    MODELS.put("road", Street::road);
    MODELS.put("rock", Space::rock);
    MODELS.put("rose", Rose::rose);
    MODELS.put("ship", Ship::model);
    MODELS.put("sign", Street::sign);
    MODELS.put("skull", Skull::model);
    MODELS.put("slab", Crypt::slab);
    MODELS.put("stars", Space::stars);
    MODELS.put("wall", Crypt::wall);
  }

  private Main() {}

  /** Writes every model into the folder that is the first argument. */
  public static void main(String[] args) throws IOException {
    Path folder = Files.createDirectories(Path.of(args[0]));
    for (Map.Entry<String, String> file : files().entrySet()) {
      Files.writeString(folder.resolve(file.getKey()), file.getValue());
    }
  }

  /** Returns the texts of all files by their names. */
  static Map<String, String> files() {
    Map<String, String> files = new TreeMap<>();
    MODELS.forEach(
        (name, maker) -> {
          Model model = maker.get();
          files.put(name + ".obj", model.obj(name));
          if (!model.mtl().isEmpty()) {
            files.put(name + ".mtl", model.mtl());
          }
        });
    return files;
  }
}
