package glint.android;

import android.content.ContentProvider;
import android.content.ContentUris;
import android.content.ContentValues;
import android.database.Cursor;
import android.net.Uri;

/**
 * Stands in for the store of pictures of a device: takes one picture, and keeps what is said of it.
 */
public final class FakeMedia extends ContentProvider {

  final ContentValues said = new ContentValues();
  boolean full;

  @Override
  public boolean onCreate() {
    return true;
  }

  @Override
  public Uri insert(Uri uri, ContentValues values) {
    said.putAll(values);
    return full ? null : ContentUris.withAppendedId(uri, 1);
  }

  @Override
  public int update(Uri uri, ContentValues values, String where, String[] arguments) {
    said.putAll(values);
    return 1;
  }

  @Override
  public int delete(Uri uri, String where, String[] arguments) {
    said.clear();
    return 1;
  }

  @Override
  public Cursor query(Uri uri, String[] columns, String where, String[] arguments, String order) {
    return null;
  }

  @Override
  public String getType(Uri uri) {
    return "image/png";
  }
}
