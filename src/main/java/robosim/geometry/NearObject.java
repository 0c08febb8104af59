package robosim.geometry;

import robosim.geometry.model.GeometryObject;

/**
 * An object and how far away it is.
 *
 * @param object   at its present place
 * @param distance world units; 0 in contact
 */
public record NearObject(GeometryObject object, double distance) {}
