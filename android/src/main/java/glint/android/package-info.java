/**
 * The app: lists scenes, shows the one that is picked as it is rendered, saves its picture.
 *
 * <p>Everything about scenes and rendering is in core; here are the decoder of images, the surface
 * and the storage of a phone.
 */
package glint.android;
