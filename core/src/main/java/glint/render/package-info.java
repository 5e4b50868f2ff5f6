/** Tiles in parallel: from a prepared scene to an image and its statistics. */
package glint.render;
