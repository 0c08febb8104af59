package robosim.geometry.collision;

/** How sure a verdict is. */
public enum Certainty {
    /** It is that of the real-number geometry of the stored numbers: proven. */
    EXACT,

    /**
     * It is "touching", and the two touch or are apart by less than doubles can tell, some 2<sup>-40</sup> of their size.
     * Only two cylinders of which one is turned give it, and in PLANAR a turned cylinder with anything. It is never said
     * of two that are farther apart, and "apart" is always proven.
     */
    UNCERTAIN
}
