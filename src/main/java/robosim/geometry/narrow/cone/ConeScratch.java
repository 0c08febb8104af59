package robosim.geometry.narrow.cone;

import org.jspecify.annotations.Nullable;
import robosim.geometry.narrow.mesh.MeshScratch;

/** The working memory for cones and sectors. */
public class ConeScratch extends MeshScratch {
    public final PlanarSector sector = new PlanarSector();

    private @Nullable ConeWorkspace cones;
    private @Nullable SectorOval sectorOval;

    public SectorOval sectorOval() {
        if (sectorOval == null) {
            sectorOval = new SectorOval();
        }
        return sectorOval;
    }

    public ConeWorkspace cones() {
        if (cones == null) {
            cones = new ConeWorkspace();
        }
        return cones;
    }
}
