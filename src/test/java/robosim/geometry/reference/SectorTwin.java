package robosim.geometry.reference;

import org.jspecify.annotations.Nullable;

/** The nearest point of a projection within a sector: the slow twin of cones in the plane. */
public final class SectorTwin {
    // The sector's axis and its edges.
    private Twofold dx = Twofold.ZERO;
    private Twofold dz = Twofold.ZERO;
    private Twofold cos = Twofold.ZERO;
    private Twofold sin = Twofold.ZERO;

    private SectorTwin() {}

    /** The least distance within the sector, wider by an angle to both sides; the corners, the feet, and where edges cut. */
    public static double nearest(PlanarTwin twin, double[] apex, double[] way, double halfCos, double by) {
        return new SectorTwin().within(twin, apex, way, halfCos, by);
    }

    private double within(PlanarTwin twin, double[] apex, double[] way, double halfCos, double by) {
        dx = Twofold.of(way[0]);
        dz = Twofold.of(way[1]);
        Twofold c = Twofold.of(halfCos);
        Twofold s = Twofold.ONE.minus(c.times(c)).root();
        cos = c.minus(s.times(by));
        sin = s.plus(c.times(by));
        if (sin.signum() < 0) {
            return Double.POSITIVE_INFINITY;
        }
        Twofold length = PlanarTwin.dot(dx, dz, dx, dz).root();
        dx = dx.over(length);
        dz = dz.over(length);
        double best = Double.POSITIVE_INFINITY;
        double[] angles = new double[3];
        int count = 0;
        for (int side = -1; side <= 1; side++) {
            Twofold ux = side == 0 ? dx : dx.times(cos).minus(dz.times(sin).times(side));
            Twofold uz = side == 0 ? dz : dz.times(cos).plus(dx.times(sin).times(side));
            Twofold entry = twin.entry(apex[0], apex[1], ux, uz);
            if (entry != null) {
                best = Math.min(best, entry.head());
                angles[count++] = Math.atan2(uz.head(), ux.head());
            }
        }
        return Math.min(best, twin.isOval ? round(twin, apex, angles, count) : places(twin, apex));
    }

    // The corners and the feet of the apex that are within.
    private double places(PlanarTwin twin, double[] apex) {
        double best = Double.POSITIVE_INFINITY;
        for (int k = 0; k < twin.x.length; k++) {
            int n = (k + 1) % twin.x.length;
            Twofold px = twin.x[k].minus(Twofold.of(apex[0]));
            Twofold pz = twin.z[k].minus(Twofold.of(apex[1]));
            best = Math.min(best, place(px, pz, twin.radius));
            Twofold ex = twin.x[n].minus(twin.x[k]);
            Twofold ez = twin.z[n].minus(twin.z[k]);
            Twofold square = PlanarTwin.dot(ex, ez, ex, ez);
            Twofold along = PlanarTwin.dot(px, pz, ex, ez).negated();
            if (along.signum() > 0 && along.isBelow(square)) {
                Twofold t = along.over(square);
                best = Math.min(best, place(px.plus(ex.times(t)), pz.plus(ez.times(t)), twin.radius));
            }
        }
        return best;
    }

    private double place(Twofold px, Twofold pz, Twofold radius) {
        return holds(px, pz)
                ? PlanarTwin.dot(px, pz, px, pz).root().minus(radius).head()
                : Double.POSITIVE_INFINITY;
    }

    private boolean holds(Twofold px, Twofold pz) {
        Twofold ahead = PlanarTwin.dot(px, pz, dx, dz);
        Twofold aside = PlanarTwin.cross(dx, dz, px, pz).abs();
        return ahead.signum() >= 0 && aside.times(cos).minus(ahead.times(sin)).head() <= 0;
    }

    // Along the ray that is the nearest by a search that goes down, from each that hits.
    private double round(PlanarTwin twin, double[] apex, double[] angles, int count) {
        double[] starts = new double[count + 1];
        System.arraycopy(angles, 0, starts, 0, count);
        starts[count] = Math.atan2(twin.z[0].head() - apex[1], twin.x[0].head() - apex[0]);
        double best = Double.POSITIVE_INFINITY;
        double middle = Math.atan2(dz.head(), dx.head());
        for (double start : starts) {
            double angle = start
                    + 1e-13 * Math.IEEEremainder(middle - start, 2 * Math.PI); // an edge itself may be rounded outward

            double here = along(twin, apex, angle);
            for (double step = 0.1; step > 1e-14 && here < Double.POSITIVE_INFINITY; ) {
                double left = along(twin, apex, angle - step);
                double right = along(twin, apex, angle + step);
                if (Math.min(left, right) < here) {
                    here = Math.min(left, right);
                    angle += left < right ? -step : step;
                } else {
                    step *= 0.2;
                }
            }
            best = Math.min(best, here);
        }
        return best;
    }

    private double along(PlanarTwin twin, double[] apex, double angle) {
        Twofold ux = Twofold.of(Math.cos(angle));
        Twofold uz = Twofold.of(Math.sin(angle));
        @Nullable Twofold entry = holds(ux, uz) ? twin.entry(apex[0], apex[1], ux, uz) : null;
        return entry == null
                ? Double.POSITIVE_INFINITY
                : entry.times(PlanarTwin.dot(ux, uz, ux, uz).root()).head();
    }
}
