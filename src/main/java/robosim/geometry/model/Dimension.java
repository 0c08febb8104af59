package robosim.geometry.model;

/** How much of space a world compares. */
public enum Dimension {
    /** Only the projections on the XZ plane count; rays and beams are projected and measured there. */
    PLANAR,
    /** Heights count too. */
    SPATIAL
}
