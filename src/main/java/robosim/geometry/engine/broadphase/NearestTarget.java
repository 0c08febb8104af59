package robosim.geometry.engine.broadphase;

/** Receives the objects near another one and answers how far it still looks: up to the least distance that it has found. */
@FunctionalInterface
public interface NearestTarget {
    /** Looks at an object, perhaps not for the first time. */
    double visit(LeafTable table, int id, double reach);
}
