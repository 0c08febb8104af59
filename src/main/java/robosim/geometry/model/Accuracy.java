package robosim.geometry.model;

/**
 * What stands for an object in a query. Any accuracy other than {@link #EXACT} replaces each object by an enclosure: it
 * may add collisions and shorten distances, but never misses a collision. Whatever {@link #EXACT} refuses, a move included,
 * is refused at every accuracy, at the same fraction or before, also from a start where the enclosures already overlap.
 */
public enum Accuracy {
    /** A sphere around the object. */
    SPHERE,
    /** The box around the object along the world's axes. */
    AABB,
    /** A box around the object along the object's own axes. */
    OBB,
    /** An upright octagonal prism around the object: bounded along x, z, x + z, x - z and y. */
    DOP,
    /** The object itself. */
    EXACT
}
