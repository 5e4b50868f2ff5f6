/** Readers of scene files and images from streams. */
package glint.io;
