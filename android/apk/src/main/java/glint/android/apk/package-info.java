/** Looks into the app's package: runs the core that is in it on a Java machine, and times it. */
package glint.android.apk;
