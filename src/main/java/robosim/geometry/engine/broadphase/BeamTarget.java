package robosim.geometry.engine.broadphase;

/** Receives the objects that a beam may meet and answers how far it still looks: up to the nearest that it has found. */
public interface BeamTarget {
    /** Looks at an object, perhaps not for the first time. */
    double meet(LeafTable table, int id, double reach);

    /**
     * Looks at an object of a world without heights by its outline alone.
     *
     * @param outlines those of all objects of the table; see {@link robosim.geometry.index.tiles.OrientedRectangle}
     * @param local the object's place in them
     * @return NaN where the outline does not tell
     */
    double meetOutline(LeafTable table, int id, double[] outlines, int local, double reach);

    /** Whether an object is the nearest so far, which has nothing new to tell. */
    boolean isNearest(int id);
}
