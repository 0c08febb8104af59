package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.Dimension;

/** All kernels that are counted, in the order of the published table. */
final class Kernels {
    private Kernels() {}

    static List<Kernel> all() {
        List<Kernel> all = new ArrayList<>();
        all.addAll(OverlapKernel.all());
        all.add(new RayKernel());
        all.add(new CylinderCone());
        all.add(new SphereCone());
        for (PolytopeCone.Shape shape : PolytopeCone.Shape.values()) {
            all.add(new PolytopeCone(shape));
        }
        all.addAll(DistanceKernel.all());
        all.add(new SpatialTurn());
        all.add(new SpatialWay());
        all.add(new StandingMoves(Dimension.PLANAR));
        all.add(new StandingMoves(Dimension.SPATIAL));
        return all;
    }
}
