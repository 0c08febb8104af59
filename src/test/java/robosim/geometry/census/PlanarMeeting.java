package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Twofold;

/**
 * When one projection that moves straight on meets another, from apart, to some 100 bits: every corner is a ray against the
 * other's sides, a disc's centre one against the polygon grown by its radius.
 */
final class PlanarMeeting {
    /** What is nearer than this share of the size counts as met at once. */
    static final double CLOSE = 0x1p-40;

    /** A corner's ray may miss a side's end by so much. */
    private static final double BESIDE = 0x1p-80;

    private record Hit(Twofold time, double error, boolean ofMover, boolean isRound, double x, double z) {}

    private final List<Hit> hits = new ArrayList<>();
    private final Twofold ux;
    private final Twofold uz;
    private final Twofold square;

    /** In ways from the start; infinite where the two never meet. */
    Twofold time = Twofold.of(Double.POSITIVE_INFINITY);

    /** How wrong that may be. */
    double error;

    /** Of two discs empty, else which features meet. */
    String feature = "";

    private PlanarMeeting(double dx, double dz) {
        ux = Twofold.of(dx);
        uz = Twofold.of(dz);
        square = PlanarTwin.dot(ux, uz, ux, uz);
    }

    /** Neither is an oval, and the way is not zero. */
    static PlanarMeeting of(boolean roundA, PlanarTwin a, boolean roundB, PlanarTwin b, double dx, double dz) {
        PlanarMeeting meeting = new PlanarMeeting(dx, dz);
        if (roundA || roundB) {
            Twofold radius = a.radius.plus(b.radius);
            meeting.grown(roundA ? a : b, roundA ? 1 : -1, radius, roundA ? b : a);
        } else {
            meeting.corners(a, 1, b);
            meeting.corners(b, -1, a);
        }
        meeting.find(roundA && roundB, roundA || roundB, a.size() + b.size());
        return meeting;
    }

    private void corners(PlanarTwin mover, int way, PlanarTwin rest) {
        for (int k = 0; k < mover.x.length; k++) {
            for (int m = 0; m < rest.x.length; m++) {
                line(mover, k, way, rest, m, Twofold.ZERO);
            }
        }
    }

    private void grown(PlanarTwin disc, int way, Twofold radius, PlanarTwin rest) {
        for (int m = 0; m < rest.x.length; m++) {
            circle(disc, way, radius, rest, m);
            if (rest.x.length > 1) {
                line(disc, 0, way, rest, m, radius);
                line(disc, 0, way, rest, m, radius.negated());
            }
        }
    }

    // Where the corner k comes to the line of the side m, drawn outwards by so much.
    private void line(PlanarTwin mover, int k, int way, PlanarTwin rest, int m, Twofold out) {
        int n = (m + 1) % rest.x.length;
        Twofold ex = rest.x[n].minus(rest.x[m]);
        Twofold ez = rest.z[n].minus(rest.z[m]);
        Twofold wx = rest.x[m].minus(mover.x[k]);
        Twofold wz = rest.z[m].minus(mover.z[k]);
        Twofold vx = ux.times(way);
        Twofold vz = uz.times(way);
        Twofold turn = PlanarTwin.cross(vx, vz, ex, ez);
        double size = mover.size() + rest.size();
        if (turn.signum() == 0) {
            if (out.signum() == 0 && PlanarTwin.cross(vx, vz, wx, wz).signum() == 0) {
                add(mover, k, way, PlanarTwin.dot(vx, vz, wx, wz).over(square), size * 0x1p-96, false);
            }
            return;
        }
        Twofold length = PlanarTwin.dot(ex, ez, ex, ez).root();
        Twofold off = out.signum() == 0 ? Twofold.ZERO : out.times(length);
        Twofold time = PlanarTwin.cross(wx, wz, ex, ez).plus(off).over(turn);
        Twofold x = vx.times(time).minus(wx);
        Twofold z = vz.times(time).minus(wz);
        Twofold along = PlanarTwin.dot(x, z, ex, ez);
        double whole = length.head() * length.head();
        if (along.head() >= -BESIDE * whole && along.minus(length.times(length)).head() <= BESIDE * whole) {
            add(mover, k, way, time, size * 0x1p-94 * length.head() / Math.abs(turn.head()), false);
        }
    }

    private void circle(PlanarTwin disc, int way, Twofold radius, PlanarTwin rest, int m) {
        Twofold vx = ux.times(way);
        Twofold vz = uz.times(way);
        Twofold wx = rest.x[m].minus(disc.x[0]);
        Twofold wz = rest.z[m].minus(disc.z[0]);
        Twofold ahead = PlanarTwin.dot(wx, wz, vx, vz);
        Twofold aside = PlanarTwin.cross(vx, vz, wx, wz);
        Twofold chord = radius.times(radius).times(square).minus(aside.times(aside));
        if (chord.signum() < 0) {
            return;
        }
        Twofold half = chord.root();
        double size = disc.size() + rest.size();
        double e = 0x1p-94 * size * size;
        double error = Math.min(Math.sqrt(e), e * Math.sqrt(square.head()) / half.head()) / Math.sqrt(square.head());
        add(disc, 0, way, ahead.minus(half).over(square), error, true);
    }

    private void add(PlanarTwin mover, int k, int way, Twofold t, double error, boolean isRound) {
        if (t.signum() >= 0) {
            double share = way > 0 ? t.head() : 0;
            hits.add(new Hit(
                    t,
                    error,
                    way > 0,
                    isRound,
                    mover.x[k].head() + share * ux.head(),
                    mover.z[k].head() + share * uz.head()));
        }
    }

    private void find(boolean discs, boolean isRound, double size) {
        Hit first = null;
        for (Hit hit : hits) {
            if (first == null || hit.time.isBelow(first.time)) {
                first = hit;
            }
        }
        if (first == null) {
            return;
        }
        time = first.time;
        error = first.error;
        if (discs) {
            return;
        }
        double near = CLOSE * size;
        boolean more = false;
        boolean elsewhere = false;
        for (Hit hit : hits) {
            if (hit.time.minus(time).head() * Math.sqrt(square.head()) <= near) {
                more |= isRound ? hit.isRound != first.isRound : hit.ofMover != first.ofMover;
                elsewhere |= !isRound && Math.abs(hit.x - first.x) + Math.abs(hit.z - first.z) > 2 * near;
            }
        }
        if (isRound) {
            feature = more ? "where a side ends" : first.isRound ? "at a corner" : "at a side";
        } else {
            feature = elsewhere || more
                    ? "corner on corner or side on side"
                    : first.ofMover ? "its corner on a side" : "its side on a corner";
        }
    }
}
