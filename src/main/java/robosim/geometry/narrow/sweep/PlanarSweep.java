package robosim.geometry.narrow.sweep;

import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.sat.AxisBody;
import robosim.geometry.narrow.sat.ExactAxes;

/** The motion of one leaf's projection on XZ against another's at rest. */
public final class PlanarSweep {
    private PlanarSweep() {}

    /**
     * Time of the first contact when leaf a is translated by (dx, dz) during the time from 0 to 1.
     *
     * <p>If the two touch or overlap at the start there is no later contact, since convex sets that separate along a
     * line stay apart; then it is only decided whether the motion goes deeper at once, against every direction of least
     * penetration.
     *
     * @param dy ignored: heights do not count
     * @return the time of impact, from 0 to 1, rounded down; 0 if a motion from contact goes deeper; {@code +Infinity}
     *     if there is no contact up to time 1 (touching at time 1 counts), or a motion from contact goes along or away
     */
    public static double translation(
            LeafKind kindA,
            double[] a,
            int i,
            double dx,
            double dy,
            double dz,
            LeafKind kindB,
            double[] b,
            int j,
            SweepScratch s) {
        if (kindA.isEnclosure() && kindB.isEnclosure()) {
            return MovingPrism.time(true, a, i, dx, 0, dz, b, j);
        }
        if (kindA.isPolytope()) {
            if (kindB.isPolytope()) {
                double time = s.sweep().axes.time(AxisBody.Mode.PLANAR, kindA, a, i, dx, 0, dz, kindB, b, j);
                return Double.isNaN(time)
                        ? ExactAxes.time(AxisBody.Mode.PLANAR, kindA, a, i, dx, 0, dz, kindB, b, j)
                        : time;
            }
            if (kindB.isDisc()) {
                return disc(b, j, -dx, -dz, kindA, a, i, s);
            }
        } else if (kindA.isDisc() && (kindB.isDisc() || kindB.isPolytope())) {
            return disc(a, i, dx, dz, kindB, b, j, s);
        }
        return s.sweep().move.time(true, kindA, a, i, dx, 0, dz, kindB, b, j, s);
    }

    private static double disc(
            double[] a, int i, double dx, double dz, LeafKind kindB, double[] b, int j, SweepScratch s) {
        double time = roughly(a, i, dx, dz, kindB, b, j, s);
        if (!Double.isNaN(time)) {
            return time;
        }
        return ExactDisc.of(a, i, dx, dz, kindB, b, j, null).time();
    }

    /** Time of contact of a disc in the plane; NaN if double-doubles cannot decide. */
    static double roughly(double[] a, int i, double dx, double dz, LeafKind kindB, double[] b, int j, SweepScratch s) {
        MovingDisc disc = s.sweep().disc;
        return kindB.isDisc()
                ? disc.discs(a, i, dx, dz, b, j, s.sweep().outline)
                : disc.polygon(a, i, dx, dz, kindB, b, j, s.sweep().outline);
    }
}
