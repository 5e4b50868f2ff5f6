package glint.desktop.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class ZoomTest {

  @Test
  void whatFitsTouchesTwoBordersAndLiesInTheMiddle() {
    assertEquals(new Zoom(2, 50, 0), Zoom.fit(100, 50, 300, 100));
    assertEquals(new Zoom(0.5, 0, 25), Zoom.fit(200, 100, 100, 100));
  }

  @Test
  void thePlaceUnderThePointerStays() {
    Zoom zoom = new Zoom(2, 10, 20);
    Zoom larger = zoom.about(4, 30, 60);
    assertEquals(new Zoom(8, -50, -100), larger);
    assertEquals(10, larger.column(30));
    assertEquals(20, larger.row(60));
    assertEquals(zoom, larger.about(0.25, 30, 60));
  }

  @Test
  void zoomingEndsSomewhere() {
    assertEquals(64, new Zoom(1, 0, 0).about(1e9, 5, 5).scale());
    assertEquals(1.0 / 64, new Zoom(1, 0, 0).about(1e-9, 5, 5).scale());
  }

  @Test
  void aPixelReachesFromItsLeftBorderToTheNext() {
    Zoom zoom = new Zoom(4, 100, 50).moved(1, 2);
    assertEquals(-1, zoom.column(100.9));
    assertEquals(0, zoom.column(101));
    assertEquals(0, zoom.column(104.9));
    assertEquals(1, zoom.column(105));
    assertEquals(1, zoom.row(56));
  }
}
