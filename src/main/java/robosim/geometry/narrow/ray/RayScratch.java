package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.narrow.planar.PlanarScratch;

/** The working memory of rays. */
public final class RayScratch {
    public final PlanarScratch planar;

    public final RayInterval interval = new RayInterval();
    final PlacedCylinder cylinder = new PlacedCylinder();
    final PlainCylinderFace plainCylinder = new PlainCylinderFace();
    final DoubleDoubles capsuleEnds = new DoubleDoubles(RayCapsule.PAIRS_NEEDED);
    public final RayRefine refine = new RayRefine();

    /** A ray at the height of what it is shown to. */
    final BeamAxis level = new BeamAxis();

    public RayScratch(PlanarScratch planar) {
        this.planar = planar;
    }
}
