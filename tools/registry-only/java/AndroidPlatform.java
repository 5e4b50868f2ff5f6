import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.objectweb.asm.AnnotationVisitor;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * Writes {@code android.jar} and {@code core-for-system-modules.jar} as an Android SDK has them:
 * signatures whose bodies throw, plus the framework's resources.
 *
 * <p>The framework comes from Robolectric's android-all, and java.* from java.base of the JDK that
 * runs this. So the jar shows hidden classes and newer methods than Android has: what the app may
 * call is checked elsewhere, against the signatures of its lowest API level.
 */
public final class AndroidPlatform {
  private static final int JAVA_17 = 61;
  private static final List<String> FRAMEWORK =
      List.of("android/", "dalvik/", "javax/", "org/", "com/android/internal/");

  private AndroidPlatform() {}

  /**
   * Writes the two jars.
   *
   * @param args android-all.jar; the platform's folder, which exists
   */
  public static void main(String[] args) throws IOException {
    Path platform = Path.of(args[1]);
    try (ZipFile framework = new ZipFile(args[0]);
        ZipOutputStream android = open(platform.resolve("android.jar"));
        ZipOutputStream core = open(platform.resolve("core-for-system-modules.jar"))) {
      Set<String> written = addJavaBase(android, core);
      for (ZipEntry entry : Collections.list(framework.entries())) {
        String name = entry.getName();
        if (wanted(name) && written.add(name)) {
          try (InputStream in = framework.getInputStream(entry)) {
            addFramework(android, name, in.readAllBytes());
          }
        }
      }
    }
  }

  private static boolean wanted(String name) {
    return name.equals("AndroidManifest.xml")
        || name.equals("resources.arsc")
        || (name.endsWith(".class") && FRAMEWORK.stream().anyMatch(name::startsWith));
  }

  private static void addFramework(ZipOutputStream android, String name, byte[] bytes)
      throws IOException {
    ZipEntry entry = new ZipEntry(name);
    if (name.equals("resources.arsc")) { // aapt2 maps it into memory, so it must not be deflated
      CRC32 crc = new CRC32();
      crc.update(bytes);
      entry.setMethod(ZipEntry.STORED);
      entry.setCrc(crc.getValue());
      entry.setSize(bytes.length);
    }
    put(android, entry, name.endsWith(".class") ? signatures(bytes) : bytes);
  }

  private static Set<String> addJavaBase(ZipOutputStream android, ZipOutputStream core)
      throws IOException {
    Path base = FileSystems.getFileSystem(URI.create("jrt:/")).getPath("/modules/java.base");
    Set<String> written = new HashSet<>();
    for (Path file : files(base)) {
      String name = base.relativize(file).toString();
      if (!name.endsWith(".class") || name.equals("module-info.class") || linked(name)) {
        continue;
      }
      byte[] bytes = signatures(Files.readAllBytes(file));
      put(core, new ZipEntry(name), bytes);
      if (name.startsWith("java/") || name.startsWith("javax/")) {
        written.add(name);
        put(android, new ZipEntry(name), bytes);
      }
    }
    return written;
  }

  /** Whether jlink generated the class when it made the JDK: it will do so again for the app. */
  private static boolean linked(String name) {
    String species = "java/lang/invoke/BoundMethodHandle$Species_";
    return name.startsWith(species) && !name.equals(species + "L.class");
  }

  private static List<Path> files(Path root) throws IOException {
    try (Stream<Path> paths = Files.walk(root)) {
      return paths.filter(Files::isRegularFile).sorted().collect(Collectors.toList());
    }
  }

  private static ZipOutputStream open(Path file) throws IOException {
    ZipOutputStream out =
        new ZipOutputStream(new BufferedOutputStream(Files.newOutputStream(file)));
    out.setLevel(1);
    return out;
  }

  private static void put(ZipOutputStream out, ZipEntry entry, byte[] bytes) throws IOException {
    out.putNextEntry(entry);
    out.write(bytes);
    out.closeEntry();
  }

  private static byte[] signatures(byte[] classFile) {
    ClassWriter writer = new ClassWriter(0);
    new ClassReader(classFile)
        .accept(new Signatures(writer), ClassReader.SKIP_DEBUG | ClassReader.SKIP_FRAMES);
    return writer.toByteArray();
  }

  /** Whether javac knows an annotation. */
  static boolean known(String annotation) {
    return annotation.startsWith("Ljava/lang/");
  }

  /** Keeps what other classes can name, and of the annotations those that javac knows. */
  private static final class Signatures extends ClassVisitor {
    Signatures(ClassVisitor next) {
      super(Opcodes.ASM9, next);
    }

    @Override
    public void visit(
        int version, int access, String name, String signature, String parent, String[] itfs) {
      super.visit(Math.min(version, JAVA_17), access, name, signature, parent, itfs);
    }

    @Override
    public void visitNestHost(String host) {}

    @Override
    public void visitNestMember(String member) {}

    @Override
    public AnnotationVisitor visitAnnotation(String annotation, boolean visible) {
      return known(annotation) ? super.visitAnnotation(annotation, visible) : null;
    }

    @Override
    public FieldVisitor visitField(
        int access, String name, String type, String signature, Object value) {
      if ((access & (Opcodes.ACC_PRIVATE | Opcodes.ACC_SYNTHETIC)) != 0) {
        return null;
      }
      FieldVisitor next = super.visitField(access, name, type, signature, value);
      return new FieldVisitor(Opcodes.ASM9, next) {
        @Override
        public AnnotationVisitor visitAnnotation(String annotation, boolean visible) {
          return known(annotation) ? super.visitAnnotation(annotation, visible) : null;
        }
      };
    }

    @Override
    public MethodVisitor visitMethod(
        int access, String name, String type, String signature, String[] exceptions) {
      boolean hidden = (access & Opcodes.ACC_PRIVATE) != 0 && !name.equals("<init>");
      if (name.equals("<clinit>") || hidden || (access & Opcodes.ACC_SYNTHETIC) != 0) {
        return null;
      }
      MethodVisitor next = super.visitMethod(access, name, type, signature, exceptions);
      boolean body = (access & (Opcodes.ACC_ABSTRACT | Opcodes.ACC_NATIVE)) == 0;
      return new StubMethod(next, name, type, body);
    }
  }
}
