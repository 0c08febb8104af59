package robosim.geometry.collision;

/** How sure a verdict is. */
public enum Certainty {
    /** Proven: the verdict of real-number geometry for the stored numbers. */
    EXACT,

    /**
     * The verdict is "touching", and the two objects touch or are closer than doubles can resolve, some 2<sup>-40</sup>
     * of their size. This occurs only for two cylinders whose axes are not parallel, for a cylinder and a capsule, and in
     * PLANAR for a turned cylinder or capsule with anything. Objects farther apart are never reported so, and "apart" is always proven.
     */
    UNCERTAIN
}
