/** What a person wrote, and the prepared form of it that rays touch. */
package glint.scene;
