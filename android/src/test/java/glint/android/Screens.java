package glint.android;

import android.content.Context;
import android.net.Uri;
import org.robolectric.Robolectric;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;

/** Opens screens as a person does. */
final class Screens {

  private Screens() {}

  /** Opens a scene of a file under some settings; its render has begun. */
  static ActivityController<RenderActivity> open(Uri file, String scene, Settings settings) {
    Context context = RuntimeEnvironment.getApplication();
    settings.save(context);
    ActivityController<RenderActivity> controller =
        Robolectric.buildActivity(
            RenderActivity.class, RenderActivity.intent(context, file, scene));
    RenderActivity screen = controller.setup().get();
    Waiting.until("the scene is read", () -> screen.session() != null || screen.isFinishing());
    return controller;
  }
}
