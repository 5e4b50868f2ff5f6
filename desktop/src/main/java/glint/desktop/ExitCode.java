package glint.desktop;

/** What the process tells whoever started it. */
final class ExitCode {

  /** All is done. */
  static final int DONE = 0;

  /** Something in the input or in the run failed. */
  static final int FAILED = 1;

  /** The command was not understood. */
  static final int USAGE = 2;

  /** A signal ended the run. */
  static final int INTERRUPTED = 130;

  private ExitCode() {}
}
