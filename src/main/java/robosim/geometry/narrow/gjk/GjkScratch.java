package robosim.geometry.narrow.gjk;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.planar.PlanarScratch;

/** The working memory of what goes by support functions. */
public class GjkScratch extends PlanarScratch {
    /** Distance and penetration of the two leaves of a question, in space or in the plane. */
    public final Gjk gjk = new Gjk();

    /** Looks at the two leaves that {@link #gjk} was asked about last. */
    public final ExpandingPolytope hull = new ExpandingPolytope(gjk.first, gjk.second);

    // What is large and not asked of every world is made when first asked.
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
