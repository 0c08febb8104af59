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

    private @Nullable ConeWorkspace cones;

    public ConeScratch(RayScratch ray, PlanarScratch planar, LeafScratch leaf) {
        this.ray = ray;
        this.planar = planar;
        this.leaf = leaf;
    }

    public ConeWorkspace cones() {
        if (cones == null) {
            cones = new ConeWorkspace();
        }
        return cones;
    }
}
