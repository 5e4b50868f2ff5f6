/** The numbers that decide where samples are taken. */
package glint.sampling;
