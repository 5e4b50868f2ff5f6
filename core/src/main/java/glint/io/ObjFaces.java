package glint.io;

import glint.io.EarClipper.Outcome;
import java.util.Arrays;

/** Makes triangles of the faces of a model; a face may name points that come after it. */
final class ObjFaces {

  /** The most corners of one face. */
  static final int MOST_CORNERS = 1 << 26;

  private static final String POINT = "point";
  private static final String TEXTURE = "texture point";
  private static final String NORMAL = "normal";

  /** How many numbers a corner has besides that of its point. */
  private static final int DETAILS = 4;

  /** How many numbers precede the corners of a deferred face. */
  private static final int HEAD = 5;

  private final ObjGeometry geometry;
  private final ObjParts parts;
  private final Triangulator triangulator = new Triangulator();

  private final ObjNote repeated = new ObjNote("a face repeats a corner, which is taken once");
  private final ObjNote lost =
      new ObjNote("a face needs three different corners: this one is left out");
  private final ObjNote crossed =
      new ObjNote("the edges of a face cross each other: its triangles may overlap");

  private final ObjNote stripped =
      new ObjNote("a corner names a texture point or normal, but the model has none");

  private int line;
  private int column;
  private int group;

  /** The numbers of the points, from 0, of the face that is being read. */
  private int[] polygon = new int[16];

  /** Line, column, texture point and normal of each of its corners, these from 0, or -1. */
  private int[] details = new int[DETAILS * 16];

  private int size;
  private boolean ahead;

  /** Faces that name what is still to come: size, line, column, group, material and corners. */
  private final Ints deferred = new Ints();

  /** The coordinates of the corners of a face that is divided. */
  private double[] spots = {};

  ObjFaces(ObjGeometry geometry, ObjParts parts) {
    this.geometry = geometry;
    this.parts = parts;
  }

  /** Puts the faces from here on into a smoothing group, or into none: 0. */
  void smooth(int newGroup) {
    group = newGroup;
  }

  /** Begins a face whose statement stands there. */
  void begin(int atLine, int atColumn) {
    line = atLine;
    column = atColumn;
    size = 0;
    ahead = false;
  }

  /**
   * Adds a corner to the face; indices count from 1, or from -1 backwards.
   *
   * @param texture 0 for none
   * @param normal 0 for none
   * @throws BadObj if one goes back too far
   */
  void corner(int index, int texture, int normal, int atLine, int atColumn) {
    if (size == polygon.length) {
      if (size == MOST_CORNERS) {
        throw new BadObj(place(), "a face has up to " + MOST_CORNERS + " corners");
      }
      polygon = Arrays.copyOf(polygon, 2 * size);
      details = Arrays.copyOf(details, 2 * DETAILS * size);
    }
    int at = DETAILS * size;
    details[at] = atLine;
    details[at + 1] = atColumn;
    polygon[size] = number(POINT, index, geometry.pointCount());
    details[at + 2] = texture == 0 ? -1 : number(TEXTURE, texture, geometry.textures.count());
    details[at + 3] = normal == 0 ? -1 : number(NORMAL, normal, geometry.normals.count());
    size++;
  }

  /** Returns the number, from 0, that an index of the last corner is for. */
  private int number(String noun, int index, int count) {
    if (index < -count) {
      throw BadObj.none(cornerPlace(size), noun, index, count);
    }
    ahead |= index > count;
    return index > 0 ? index - 1 : count + index;
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
      add(group, parts.current());
    }
  }

  private void defer() {
    deferred.add(size);
    deferred.add(line);
    deferred.add(column);
    deferred.add(group);
    deferred.add(parts.current());
    for (int i = 0; i < size; i++) {
      deferred.add(polygon[i]);
      for (int k = 0; k < DETAILS; k++) {
        deferred.add(details[DETAILS * i + k]);
      }
    }
  }

  /** Ends the model: adds what had to wait for its points. */
  void finish(Problems problems, Problems notes) {
    int at = 0;
    while (at < deferred.size()) {
      begin(deferred.get(at + 1), deferred.get(at + 2));
      int itsGroup = deferred.get(at + 3);
      int itsMaterial = deferred.get(at + 4);
      size = deferred.get(at);
      at += HEAD;
      for (int i = 0; i < size; i++) {
        polygon[i] = deferred.get(at++);
        for (int k = 0; k < DETAILS; k++) {
          details[DETAILS * i + k] = deferred.get(at++);
        }
      }
      try {
        requireAll();
        add(itsGroup, itsMaterial);
      } catch (BadObj e) {
        problems.report(e.place(), e.getMessage());
      }
    }
    repeated.report(notes);
    lost.report(notes);
    crossed.report(notes);
    stripped.report(notes);
  }

  private void requireAll() {
    for (int i = 0; i < size; i++) {
      int at = DETAILS * i;
      requireOne(i, POINT, polygon[i], geometry.pointCount());
      details[at + 2] = detail(i, TEXTURE, details[at + 2], geometry.textures.count());
      details[at + 3] = detail(i, NORMAL, details[at + 3], geometry.normals.count());
    }
  }

  /** Returns the number of what a corner has, or -1 where the whole model has none. */
  private int detail(int corner, String noun, int number, int count) {
    if (count == 0 && number >= 0) {
      stripped.at(cornerPlace(corner));
      return -1;
    }
    requireOne(corner, noun, number, count);
    return number;
  }

  private void requireOne(int corner, String noun, int number, int count) {
    if (number >= count) {
      throw BadObj.none(cornerPlace(corner), noun, number + 1, count);
    }
  }

  private Place cornerPlace(int corner) {
    return new Place(details[DETAILS * corner], details[DETAILS * corner + 1]);
  }

  private Place place() {
    return new Place(line, column);
  }

  private void add(int ofGroup, int ofMaterial) {
    if (geometry.hasFar()) {
      refuseFar();
    }
    dropRepeated();
    if (size < 3) {
      lost.at(place());
      return;
    }
    parts.begin(geometry.triangleCount(), ofMaterial);
    if (size == 3) {
      triangle(0, 1, 2, ofGroup);
    } else {
      divide(ofGroup);
    }
  }

  private void refuseFar() {
    for (int i = 0; i < size; i++) {
      if (geometry.isFar(polygon[i])) {
        throw new BadObj(
            cornerPlace(i), "coordinates reach 1e100, but those of this corner do not");
      }
    }
  }

  /** Drops corners that repeat the one before, the first being the one after the last. */
  private void dropRepeated() {
    int kept = 0;
    for (int i = 0; i < size; i++) {
      if (kept == 0 || polygon[i] != polygon[kept - 1]) {
        System.arraycopy(details, DETAILS * i, details, DETAILS * kept, DETAILS);
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

  private void divide(int ofGroup) {
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
      int c = triangulator.corner(i + 2);
      triangle(triangulator.corner(i), triangulator.corner(i + 1), c, ofGroup);
    }
  }

  /** Adds a triangle of three of the face's corners. */
  private void triangle(int a, int b, int c, int ofGroup) {
    int number = geometry.triangleCount();
    geometry.triangle(polygon[a], polygon[b], polygon[c], ofGroup);
    int first = DETAILS * a;
    int second = DETAILS * b;
    int third = DETAILS * c;
    geometry.textures.triangle(number, details[first + 2], details[second + 2], details[third + 2]);
    geometry.normals.triangle(number, details[first + 3], details[second + 3], details[third + 3]);
  }
}
