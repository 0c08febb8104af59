package robosim.geometry.index;

/** What a ray may meet on its way through a {@link QuadTree}. */
public interface RayTarget {
    /**
     * Looks at an object whose box the ray may meet; maybe again, and maybe one that it passes by.
     *
     * @param limit the parameter up to which is looked
     * @return up to which is to be looked from now on, no more than the limit
     */
    double meet(int id, double limit);
}
