package robosim.geometry.narrow.cone;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.leaf.LeafScratch;
import robosim.geometry.narrow.planar.PlanarScratch;
import robosim.geometry.narrow.ray.RayScratch;

/** The working memory for cones and sectors. */
public final class ConeScratch {
    public final RayScratch ray;
    public final PlanarScratch planar;
    public final LeafScratch leaf;

    public final PlanarSector sector = new PlanarSector();

    private @Nullable Kernels cones;

    public ConeScratch(RayScratch ray, PlanarScratch planar, LeafScratch leaf) {
        this.ray = ray;
        this.planar = planar;
        this.leaf = leaf;
    }

    public Kernels cones() {
        if (cones == null) {
            cones = new Kernels();
        }
        return cones;
    }

    /** Created on first use: many queries need none of them. */
    static final class Kernels {
        final Cone cone = new Cone();
        final PlainConeBox box = new PlainConeBox();
        final PlainSectorBox sectorBox = new PlainSectorBox();
        final ConePolytope polytope = new ConePolytope();
        final ConeCylinder cylinder = new ConeCylinder();
        final SectorOval oval = new SectorOval();
        final ConeCapsule capsule = new ConeCapsule();
    }
}
