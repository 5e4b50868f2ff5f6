import java.io.BufferedOutputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.commons.ClassRemapper;
import org.objectweb.asm.commons.Remapper;

/**
 * Lays out the lib folder of a Gradle distribution from {@code dev.gradleplugins:gradle-api}, the
 * one Maven artifact that holds all of Gradle's classes.
 *
 * <p>These are Gradle's own class files as released, save that its libraries were renamed to {@code
 * org.gradle.internal.impldep.*}. This takes the renaming back and writes the manifests by which
 * Gradle finds its modules. Missing, because the artifact has none of it: the Kotlin DSL, the
 * instrumentation agent and the incremental-compile plugin of javac.
 */
public final class GradleDistribution {
  private static final String RENAMED = "org.gradle.internal.impldep.";
  private static final String RENAMED_PATH = RENAMED.replace('.', '/');
  private static final String SERVICES = "META-INF/services/";
  private static final String MANIFEST = "META-INF/MANIFEST.MF";
  private static final String MODULE = "-classpath.properties";

  /** Test frameworks have jars of their own: a project's test process must not see them. */
  private static final Map<String, String> JAR_OF_PACKAGE =
      Map.of(
          "org/junit/platform/", "junit-platform-launcher-1.8.2.jar",
          "org/opentest4j/", "opentest4j-1.3.0.jar",
          "org/junit/", "junit-4.13.2.jar",
          "junit/", "junit-4.13.2.jar",
          "org/hamcrest/", "hamcrest-core-1.3.jar",
          "org/testng/", "testng-6.3.1.jar",
          "com/beust/", "testng-6.3.1.jar",
          "bsh/", "testng-6.3.1.jar");

  private static final Remapper NAME_BACK =
      new Remapper() {
        @Override
        public String map(String name) {
          return name.startsWith(RENAMED_PATH) ? name.substring(RENAMED_PATH.length()) : name;
        }

        @Override
        public Object mapValue(Object value) {
          return value instanceof String text ? nameBack(text) : super.mapValue(value);
        }
      };

  private final Path lib;
  private final String version;
  private final String core;
  private final Map<String, ZipOutputStream> jars = new TreeMap<>();
  private final Set<String> entries = new HashSet<>();
  private final Map<String, Properties> modules = new TreeMap<>();
  private final Map<String, String> services = new TreeMap<>();

  private GradleDistribution(Path lib, String version) {
    this.lib = lib;
    this.version = version;
    this.core = "gradle-core-" + version + ".jar";
  }

  /**
   * Fills a lib folder.
   *
   * @param args gradle-api.jar; the lib folder, which holds the groovy, kotlin and ant jars
   *     already; Gradle's version
   */
  public static void main(String[] args) throws IOException {
    GradleDistribution distribution = new GradleDistribution(Path.of(args[1]), args[2]);
    Files.createDirectories(distribution.lib.resolve("plugins"));
    try (ZipFile api = new ZipFile(args[0])) {
      for (ZipEntry entry : Collections.list(api.entries())) {
        if (!entry.isDirectory() && wanted(entry.getName())) {
          try (InputStream in = api.getInputStream(entry)) {
            distribution.add(entry.getName(), in.readAllBytes());
          }
        }
      }
    }
    distribution.addServices();
    distribution.addModules();
  }

  private static boolean wanted(String name) {
    return !name.equals(MANIFEST)
        && !name.equals("META-INF/.gradle-runtime-shaded")
        && !name.startsWith(SERVICES + "java")
        && !name.endsWith("module-info.class");
  }

  private static String nameBack(String text) {
    return text.replace(RENAMED_PATH, "").replace(RENAMED, "");
  }

  private void add(String name, byte[] bytes) throws IOException {
    if (name.endsWith(MODULE) && name.indexOf('/') < 0) {
      Properties module = new Properties();
      module.load(new ByteArrayInputStream(bytes));
      modules.put(name.substring(0, name.length() - MODULE.length()), module);
    } else if (name.startsWith(SERVICES)) {
      // both names may stand in the artifact: one service file names the providers of both
      String providers = nameBack(new String(bytes, StandardCharsets.UTF_8)) + "\n";
      services.merge(nameBack(name), providers, String::concat);
    } else {
      String plain = NAME_BACK.map(name);
      if (entries.add(plain)) {
        put(jar(jarOf(plain)), plain, name.endsWith(".class") ? nameBack(bytes) : bytes);
      }
    }
  }

  private static byte[] nameBack(byte[] classFile) {
    ClassWriter writer = new ClassWriter(0);
    new ClassReader(classFile).accept(new ClassRemapper(writer, NAME_BACK), 0);
    return writer.toByteArray();
  }

  /** The jar of the longest prefix that {@code name} has; all of Gradle itself is in its core. */
  private String jarOf(String name) {
    return JAR_OF_PACKAGE.keySet().stream()
        .filter(name::startsWith)
        .max((a, b) -> Integer.compare(a.length(), b.length()))
        .map(JAR_OF_PACKAGE::get)
        .orElse(core);
  }

  private ZipOutputStream jar(String name) throws IOException {
    ZipOutputStream jar = jars.get(name);
    if (jar == null) {
      jar = open(name);
      jar.setLevel(1); // the jars are read once and then cached by Gradle: speed, not size
      jars.put(name, jar);
    }
    return jar;
  }

  private ZipOutputStream open(String name) throws IOException {
    return new ZipOutputStream(
        new BufferedOutputStream(Files.newOutputStream(lib.resolve(name)), 1 << 16));
  }

  private void addServices() throws IOException {
    for (Map.Entry<String, String> service : services.entrySet()) {
      String jar = service.getKey().contains("org.junit") ? "org/junit/platform/" : "";
      put(jar(jarOf(jar)), service.getKey(), service.getValue());
    }
  }

  /** Every module and library but the core is an empty jar whose name leads to the core. */
  private void addModules() throws IOException {
    String noKotlin = "kotlin=none\nprovided-plugins=none\n";
    put(jar(core), "gradle-kotlin-dsl-versions.properties", noKotlin);
    put(jar(core), "gradle-core" + MODULE, "projects=\nruntime=" + libraries() + "\n");
    modules.remove("gradle-core");
    Set<String> names = new TreeSet<>();
    for (Map.Entry<String, Properties> module : modules.entrySet()) {
      String name = module.getKey();
      stub(name, name + "-" + version + ".jar", "gradle-core");
      Collections.addAll(names, module.getValue().getProperty("runtime", "").split(","));
    }
    String agent = "gradle-instrumentation-agent";
    stub(agent, agent + "-" + version + ".jar", "");
    for (ZipOutputStream jar : jars.values()) {
      jar.close();
    }
    for (String name : names) {
      if (name.endsWith(".jar") && Files.notExists(lib.resolve(name))) {
        stub("none", name, "");
      }
    }
  }

  private String libraries() throws IOException {
    try (Stream<Path> files = Files.list(lib)) {
      List<String> names =
          files
              .map(file -> file.getFileName().toString())
              .filter(name -> name.matches("(groovy|kotlin|ant|annotations).*\\.jar"))
              .sorted()
              .collect(Collectors.toList());
      return String.join(",", names);
    }
  }

  private void stub(String module, String jar, String projects) throws IOException {
    try (ZipOutputStream out = open(jar)) {
      put(out, MANIFEST, "Manifest-Version: 1.0\r\nClass-Path: " + core + "\r\n\r\n");
      put(out, module + MODULE, "projects=" + projects + "\nruntime=\n");
    }
  }

  private static void put(ZipOutputStream out, String name, String text) throws IOException {
    put(out, name, text.getBytes(StandardCharsets.UTF_8));
  }

  private static void put(ZipOutputStream out, String name, byte[] bytes) throws IOException {
    out.putNextEntry(new ZipEntry(name));
    out.write(bytes);
    out.closeEntry();
  }
}
