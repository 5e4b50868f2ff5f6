package glint.models.shape;

import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;

/** Sheets with two parameters. */
public final class Patch {

  /** A point of a sheet for two numbers from 0 to 1. */
  @FunctionalInterface
  public interface Point {
    /** Returns the point at (u, v); outside is where u × v points. */
    Vector3d at(double u, double v);
  }

  private Patch() {}

  /** Returns the sheet in so many steps either way. */
  public static Shape of(int across, int up, Point point) {
    List<List<Vector3d>> rows = new ArrayList<>();
    for (int j = 0; j <= up; j++) {
      List<Vector3d> row = new ArrayList<>();
      for (int i = 0; i <= across; i++) {
        row.add(point.at((double) i / across, (double) j / up));
      }
      rows.add(row);
    }
    return Loft.sheet(rows);
  }
}
