package glint.desktop;

/** Something in the input or in the run failed; the message is one line for people. */
final class RunException extends Exception {

  private static final long serialVersionUID = 1;

  RunException(String message) {
    super(message);
  }

  RunException(String message, Throwable cause) {
    super(message, cause);
  }
}
