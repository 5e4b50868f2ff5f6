package glint.android;

import android.content.Context;
import android.content.res.TypedArray;
import android.graphics.Bitmap;
import android.graphics.Canvas;
import android.graphics.Color;
import android.graphics.Paint;
import android.graphics.PointF;
import android.graphics.RectF;
import android.util.AttributeSet;
import android.view.SurfaceHolder;
import android.view.SurfaceView;

/** A surface that shows a bitmap as large as it can. */
public final class PictureView extends SurfaceView implements SurfaceHolder.Callback {

  private final Paint paint = new Paint(Paint.FILTER_BITMAP_FLAG);
  private final int background;
  private Bitmap bitmap;
  private boolean ready;

  /** Makes an empty one; layouts do. */
  public PictureView(Context context, AttributeSet attributes) {
    super(context, attributes);
    TypedArray colors = context.obtainStyledAttributes(new int[] {android.R.attr.colorBackground});
    background = colors.getColor(0, Color.BLACK);
    colors.recycle();
    getHolder().addCallback(this);
  }

  /** Shows a bitmap, which may have changed since it was shown last; nothing if it is null. */
  void show(Bitmap picture) {
    bitmap = picture;
    refresh();
  }

  /** Returns what is shown, or null. */
  Bitmap bitmap() {
    return bitmap;
  }

  private void refresh() {
    Canvas canvas = ready ? getHolder().lockCanvas() : null;
    if (canvas != null) {
      paint(canvas);
      getHolder().unlockCanvasAndPost(canvas);
    }
  }

  /** Paints all of the surface. */
  void paint(Canvas canvas) {
    canvas.drawColor(background);
    if (bitmap != null) {
      canvas.drawBitmap(bitmap, null, place(bitmap.getWidth(), bitmap.getHeight()), paint);
    }
  }

  /** Returns the place of a picture, in the middle and as large as fits. */
  private RectF place(int columns, int rows) {
    float scale = Math.min((float) getWidth() / columns, (float) getHeight() / rows);
    float left = (getWidth() - scale * columns) / 2;
    float top = (getHeight() - scale * rows) / 2;
    return new RectF(left, top, left + scale * columns, top + scale * rows);
  }

  /** Returns which place of a picture of so many columns and rows is at a place of the view. */
  PointF inPicture(float x, float y, int columns, int rows) {
    RectF place = place(columns, rows);
    return new PointF(
        (x - place.left) * columns / place.width(), (y - place.top) * rows / place.height());
  }

  @Override
  public void surfaceCreated(SurfaceHolder holder) {
    ready = true;
    refresh();
  }

  @Override
  public void surfaceChanged(SurfaceHolder holder, int format, int width, int height) {
    refresh();
  }

  @Override
  public void surfaceDestroyed(SurfaceHolder holder) {
    ready = false;
  }
}
