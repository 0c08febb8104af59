package robosim.geometry.model;

/** Whether a world compares objects in the plane or in space. */
public enum Dimension {
    /**
     * Only the projections on the XZ plane count; rays and beams are projected and measured there. Only sensors that look up
     * or down (cameras, lidars with elevation, pictures) see the objects with their heights.
     */
    PLANAR,
    /** Heights count too. */
    SPATIAL
}
