package glint.android.apk;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.googlecode.d2j.Method;
import com.googlecode.d2j.reader.MultiDexFileReader;
import com.googlecode.d2j.reader.Op;
import com.googlecode.d2j.visitors.DexClassVisitor;
import com.googlecode.d2j.visitors.DexCodeVisitor;
import com.googlecode.d2j.visitors.DexFileVisitor;
import com.googlecode.d2j.visitors.DexMethodVisitor;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * The app calls what it calls by name: nothing is looked up at run time, so that the check against
 * Android's public signatures sees every call.
 */
class PlainCallsTest {

  private static final Set<String> LOOK_UPS =
      Set.of(
          "forName",
          "newInstance",
          "getMethod",
          "getMethods",
          "getDeclaredMethod",
          "getDeclaredMethods",
          "getField",
          "getFields",
          "getDeclaredField",
          "getDeclaredFields",
          "getConstructor",
          "getConstructors",
          "getDeclaredConstructor",
          "getDeclaredConstructors",
          "getClassLoader");

  /** Makes arrays of arrays: what D8 makes of {@code new double[2][3]}. */
  private static final String ARRAY = "Ljava/lang/reflect/Array;";

  private final Set<String> found = new TreeSet<>();
  private int classes;

  @Test
  void nothingIsLookedUp() throws IOException {
    Path apk = Path.of(System.getProperty("glint.apk.debug"));
    MultiDexFileReader.open(Files.readAllBytes(apk)).accept(new Classes());
    assertTrue(classes > 300, "classes of Glint: " + classes);
    assertEquals(Set.of(), found);
  }

  private static boolean looksUp(Method called) {
    String owner = called.getOwner();
    boolean reflects = owner.startsWith("Ljava/lang/reflect/") && !owner.equals(ARRAY);
    return reflects
        || owner.startsWith("Ljava/lang/invoke/")
        || owner.startsWith("Ldalvik/")
        || (owner.equals("Ljava/lang/Class;") && LOOK_UPS.contains(called.getName()))
        || owner.equals("Ljava/lang/ClassLoader;");
  }

  private final class Classes extends DexFileVisitor {
    @Override
    public DexClassVisitor visit(int access, String name, String parent, String[] interfaces) {
      if (!name.startsWith("Lglint/")) {
        return null;
      }
      classes++;
      return new DexClassVisitor() {
        @Override
        public DexMethodVisitor visitMethod(int flags, Method method) {
          return new DexMethodVisitor() {
            @Override
            public DexCodeVisitor visitCode() {
              return new Calls(method);
            }
          };
        }
      };
    }
  }

  private final class Calls extends DexCodeVisitor {
    private final Method caller;

    Calls(Method caller) {
      this.caller = caller;
    }

    @Override
    public void visitMethodStmt(Op op, int[] registers, Method called) {
      if (looksUp(called)) {
        found.add(caller + " calls " + called);
      }
    }
  }
}
