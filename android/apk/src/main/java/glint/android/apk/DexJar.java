package glint.android.apk;

import com.googlecode.d2j.Method;
import com.googlecode.d2j.dex.Dex2jar;
import com.googlecode.d2j.dex.DexExceptionHandler;
import com.googlecode.d2j.node.DexMethodNode;
import com.googlecode.d2j.reader.MultiDexFileReader;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Enumeration;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/** Translates the dex of a package back into class files. */
final class DexJar {

  private DexJar() {}

  /**
   * Translates all of it.
   *
   * @throws IOException if a file cannot be read or written
   * @throws IllegalStateException if a class or method cannot be translated
   */
  static void translate(Path apk, Path jar) throws IOException {
    Path rough = Files.createTempFile("glint-dex", ".jar");
    Files.delete(rough);
    OwnConstructors dex = new OwnConstructors(MultiDexFileReader.open(Files.readAllBytes(apk)));
    Dex2jar.from(dex).dontSanitizeNames(true).withExceptionHandler(new Failing()).to(rough);
    try (ZipFile classes = new ZipFile(rough.toFile())) {
      correct(classes, dex, jar);
    } finally {
      Files.delete(rough);
    }
  }

  /** Adds what class files must say and dex does not. */
  private static void correct(ZipFile classes, OwnConstructors dex, Path jar) throws IOException {
    Set<String> interfaces = new HashSet<>();
    List<ClassReader> readers = new ArrayList<>();
    for (Enumeration<? extends ZipEntry> e = classes.entries(); e.hasMoreElements(); ) {
      ZipEntry entry = e.nextElement();
      if (entry.getName().endsWith(".class")) {
        try (InputStream in = classes.getInputStream(entry)) {
          ClassReader reader = new ClassReader(in);
          readers.add(reader);
          if ((reader.getAccess() & Opcodes.ACC_INTERFACE) != 0) {
            interfaces.add(reader.getClassName());
          }
        }
      }
    }
    try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(jar))) {
      for (ClassReader reader : readers) {
        ClassWriter writer = new ClassWriter(0);
        reader.accept(new Corrected(writer, interfaces, dex), 0);
        out.putNextEntry(new ZipEntry(reader.getClassName() + ".class"));
        out.write(writer.toByteArray());
        out.closeEntry();
      }
    }
  }

  /** Nothing may be left out. */
  private static final class Failing implements DexExceptionHandler {
    @Override
    public void handleFileException(Exception e) {
      throw new IllegalStateException("the dex cannot be translated", e);
    }

    @Override
    public void handleMethodTranslateException(
        Method method, DexMethodNode node, MethodVisitor visitor, Exception e) {
      throw new IllegalStateException("cannot be translated: " + method, e);
    }
  }

  private static final class Corrected extends ClassVisitor {
    private final Set<String> interfaces;
    private final OwnConstructors dex;
    private String name;

    Corrected(ClassVisitor next, Set<String> interfaces, OwnConstructors dex) {
      super(Opcodes.ASM9, next);
      this.interfaces = interfaces;
      this.dex = dex;
    }

    @Override
    public void visit(
        int version, int access, String className, String signature, String parent, String[] all) {
      name = className;
      super.visit(version, access, className, signature, parent, all);
    }

    /** Adds the constructors that only call their parents'. */
    @Override
    public void visitEnd() {
      dex.lacking(name).forEach(this::addConstructor);
      super.visitEnd();
    }

    private void addConstructor(String type, String parent) {
      MethodVisitor code = super.visitMethod(Opcodes.ACC_PUBLIC, "<init>", type, null, null);
      code.visitCode();
      code.visitVarInsn(Opcodes.ALOAD, 0);
      int slot = 1;
      for (Type argument : Type.getArgumentTypes(type)) {
        code.visitVarInsn(argument.getOpcode(Opcodes.ILOAD), slot);
        slot += argument.getSize();
      }
      code.visitMethodInsn(Opcodes.INVOKESPECIAL, parent, "<init>", type, false);
      code.visitInsn(Opcodes.RETURN);
      code.visitMaxs(slot, slot);
      code.visitEnd();
    }

    /** Says of every call whether it is to an interface, which dex does not for static ones. */
    @Override
    public MethodVisitor visitMethod(
        int access, String method, String type, String signature, String[] exceptions) {
      MethodVisitor next = super.visitMethod(access, method, type, signature, exceptions);
      return new MethodVisitor(Opcodes.ASM9, next) {
        @Override
        public void visitMethodInsn(
            int opcode, String owner, String called, String callType, boolean itf) {
          boolean toInterface = itf || interfaces.contains(owner) || isOfJava(owner);
          super.visitMethodInsn(opcode, owner, called, callType, toInterface);
        }
      };
    }

    /** Returns whether a class is an interface of the Java machine. */
    private static boolean isOfJava(String owner) {
      try {
        return owner.startsWith("java/")
            && Class.forName(owner.replace('/', '.'), false, null).isInterface();
      } catch (ClassNotFoundException e) {
        return false; // Android has it, and this Java has not
      }
    }
  }
}
