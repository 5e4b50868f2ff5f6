package glint.android.apk;

import com.googlecode.d2j.Method;
import com.googlecode.d2j.reader.BaseDexFileReader;
import com.googlecode.d2j.reader.Op;
import com.googlecode.d2j.visitors.DexClassVisitor;
import com.googlecode.d2j.visitors.DexCodeVisitor;
import com.googlecode.d2j.visitors.DexFileVisitor;
import com.googlecode.d2j.visitors.DexMethodVisitor;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads a dex as if every object were begun by a constructor of its own class.
 *
 * <p>R8 leaves out constructors that only call their parents': in dex, an object may be begun by
 * its parent's. In class files it may not.
 */
final class OwnConstructors implements BaseDexFileReader {

  private static final String CONSTRUCTOR = "<init>";

  /** Of a class, by its descriptor: the constructors it lacks, and whose are called instead. */
  private final Map<String, Map<String, String>> lacking = new HashMap<>();

  /** The descriptors of classes' parents. */
  private final Map<String, String> parents = new HashMap<>();

  private final BaseDexFileReader dex;

  OwnConstructors(BaseDexFileReader dex) {
    this.dex = dex;
    dex.accept(
        new DexFileVisitor() {
          @Override
          public DexClassVisitor visit(int access, String name, String parent, String[] all) {
            parents.put(name, parent);
            return null;
          }
        });
  }

  private boolean isAncestor(String name, String of) {
    String parent = parents.get(of);
    return parent != null && (parent.equals(name) || isAncestor(name, parent));
  }

  /** Returns the types of constructors that a class lacks, with the classes whose are called. */
  Map<String, String> lacking(String className) {
    return lacking.getOrDefault("L" + className + ";", Map.of());
  }

  @Override
  public int getDexVersion() {
    return dex.getDexVersion();
  }

  @Override
  public List<String> getClassNames() {
    return dex.getClassNames();
  }

  @Override
  public void accept(DexFileVisitor next) {
    dex.accept(new Classes(next));
  }

  @Override
  public void accept(DexFileVisitor next, int config) {
    dex.accept(new Classes(next), config);
  }

  @Override
  public void accept(DexFileVisitor next, int number, int config) {
    dex.accept(new Classes(next), number, config);
  }

  private final class Classes extends DexFileVisitor {
    Classes(DexFileVisitor next) {
      super(next);
    }

    @Override
    public DexClassVisitor visit(int access, String name, String parent, String[] interfaces) {
      DexClassVisitor next = super.visit(access, name, parent, interfaces);
      return new DexClassVisitor(next) {
        @Override
        public DexMethodVisitor visitMethod(int flags, Method method) {
          return new DexMethodVisitor(super.visitMethod(flags, method)) {
            @Override
            public DexCodeVisitor visitCode() {
              return new Code(super.visitCode());
            }
          };
        }
      };
    }
  }

  private final class Code extends DexCodeVisitor {
    /** The classes of objects that are made and not yet begun, by register. */
    private final Map<Integer, String> made = new HashMap<>();

    Code(DexCodeVisitor next) {
      super(next);
    }

    @Override
    public void visitTypeStmt(Op op, int to, int from, String type) {
      if (op == Op.NEW_INSTANCE) {
        made.put(to, type);
      }
      super.visitTypeStmt(op, to, from, type);
    }

    @Override
    public void visitMethodStmt(Op op, int[] registers, Method method) {
      String own = method.getName().equals(CONSTRUCTOR) ? made.remove(registers[0]) : null;
      String parent = method.getOwner();
      if (own != null && isAncestor(parent, own)) {
        lacking
            .computeIfAbsent(own, each -> new HashMap<>())
            .put(method.getDesc(), parent.substring(1, parent.length() - 1));
        super.visitMethodStmt(op, registers, new Method(own, CONSTRUCTOR, method.getProto()));
      } else {
        super.visitMethodStmt(op, registers, method);
      }
    }
  }
}
