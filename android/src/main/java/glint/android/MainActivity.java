package glint.android;

import android.app.Activity;
import android.content.pm.PackageManager.NameNotFoundException;
import android.os.Bundle;
import android.view.Gravity;
import android.widget.TextView;

/** Names the app and its version. */
public final class MainActivity extends Activity {
  @Override
  protected void onCreate(Bundle savedInstanceState) {
    super.onCreate(savedInstanceState);
    TextView title = new TextView(this);
    title.setText(getString(R.string.title, version()));
    title.setGravity(Gravity.CENTER);
    setContentView(title);
  }

  private String version() {
    try {
      return getPackageManager().getPackageInfo(getPackageName(), 0).versionName;
    } catch (NameNotFoundException e) {
      throw new IllegalStateException("an app knows its own package", e);
    }
  }
}
