/**
 * Speed against error: what an image costs and how far it is from the truth, as plain numbers.
 *
 * <p>Reading order: Study, Truth, Measurement, Curve; the rest serves these.
 */
package glint.report;
