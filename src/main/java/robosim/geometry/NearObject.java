package robosim.geometry;

import robosim.geometry.collision.SignedDistance;
import robosim.geometry.model.GeometryObject;

/**
 * An object and how far away it is.
 *
 * @param object   at its present place
 * @param distance world units; 0 in contact
 * @param signed   the same as a bracket, negative for an overlap, with the nearest or deepest points: the first on what was
 *                 asked about, the second on the object
 */
public record NearObject(GeometryObject object, double distance, SignedDistance signed) {}
