package robosim.geometry.engine.sensing;

import robosim.geometry.check.Checks;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.model.Dimension;

/** Many rays that begin anywhere: what each meets first, or only whether it meets anything. */
public final class RayBatch {
    /** The numbers of a ray: where it starts, its direction, and its range. */
    public static final int RAY = 7;

    private final Dimension dimension;
    private final BeamQuery ranging;

    public RayBatch(Dimension dimension, BeamQuery ranging) {
        this.dimension = dimension;
        this.ranging = ranging;
    }

    /** Checks all rays before any is answered. */
    public void check(double[] rays, int count) {
        Checks.present("rays", rays);
        if (count < 0 || count > rays.length / RAY) {
            throw new IllegalArgumentException("count must be from 0 to " + rays.length / RAY
                    + ", as rays has 7 numbers for each (got: " + count + ")");
        }
        for (int k = 0; k < count; k++) {
            check(rays, k, RAY * k);
        }
    }

    private void check(double[] rays, int ray, int at) {
        double most = 0;
        for (int k = at; k < at + 6; k++) {
            most = Math.max(most, Math.abs(rays[k])); // NaN stays
        }
        double dx = rays[at + 3];
        double dy = rays[at + 4];
        double dz = rays[at + 5];
        if (!(most <= Checks.LIMIT && rays[at + 6] >= 0)) {
            for (int k = at; k < at + 6; k++) {
                Checks.coordinate("rays[" + k + "]", rays[k]);
            }
            throw new IllegalArgumentException(
                    "range of ray " + ray + " must be at least 0 (got: " + rays[at + 6] + ")");
        }
        if (dx == 0 && dy == 0 && dz == 0) {
            throw new IllegalArgumentException("direction of ray " + ray + " must not be zero (got: (0.0, 0.0, 0.0))");
        }
        BeamQuery.checkLevel(dimension, dx, dy, dz);
    }

    private void aim(double[] rays, int at) {
        // As a point has them, which has no -0.0.
        ranging.line(
                dimension,
                rays[at] + 0.0,
                rays[at + 1] + 0.0,
                rays[at + 2] + 0.0,
                rays[at + 3] + 0.0,
                rays[at + 4] + 0.0,
                rays[at + 5] + 0.0);
    }

    /**
     * Sets the bits of rays that meet nothing, and clears the others up to a multiple of 64.
     *
     * @param ignored an object that does not count; -1 for none
     * @return how many meet nothing
     */
    public int free(AccuracyView view, double[] rays, int count, int ignored, long[] free) {
        int found = 0;
        int likely = -1; // what blocked the ray before mostly blocks this one too
        for (int first = 0; first < count; first += Long.SIZE) {
            long bits = 0;
            for (int k = first; k < Math.min(first + Long.SIZE, count); k++) {
                aim(rays, RAY * k);
                if (ranging.hits(view, rays[RAY * k + 6], ignored, likely)) {
                    likely = ranging.hit();
                } else {
                    bits |= 1L << k;
                }
            }
            free[first / Long.SIZE] = bits;
            found += Long.bitCount(bits);
        }
        return found;
    }

    /** What each ray meets first. */
    public void cast(AccuracyView view, double[] rays, int count, BeamResults out) {
        out.clear(count, dimension);
        double[] distances = out.distances();
        for (int k = 0; k < count; k++) {
            aim(rays, RAY * k);
            distances[k] = ranging.nearest(view, rays[RAY * k + 6], -1);
            ranging.tell(out, k, view, distances[k]);
        }
        out.filled(count);
    }
}
