package glint.android.apk;

/** Placeholder. */
final class Timing {
  private Timing() {}
}
