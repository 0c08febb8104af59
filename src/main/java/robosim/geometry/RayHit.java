package robosim.geometry;

import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * The first thing that a ray hits.
 *
 * @param distance world units from the ray's start; 0 where it starts inside the object or on it
 * @param point    where the ray hits the object
 * @param normal   the unit normal of the surface there, towards the side that the ray comes from. If the ray starts
 *                 inside, the opposite of its direction. If it starts on the surface to within rounding, at distance 0,
 *                 either the outward normal, which may then point along the ray, or the opposite of the ray's direction
 * @param object   the object hit; of several at the same distance the one that was added first
 */
public record RayHit(double distance, Point point, Point normal, GeometryObject object) {}
