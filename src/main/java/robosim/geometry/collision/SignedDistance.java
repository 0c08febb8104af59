package robosim.geometry.collision;

import robosim.geometry.model.Point;

/**
 * How far two objects are apart, or how far they overlap: a bracket of the signed distance, the points between which it
 * was found, and its direction.
 *
 * <p>The signed distance is the least distance of the two if they are apart. If they overlap, it is minus the length of
 * the shortest translation that separates them. It is 0 in contact.
 *
 * <p>Apart, the points are nearest points. Overlapping, they are the deepest ones: those that the shortest translation
 * brings together. In both cases {@code onA - onB} is the signed distance times the direction, to within rounding. So
 * the direction is the gradient: if a moves by a small d, the signed distance grows by {@code d . direction}. To get out
 * of b, a moves along the direction by {@code -low}.
 *
 * <p>The direction is unique where one pair of nearest points is, or one shortest translation. Otherwise, as for two
 * concentric spheres or a box midway between two others, one of several is returned, always the same. Between boxes, spheres, capsules,
 * triangles, and upright objects of any kind it is off by some 2<sup>-47</sup> of the sizes over the distance; with a
 * tipped cylinder by up to 2<sup>-21</sup>, since distances hardly change with the direction there.
 *
 * <p>For objects of several pieces, such as groups, meshes and grids, the points and the direction are those of the
 * nearest or deepest pair of pieces. The upper end of the bracket is proven by that pair, and the lower end by a
 * translation that separates the objects as a whole; for overlapping objects the two may be far apart. A surface
 * without an inside has no depth but that of its triangles.
 *
 * @param low a lower bound, world units: above 0 proves that the two are apart; negative, that a translation of
 *     {@code -low} separates them
 * @param high an upper bound: 0 or below proves that they touch or overlap; negative, that no translation shorter than
 *     {@code -high} separates them
 * @param onA a point of a, to within rounding. In PLANAR its height is that of {@link ContactQuery#contacts}
 * @param onB a point of b
 * @param direction a unit vector, from b towards a if they are apart; along it a has to move to get out if they overlap
 * @param steps how many steps were taken; see {@link Budget}
 */
public record SignedDistance(double low, double high, Point onA, Point onB, Point direction, long steps) {}
