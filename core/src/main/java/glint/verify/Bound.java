package glint.verify;

/** The most that an error may be, and what it is measured in. */
record Bound(double most, String unit) {}
