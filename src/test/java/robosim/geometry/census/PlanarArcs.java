package robosim.geometry.census;

import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Twofold;

/**
 * When one projection that turns about a point meets another, from apart: every corner runs on a circle, which is cut with the
 * other's sides, a disc's centre on one that is cut with the polygon grown by its radius. In pairs of doubles but for the angle.
 */
final class PlanarArcs {
    private static final double CLOSE = PlanarMeeting.CLOSE;
    private static final double BESIDE = 0x1p-80;

    private final Twofold px;
    private final Twofold pz;
    private final double size;

    /** The first contact, radians of the turn below a full one; infinite where there is none. */
    double angle = Double.POSITIVE_INFINITY;

    /** The same of what passes by less than 2^-40 of the size. */
    double nearly = Double.POSITIVE_INFINITY;

    /** Of the first contact: which features meet, and whether they all but pass each other. */
    String feature = "";

    boolean isGrazed;
    private boolean isRound;

    private PlanarArcs(double px, double pz, double size) {
        this.px = Twofold.of(px);
        this.pz = Twofold.of(pz);
        this.size = size;
    }

    /** A turn of a from x towards z, or from z towards x where the sense is -1. Neither is an oval. */
    static PlanarArcs of(boolean roundA, PlanarTwin a, boolean roundB, PlanarTwin b, double px, double pz, int sense) {
        double size = a.size() + b.size() + Math.abs(px) + Math.abs(pz);
        PlanarArcs arcs = new PlanarArcs(px, pz, size);
        arcs.isRound = roundA || roundB;
        if (arcs.isRound) {
            arcs.grown(roundA ? a : b, roundA ? sense : -sense, a.radius.plus(b.radius), roundA ? b : a);
        } else {
            arcs.corners(a, sense, b, "its corner on a side");
            arcs.corners(b, -sense, a, "its side on a corner");
        }
        return arcs;
    }

    private void corners(PlanarTwin mover, int sense, PlanarTwin rest, String told) {
        for (int k = 0; k < mover.x.length; k++) {
            for (int m = 0; m < rest.x.length; m++) {
                line(mover, k, sense, rest, m, Twofold.ZERO, told);
            }
        }
    }

    private void grown(PlanarTwin disc, int sense, Twofold radius, PlanarTwin rest) {
        for (int m = 0; m < rest.x.length; m++) {
            circle(disc, sense, radius, rest, m);
            if (rest.x.length > 1) {
                line(disc, 0, sense, rest, m, radius, "at a side");
                line(disc, 0, sense, rest, m, radius.negated(), "at a side");
            }
        }
    }

    private void line(PlanarTwin mover, int k, int sense, PlanarTwin rest, int m, Twofold out, String told) {
        int n = (m + 1) % rest.x.length;
        Twofold ex = rest.x[n].minus(rest.x[m]);
        Twofold ez = rest.z[n].minus(rest.z[m]);
        Twofold length = PlanarTwin.dot(ex, ez, ex, ez).root();
        if (length.signum() == 0) {
            return;
        }
        Twofold ux = ex.over(length);
        Twofold uz = ez.over(length);
        Twofold wx = mover.x[k].minus(px);
        Twofold wz = mover.z[k].minus(pz);
        Twofold qx = rest.x[m].minus(px).plus(uz.times(out));
        Twofold qz = rest.z[m].minus(pz).minus(ux.times(out));
        // The line has its nearest point to the pivot at so much along it from q, and so far beside.
        Twofold beside = PlanarTwin.cross(ux, uz, qx, qz);
        Twofold along = PlanarTwin.dot(ux, uz, qx, qz);
        Twofold square = PlanarTwin.dot(wx, wz, wx, wz).minus(beside.times(beside));
        boolean isMissed = square.signum() < 0;
        Twofold half = isMissed ? Twofold.ZERO : square.root();
        if (isMissed
                && beside.abs().minus(PlanarTwin.dot(wx, wz, wx, wz).root()).head() > CLOSE * size) {
            return;
        }
        for (int side = -1; side <= 1; side += 2) {
            Twofold place = half.times(side);
            Twofold from = place.minus(along);
            Twofold x = ux.times(place).minus(uz.times(beside));
            Twofold z = uz.times(place).plus(ux.times(beside));
            double before = from.head();
            double after = from.minus(length).head();
            boolean isOn = !isMissed && before >= -BESIDE * size && after <= BESIDE * size;
            boolean isAtEnd = Math.abs(before) < CLOSE * size || Math.abs(after) < CLOSE * size;
            if (before > -CLOSE * size && after < CLOSE * size) {
                boolean graze = half.head() * half.head() < 4 * CLOSE * size * size;
                add(wx, wz, x, z, sense, isOn, graze, isAtEnd ? "corner on corner" : told);
            }
        }
    }

    private void circle(PlanarTwin disc, int sense, Twofold radius, PlanarTwin rest, int m) {
        Twofold wx = disc.x[0].minus(px);
        Twofold wz = disc.z[0].minus(pz);
        Twofold vx = rest.x[m].minus(px);
        Twofold vz = rest.z[m].minus(pz);
        Twofold rho = PlanarTwin.dot(wx, wz, wx, wz);
        Twofold v = PlanarTwin.dot(vx, vz, vx, vz);
        if (rho.signum() == 0 || v.signum() == 0) {
            return;
        }
        Twofold k = rho.plus(v).minus(radius.times(radius)).times(0.5);
        // Between the least distance of the centre's circle and the greatest.
        Twofold off = rho.root().minus(v.root()).abs();
        boolean isMissed = radius.isBelow(off) || rho.root().plus(v.root()).isBelow(radius);
        if (isMissed && off.minus(radius).head() > CLOSE * size) {
            return;
        }
        Twofold half = isMissed ? Twofold.ZERO : rho.times(v).minus(k.times(k)).root();
        for (int side = -1; side <= 1; side += 2) {
            Twofold x = vx.times(k).minus(vz.times(half).times(side)).over(v);
            Twofold z = vz.times(k).plus(vx.times(half).times(side)).over(v);
            add(wx, wz, x, z, sense, !isMissed, radius.minus(off).head() < CLOSE * size, "at a corner");
        }
    }

    private void add(
            Twofold wx, Twofold wz, Twofold x, Twofold z, int sense, boolean isOn, boolean graze, String told) {
        double t = Math.atan2(
                sense * PlanarTwin.cross(wx, wz, x, z).head(),
                PlanarTwin.dot(wx, wz, x, z).head());
        double turned = t < 0 ? t + 2 * Math.PI : t;
        nearly = Math.min(nearly, turned);
        if (isOn && turned < angle) {
            angle = turned;
            feature = isRound && told.equals("corner on corner") ? "where a side ends" : told;
            isGrazed = graze;
        }
    }
}
