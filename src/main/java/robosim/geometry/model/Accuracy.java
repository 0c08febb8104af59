package robosim.geometry.model;

/**
 * What stands for an object in a query. A level below {@link #EXACT} replaces each object by an enclosure: it may add
 * collisions and shorten distances, and never misses one.
 */
public enum Accuracy {
    /** A sphere about the object. */
    SPHERE,
    /** The box about the object along the world's axes. */
    AABB,
    /** A box about the object along the object's own axes. */
    OBB,
    /** An upright octagonal prism about the object: bounded along x, z, x + z, x - z and y. */
    DOP,
    /** The object itself. */
    EXACT
}
