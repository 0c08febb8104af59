package robosim.geometry.collision;

import robosim.geometry.model.Point;

/**
 * Two pieces of two objects that have a point in common.
 *
 * @param a the piece of the first object
 * @param b the piece of the second
 * @param point a point of both pieces, to within {@code error}
 * @param normal a unit vector from b towards a, along which a is separated from b by the shortest translation. Computed
 *     in plain doubles, for these two pieces alone: a whole mesh may need another direction. If a solid mesh contains
 *     the other piece, it is straight up or down and carries no information
 * @param error an upper bound of the distance of the point from either piece, world units, measured for this point.
 *     Between boxes and triangles some 2<sup>-44</sup> of their size, 0 inside a solid mesh, and for round shapes
 *     mostly 2<sup>-36</sup>. If a cylinder only just touches something flat the point may be farther off, and this
 *     number says how far
 * @param certainty whether it is proven that they touch
 */
public record Contact(ContactPart a, ContactPart b, Point point, Point normal, double error, Certainty certainty) {
    /**
     * One of the points on which two pieces lie: see {@link ContactQuery#manifold}.
     *
     * @param point midway between the surfaces of both
     * @param depth how far they overlap there along the contact's normal, world units; at least 0
     */
    public record Spot(Point point, double depth) {}
}
