package robosim.geometry.narrow.gjk;

import org.jspecify.annotations.Nullable;

/** The working memory of algorithms that use support functions. */
public final class GjkScratch {
    /** Distance and penetration of two leaves, in space or in the plane. */
    public final Gjk pair = new Gjk();

    /** Works on the two leaves of the last query of {@link #pair}. */
    public final ExpandingPolytope hull = new ExpandingPolytope(pair.first, pair.second);

    // Large objects that not every world needs are created on first use.
    private @Nullable Penetration penetration;
    private @Nullable HullOverlap hulls;

    public Penetration penetration() {
        if (penetration == null) {
            penetration = new Penetration();
        }
        return penetration;
    }

    public HullOverlap hulls() {
        if (hulls == null) {
            hulls = new HullOverlap();
        }
        return hulls;
    }
}
