package robosim.geometry.engine.broadphase;

/** Receives the objects that may meet a box. */
@FunctionalInterface
public interface BoxTarget {
    /** Looks at an object that may meet the box, perhaps not for the first time; answers whether it needs no more of them. */
    boolean visit(LeafTable table, int id);
}
