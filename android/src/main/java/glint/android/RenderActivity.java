package glint.android;

import android.app.Activity;
import android.content.Context;
import android.content.Intent;
import android.net.Uri;
import android.os.Bundle;
import android.view.Menu;
import android.view.MenuItem;
import android.widget.Toast;
import glint.android.Status.State;
import glint.scene.Camera;
import glint.scene.Scene;

/** Shows one scene as it is rendered. */
public final class RenderActivity extends Activity {

  private static final String SCENE = "scene";
  private static final String CAMERA = "camera";

  private PictureView picture;
  private StatusPanel panel;
  private RenderMenu commands;
  private final Saver saver = new Saver(this);
  private Session session;

  /** Where the camera was when the app's process ended; null for where the scene has it. */
  private double[] at;

  private boolean visible;

  /** Returns what opens a scene of a file. */
  static Intent intent(Context context, Uri file, String scene) {
    return new Intent(context, RenderActivity.class).setData(file).putExtra(SCENE, scene);
  }

  @Override
  protected void onCreate(Bundle state) {
    super.onCreate(state);
    setContentView(R.layout.render);
    picture = findViewById(R.id.picture);
    panel = new StatusPanel(findViewById(R.id.screen));
    getActionBar().setDisplayHomeAsUpEnabled(true);
    at = state == null ? null : state.getDoubleArray(CAMERA);
    picture.setOnTouchListener(new Touch(picture, this::session));
    session = (Session) getLastNonConfigurationInstance();
    if (session == null) {
      GlintApplication.library(this).read(getIntent().getData(), this::begin);
    } else {
      show();
    }
  }

  /** Renders the scene that was asked for, if it is still in its file. */
  private void begin(Reading reading) {
    if (isDestroyed()) {
      return;
    }
    String name = getIntent().getStringExtra(SCENE);
    for (Scene scene : reading.scenes()) {
      if (scene.name().equals(name)) {
        Camera camera = at == null ? scene.camera() : CameraState.moved(scene.camera(), at);
        session = new Session(scene, camera, Settings.load(this));
        session.leave(!visible);
        show();
        return;
      }
    }
    String why =
        reading.problems().isEmpty() ? getString(R.string.gone) : reading.problems().get(0);
    Toast.makeText(this, why, Toast.LENGTH_LONG).show();
    finish();
  }

  private void show() {
    setTitle(session.scene().title());
    picture.setContentDescription(getString(R.string.picture_of, session.scene().title()));
    session.watch(this::update);
    update();
  }

  private void update() {
    panel.show(session);
    picture.show(session.bitmap());
    State state = session.status().state();
    picture.setKeepScreenOn(state == State.PREPARING || state == State.RENDERING);
    if (commands != null) {
      commands.update(session);
    }
  }

  @Override
  public boolean onCreateOptionsMenu(Menu menu) {
    getMenuInflater().inflate(R.menu.render, menu);
    commands = new RenderMenu(menu);
    if (session != null) {
      update();
    }
    return true;
  }

  @Override
  public boolean onOptionsItemSelected(MenuItem item) {
    if (item.getItemId() == R.id.pause) {
      session.pause(!session.isPaused());
      update();
    } else if (item.getItemId() == R.id.save) {
      saver.save(session.bitmap(), session.scene().name(), false);
    } else if (item.getItemId() == R.id.share) {
      saver.save(session.bitmap(), session.scene().name(), true);
    } else if (item.getItemId() == R.id.plan) {
      PlanDialog.show(this, session.plan());
    } else if (item.getItemId() == R.id.reset) {
      session.look(session.scene().camera(), false);
    } else {
      return super.onOptionsItemSelected(item);
    }
    return true;
  }

  @Override
  public void onRequestPermissionsResult(int request, String[] permissions, int[] results) {
    if (session != null && session.bitmap() != null) {
      saver.answered(request, results, session.bitmap(), session.scene().name());
    }
  }

  /** Returns the renders of the scene, or null while it is read. */
  Session session() {
    return session;
  }

  @Override
  protected void onStart() {
    super.onStart();
    visible = true;
    if (session != null) {
      session.leave(false);
    }
  }

  @Override
  protected void onStop() {
    super.onStop();
    visible = false;
    if (session != null && !isChangingConfigurations()) {
      session.leave(true);
    }
  }

  @Override
  protected void onSaveInstanceState(Bundle state) {
    super.onSaveInstanceState(state);
    state.putDoubleArray(CAMERA, session == null ? at : CameraState.of(session.camera()));
  }

  @Override
  public Object onRetainNonConfigurationInstance() {
    return session;
  }

  @Override
  protected void onDestroy() {
    super.onDestroy();
    saver.close();
    if (session == null) {
      return;
    }
    session.watch(() -> {});
    if (!isChangingConfigurations()) {
      session.close();
    }
  }

  @Override
  public void onTrimMemory(int level) {
    super.onTrimMemory(level);
    if (session != null && level == TRIM_MEMORY_RUNNING_CRITICAL) {
      session.shrink();
    }
  }
}
