import org.objectweb.asm.AnnotationVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * Replaces a method's body, where it has one, by {@code throw new RuntimeException("Stub!")}; that
 * of a constructor calls the same other constructor first, with zeros and nulls, as any must.
 */
final class StubMethod extends MethodVisitor {
  private static final String THROWN = "java/lang/RuntimeException";
  private static final String CONSTRUCTOR = "<init>";
  private static final int STACK_TO_THROW = 3;

  private final MethodVisitor next;
  private final boolean constructor;
  private final String type;
  private final boolean body;

  private int made; // objects on whose own constructors the old instructions have yet to call
  private String callee; // the class whose constructor is called first
  private String calleeType;

  StubMethod(MethodVisitor next, String name, String type, boolean body) {
    super(Opcodes.ASM9); // without a next visitor: the old instructions go nowhere
    this.next = next;
    this.constructor = name.equals(CONSTRUCTOR);
    this.type = type;
    this.body = body;
  }

  @Override
  public AnnotationVisitor visitAnnotation(String annotation, boolean visible) {
    return AndroidPlatform.known(annotation) ? next.visitAnnotation(annotation, visible) : null;
  }

  @Override
  public AnnotationVisitor visitAnnotationDefault() {
    return next.visitAnnotationDefault();
  }

  @Override
  public void visitParameter(String name, int access) {
    next.visitParameter(name, access);
  }

  @Override
  public void visitTypeInsn(int opcode, String owner) {
    made += opcode == Opcodes.NEW ? 1 : 0;
  }

  @Override
  public void visitMethodInsn(int opcode, String owner, String name, String callType, boolean itf) {
    if (!constructor || callee != null || !name.equals(CONSTRUCTOR)) {
      return;
    }
    if (made > 0) {
      made--;
    } else {
      callee = owner;
      calleeType = callType;
    }
  }

  @Override
  public void visitEnd() {
    if (body) {
      next.visitCode();
      int stack = Math.max(STACK_TO_THROW, callee == null ? 0 : callFirst());
      next.visitTypeInsn(Opcodes.NEW, THROWN);
      next.visitInsn(Opcodes.DUP);
      next.visitLdcInsn("Stub!");
      next.visitMethodInsn(
          Opcodes.INVOKESPECIAL, THROWN, CONSTRUCTOR, "(Ljava/lang/String;)V", false);
      next.visitInsn(Opcodes.ATHROW);
      next.visitMaxs(stack, Type.getArgumentsAndReturnSizes(type) >> 2);
    }
    next.visitEnd();
  }

  /** Calls the other constructor; returns how much of the stack that takes. */
  private int callFirst() {
    next.visitVarInsn(Opcodes.ALOAD, 0);
    for (Type argument : Type.getArgumentTypes(calleeType)) {
      next.visitInsn(zero(argument));
    }
    next.visitMethodInsn(Opcodes.INVOKESPECIAL, callee, CONSTRUCTOR, calleeType, false);
    return Type.getArgumentsAndReturnSizes(calleeType) >> 2;
  }

  private static int zero(Type type) {
    return switch (type.getSort()) {
      case Type.LONG -> Opcodes.LCONST_0;
      case Type.DOUBLE -> Opcodes.DCONST_0;
      case Type.FLOAT -> Opcodes.FCONST_0;
      case Type.OBJECT, Type.ARRAY -> Opcodes.ACONST_NULL;
      default -> Opcodes.ICONST_0;
    };
  }
}
