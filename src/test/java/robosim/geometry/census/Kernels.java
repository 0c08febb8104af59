package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;

/** All kernels that are counted, in the order of the published table. */
final class Kernels {
    private Kernels() {}

    static List<Kernel> all() {
        List<Kernel> all = new ArrayList<>();
        all.add(new CylinderCone());
        all.addAll(DistanceKernel.all());
        return all;
    }
}
