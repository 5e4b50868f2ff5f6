package glint.io;

import glint.io.EarClipper.Outcome;
import java.util.Arrays;

/** Makes triangles of the faces of a model; a face may name points that come after it. */
final class ObjFaces {

  /** The most corners of one face. */
  static final int MOST_CORNERS = 1 << 26;

  private final ObjGeometry geometry;
  private final Triangulator triangulator = new Triangulator();

  private final ObjNote repeated = new ObjNote("a face repeats a corner, which is taken once");
  private final ObjNote lost =
      new ObjNote("a face needs three different corners: this one is left out");
  private final ObjNote crossed =
      new ObjNote("the edges of a face cross each other: its triangles may overlap");

  private int line;
  private int column;

  /** The numbers of the points, from 0, of the face that is being read. */
  private int[] polygon = new int[16];

  /** Line and column of each of its corners. */
  private int[] places = new int[32];

  private int size;
  private boolean ahead;

  /** Faces that name points still to come: size, line, column, and three numbers a corner. */
  private final Ints deferred = new Ints();

  /** The coordinates of the corners of a face that is divided. */
  private double[] spots = {};

  ObjFaces(ObjGeometry geometry) {
    this.geometry = geometry;
  }

  /** Begins a face whose statement stands there. */
  void begin(int atLine, int atColumn) {
    line = atLine;
    column = atColumn;
    size = 0;
    ahead = false;
  }

  /**
   * Adds a corner to the face.
   *
   * @param index from 1, or from -1 backwards
   * @throws BadObj if it goes back too far
   */
  void corner(int index, int atLine, int atColumn) {
    int count = geometry.pointCount();
    if (index < -count) {
      throw BadObj.noPoint(new Place(atLine, atColumn), index, count);
    }
    if (size == polygon.length) {
      if (size == MOST_CORNERS) {
        throw new BadObj(place(), "a face has up to " + MOST_CORNERS + " corners");
      }
      polygon = Arrays.copyOf(polygon, 2 * size);
      places = Arrays.copyOf(places, 4 * size);
    }
    polygon[size] = index > 0 ? index - 1 : count + index;
    places[2 * size] = atLine;
    places[2 * size + 1] = atColumn;
    ahead |= polygon[size] >= count;
    size++;
  }

  /**
   * Ends the face.
   *
   * @throws BadObj if it cannot be had
   */
  void end() {
    if (ahead) {
      defer();
    } else {
      add();
    }
  }

  private void defer() {
    deferred.add(size);
    deferred.add(line);
    deferred.add(column);
    for (int i = 0; i < size; i++) {
      deferred.add(polygon[i]);
      deferred.add(places[2 * i]);
      deferred.add(places[2 * i + 1]);
    }
  }

  /** Ends the model: adds what had to wait for its points. */
  void finish(Problems problems, Problems notes) {
    int at = 0;
    while (at < deferred.size()) {
      begin(deferred.get(at + 1), deferred.get(at + 2));
      int end = at + 3 + 3 * deferred.get(at);
      try {
        for (at += 3; at < end; at += 3) {
          takeUp(deferred.get(at), deferred.get(at + 1), deferred.get(at + 2));
        }
        add();
      } catch (BadObj e) {
        problems.report(e.place(), e.getMessage());
      }
      at = end;
    }
    repeated.report(notes);
    lost.report(notes);
    crossed.report(notes);
  }

  private void takeUp(int point, int atLine, int atColumn) {
    if (point >= geometry.pointCount()) {
      throw BadObj.noPoint(new Place(atLine, atColumn), point + 1, geometry.pointCount());
    }
    corner(point + 1, atLine, atColumn);
  }

  private Place place() {
    return new Place(line, column);
  }

  private void add() {
    if (geometry.hasFar()) {
      refuseFar();
    }
    dropRepeated();
    if (size < 3) {
      lost.at(place());
    } else if (size == 3) {
      geometry.triangle(polygon[0], polygon[1], polygon[2]);
    } else {
      divide();
    }
  }

  private void refuseFar() {
    for (int i = 0; i < size; i++) {
      if (geometry.isFar(polygon[i])) {
        throw new BadObj(
            new Place(places[2 * i], places[2 * i + 1]),
            "coordinates reach 1e100, but those of this corner do not");
      }
    }
  }

  /** Drops corners that repeat the one before, the first being the one after the last. */
  private void dropRepeated() {
    int kept = 0;
    for (int i = 0; i < size; i++) {
      if (kept == 0 || polygon[i] != polygon[kept - 1]) {
        polygon[kept++] = polygon[i];
      }
    }
    while (kept > 1 && polygon[kept - 1] == polygon[0]) {
      kept--;
    }
    if (kept < size) {
      repeated.at(place());
    }
    size = kept;
  }

  private void divide() {
    spots = spots.length < 3 * size ? new double[3 * polygon.length] : spots;
    for (int i = 0; i < 3 * size; i++) {
      spots[i] = geometry.coordinate(polygon[i / 3], i % 3);
    }
    Outcome outcome = triangulator.divide(spots, size);
    if (outcome == Outcome.GIVEN_UP) {
      throw new BadObj(place(), "this face is too intricate to be divided into triangles");
    }
    if (outcome == Outcome.CROSSED) {
      crossed.at(place());
    }
    for (int i = 0; i < 3 * (size - 2); i += 3) {
      int a = polygon[triangulator.corner(i)];
      int b = polygon[triangulator.corner(i + 1)];
      geometry.triangle(a, b, polygon[triangulator.corner(i + 2)]);
    }
  }
}
