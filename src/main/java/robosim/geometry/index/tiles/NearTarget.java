package robosim.geometry.index.tiles;

/** Who looks for what is near a rectangle. */
@FunctionalInterface
public interface NearTarget {
    /** Meets an object that may be near, maybe again; answers whether no more are wanted. */
    boolean meet(int id);
}
