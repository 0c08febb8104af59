package robosim.geometry.stress;

import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.ray.PlanarRay;
import robosim.geometry.narrow.ray.SpatialRay;
import robosim.geometry.proof.Witnesses;
import robosim.geometry.reference.Quantity.Arithmetic;
import robosim.geometry.reference.Truth;
import robosim.geometry.reference.Truth.Form;

/** Whether a ray hits a convex leaf, in the plane or in space. */
final class RayFamily extends Family {
    private final boolean planar;
    private final Form[] forms;
    private final double spread;

    RayFamily(String name, boolean planar, Form[] forms, double spread) {
        super(name);
        this.planar = planar;
        this.forms = forms;
        this.spread = spread;
    }

    @Override
    Source source(SplittableRandom random) {
        return new Rays(this, planar, forms, spread, random);
    }

    @Override
    int product(Case c, Scratch s) {
        return distance(c, s) < Double.POSITIVE_INFINITY ? 1 : 0;
    }

    @Override
    @Nullable
    String proof(Case c, int answer, Witnesses witnesses, Scratch scratch) {
        return witnesses.ray(
                c.ray,
                new double[] {c.ray[3], planar ? 0 : c.ray[4], c.ray[5]},
                Witnesses.object(OverlapFamily.kind(c.formB), c.b),
                planar ? Dimension.PLANAR : Dimension.SPATIAL,
                distance(c, scratch));
    }

    private double distance(Case c, Scratch s) {
        double[] r = c.ray;
        LeafKind kind = OverlapFamily.kind(c.formB);
        return planar
                ? PlanarRay.distance(new BeamAxis().line(r[0], 0, r[2], r[3], 0, r[5]), kind, c.b, 0, s.ray)
                : SpatialRay.distance(new BeamAxis().line(r[0], r[1], r[2], r[3], r[4], r[5]), kind, c.b, 0, s.ray);
    }

    @Override
    int truth(Case c, Arithmetic n) {
        boolean hit = planar ? Truth.planarRay(n, c.ray, c.formB, c.b) : Truth.spatialRay(n, c.ray, c.formB, c.b);
        return hit ? 1 : 0;
    }

    /** Where a ray meets a round end of a capsule is always told in pairs of doubles. */
    @Override
    double exactAtRandom() {
        return forms[forms.length - 1] == Form.CAPSULE ? 0.7 : super.exactAtRandom();
    }

    @Override
    String call() {
        return planar
                ? "PlanarRay.distance(ray[0], ray[2], ray[3], ray[5], Leaf.B, b, 0, new Scratch())"
                : "SpatialRay.distance(ray[0], ray[1], ray[2], ray[3], ray[4], ray[5], Leaf.B, b, 0, new Scratch())";
    }
}
