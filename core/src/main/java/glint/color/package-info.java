/** Linear colour, and the curves from linear light to display codes. */
package glint.color;
