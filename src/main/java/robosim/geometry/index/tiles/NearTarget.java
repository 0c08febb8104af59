package robosim.geometry.index.tiles;

/** Receives the objects near a rectangle. */
@FunctionalInterface
public interface NearTarget {
    /** Receives an object that may be near, possibly more than once; returns true if no more are needed. */
    boolean visit(int id);
}
