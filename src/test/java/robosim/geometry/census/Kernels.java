package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.Dimension;

/** All kernels that are counted, in the order of the published table. */
final class Kernels {
    private Kernels() {}

    static List<Kernel> all() {
        List<Kernel> all = new ArrayList<>();
        all.add(new CylinderCone());
        all.addAll(DistanceKernel.all());
        all.add(new StandingMoves(Dimension.PLANAR));
        all.add(new StandingMoves(Dimension.SPATIAL));
        return all;
    }
}
