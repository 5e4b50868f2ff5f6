/** Hard cases with exact answers, run by the tests and by {@code glint verify}. */
package glint.verify;
