package robosim.geometry.census;

import java.util.List;
import robosim.geometry.model.Dimension;

/** All kernels that are counted, in the order of the published table. */
final class Kernels {
    private Kernels() {}

    static List<Kernel> all() {
        return List.of(new StandingMoves(Dimension.PLANAR), new StandingMoves(Dimension.SPATIAL));
    }
}
