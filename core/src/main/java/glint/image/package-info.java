/** Pictures in linear light, and how far one is from another. */
package glint.image;
