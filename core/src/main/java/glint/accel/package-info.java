/** Finding the closest hit, or any hit, among all primitives of a scene. */
package glint.accel;
