package glint.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.image.Image;
import glint.math.Vector3d;
import glint.scene.Camera;
import glint.scene.Orthographic;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.util.Arrays;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** What goes on around pixels. */
class SurveyTest {

  @Property(tries = 200)
  void edgesAroundAPixelAreCountedAnew(
      @ForAll @IntRange(min = 1, max = 8) int width,
      @ForAll @IntRange(min = 1, max = 8) int height,
      @ForAll long seed) {
    Random random = new Random(seed);
    Film film = new Film(new Image(width, height));
    Survey survey = new Survey(film, new CornerGrid(width, height, false, false), null, null, null);
    for (int pixel = 0; pixel < film.kind.length; pixel++) {
      film.kind[pixel] = (byte) random.nextInt(3);
    }
    count(survey, film);
    int x = random.nextInt(width);
    int y = random.nextInt(height);
    film.kind[y * width + x] = Film.BUSY;
    for (int row = Math.max(0, y - 1); row <= Math.min(height - 1, y + 1); row++) {
      survey.count(row, Math.max(0, x - 1), Math.min(width, x + 2));
    }
    byte[] around = film.surroundings.clone();
    count(new Survey(film, new CornerGrid(width, height, false, false), null, null, null), film);
    assertArrayEquals(film.surroundings, around);
  }

  private static void count(Survey survey, Film film) {
    for (int y = 0; y < film.height; y++) {
      survey.count(y, 0, film.width);
    }
  }

  /** A row of three: none, one or two, three or four and more are told apart, of either kind. */
  @Property(tries = 200)
  void surroundingsGradeBothKinds(@ForAll @IntRange(max = 8) int busy, @ForAll long seed) {
    Random random = new Random(seed);
    Film film = new Film(new Image(3, 3));
    int split = random.nextInt(9 - busy);
    for (int i = 0; i < busy + split; i++) {
      int pixel = i < 4 ? i : i + 1; // all but the middle
      film.kind[pixel] = i < busy ? Film.BUSY : Film.SPLIT;
    }
    film.kind[4] = Film.SPLIT;
    count(new Survey(film, new CornerGrid(3, 3, false, false), null, null, null), film);
    int[] grades = {0, 1, 1, 2, 2, 3, 3, 3, 3};
    assertEquals(4 * grades[busy] + grades[split], film.surroundings[4]);
  }

  /** What no corner shows is found in every split pixel, and in smooth ones in a crowd of edges. */
  @Property(tries = 200)
  void middlesAreLookedAtWhereEdgesAre(@ForAll @IntRange(max = 8) int busy, @ForAll long seed) {
    Random random = new Random(seed);
    int split = random.nextInt(9 - busy);
    Film film = new Film(new Image(3, 3));
    for (int i = 0; i < busy + split; i++) {
      film.kind[i < 4 ? i : i + 1] = i < busy ? Film.BUSY : Film.SPLIT; // all but the middle
    }
    Camera camera =
        Camera.of(new Vector3d(0, 0, 9), Vector3d.ZERO, new Vector3d(0, 1, 0), new Orthographic(3));
    Scene empty = new Scene.Builder("empty").size(3, 3).camera(camera).build();
    RenderSettings settings =
        new RenderSettings(3, 3, new Goal.Error(1), 0, OptionalInt.empty(), 1, 8, Set.of());
    CornerGrid corners = new CornerGrid(3, 3, false, false);
    Arrays.fill(corners.signature, 1);
    Survey survey =
        new Survey(
            film, corners, new Brackets(corners, 0), null, new Probe(Prepared.of(empty), settings));
    count(survey, film);
    assertEquals(busy > 0 || split > 4, survey.surprises(4));
    film.kind[4] = Film.SPLIT;
    film.checked[4] = false;
    assertTrue(survey.surprises(4));
    assertFalse(survey.surprises(4));
    assertEquals(Film.BUSY, film.kind[4]);
  }
}
