package robosim.geometry;

import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * What a ray meets first.
 *
 * @param distance world units from the ray's start; 0 where it starts inside the object or on it
 * @param point    where the ray meets the object
 * @param normal   the unit normal of the surface there, towards the side that the ray comes from; against the ray's
 *                 direction where it starts inside; where it starts on the surface to rounding, at distance 0, the outward
 *                 normal or the ray's opposite, and the former may look along the ray
 * @param object   what is met; of several at the same distance the one that was added first
 */
public record RayHit(double distance, Point point, Point normal, GeometryObject object) {}
