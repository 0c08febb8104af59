package robosim.geometry.census;

import java.util.List;

/** All kernels that are counted, in the order of the published table. */
final class Kernels {
    private Kernels() {}

    static List<Kernel> all() {
        return List.of(
                new CylinderCone(),
                new SphereCone(),
                new PolytopeCone(PolytopeCone.Shape.BOX),
                new PolytopeCone(PolytopeCone.Shape.TRIANGLE),
                new PolytopeCone(PolytopeCone.Shape.MESH));
    }
}
