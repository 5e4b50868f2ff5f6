package glint.desktop;

import java.io.EOFException;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import javax.imageio.IIOException;

/** Says in one line for people what went wrong. */
final class Reasons {

  private Reasons() {}

  /** Returns the reason of a failure, in one line, without the file's name. */
  static String of(Throwable failure) {
    Throwable cause = failure;
    while (isWrapper(cause) && cause.getCause() != null) {
      cause = cause.getCause();
    }
    String reason = reason(cause);
    if (reason == null || reason.isBlank()) {
      reason = "internal error: " + cause.getClass().getSimpleName();
    }
    return reason.replaceAll("\\s*\\R\\s*", " ");
  }

  /** Returns the reason of a failure after the name of the file that it is about. */
  static String of(Object file, IOException failure) {
    return file + ": " + of(failure);
  }

  /** Prints where in the code a failure arose, if the environment says GLINT_DEBUG=1. */
  static void trace(Throwable failure, PrintWriter err) {
    if ("1".equals(System.getenv("GLINT_DEBUG"))) {
      failure.printStackTrace(err);
    }
  }

  /** Of a tile's failure the renderer makes one of its own, and ImageIO of a full disk. */
  private static boolean isWrapper(Throwable failure) {
    return failure instanceof IllegalStateException || failure instanceof IIOException;
  }

  private static String reason(Throwable cause) {
    if (cause instanceof NoSuchFileException) {
      return "no such file or folder";
    } else if (cause instanceof AccessDeniedException) {
      return "permission denied";
    } else if (cause instanceof FileAlreadyExistsException) {
      return "a file of this name is in the way";
    } else if (cause instanceof FileSystemException e && e.getReason() != null) {
      return e.getReason();
    } else if (cause instanceof InvalidPathException e) {
      return "'" + e.getInput() + "' cannot be a file's name here; LC_ALL=C.UTF-8 may help";
    } else if (cause instanceof EOFException) {
      return "ends too early";
    } else if (cause instanceof OutOfMemoryError) {
      return Memory.usedUp();
    } else if (cause instanceof StackOverflowError) {
      return "nested too deeply";
    }
    return cause.getMessage();
  }
}
