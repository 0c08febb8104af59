package robosim.geometry.collision;

import robosim.geometry.model.Point;

/**
 * Two pieces of two objects that have a point in common.
 *
 * @param a what of the first object
 * @param b what of the second
 * @param point a point of both, to within {@code error}
 * @param normal the way on which a gets off b soonest, of length 1: from b towards a. Found in plain doubles, for these
 *     two pieces alone: a mesh may need another way out. Where a solid mesh holds the other piece inside, it is straight
 *     up or down, and tells nothing
 * @param error how far the point is at most from either piece, world units; measured for this very
 *     point. Between boxes and triangles some 2<sup>-44</sup> of their size, 0 inside of a solid mesh, and with round things
 *     mostly 2<sup>-36</sup>: where a cylinder only just touches something flat the point may be farther off, which this
 *     number tells
 * @param certainty whether it is proven that they touch
 */
public record Contact(ContactPart a, ContactPart b, Point point, Point normal, double error, Certainty certainty) {}
