package robosim.geometry;

import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.Scratch;

/** How far a leg of a motion may go so that two leaves stay a clearance apart. */
final class StandOff {
    private final Phase phase;
    private final Distance distance;
    private final double[] box = new double[6];

    StandOff(Phase phase, Scratch scratch) {
        this.phase = phase;
        distance = new Distance(scratch);
    }

    /** The greatest share up to contact at which leaf i of the mover and leaf j are still as far apart as the clearance. */
    double share(Level level, int i, int j, double contact, double clearance) {
        if (gap(level, 0, i, j) < clearance) {
            return 0;
        }
        return phase.turns() ? ofTurn(level, i, j, contact, clearance) : ofTranslation(level, i, j, contact, clearance);
    }

    /** The gap of convex leaves is a convex function of the way, so it falls all the way to contact. */
    private double ofTranslation(Level level, int i, int j, double contact, double clearance) {
        double low = 0;
        double high = contact;
        for (int halving = 0; halving < 80 && low < Math.nextDown(high); halving++) {
            double middle = low / 2 + high / 2;
            if (gap(level, middle, i, j) >= clearance) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Back from contact, each time by as little as the missing gap could be made up in. */
    private double ofTurn(Level level, int i, int j, double contact, double clearance) {
        level.boundsOf(phase.atStart, 0, phase.atStart.size(), box);
        double reach = 0;
        for (int k = 0; k < 3; k++) {
            double far = Math.max(Math.abs(box[k] - phase.start[k]), Math.abs(box[3 + k] - phase.start[k]));
            reach += far * far;
        }
        double way = Math.sqrt(reach) * phase.angle() * (Math.PI / 180);
        double free = contact;
        for (int step = 0; step < 1000 && free > 0; step++) {
            double missing = clearance - gap(level, free, i, j);
            if (missing <= 0) {
                return free;
            }
            free -= Math.max(missing / way, 0x1p-52);
        }
        return 0;
    }

    private double gap(Level level, double share, int i, int j) {
        return distance.between(level.dimension, phase.after(share), i, level.leaves(), j, Double.POSITIVE_INFINITY);
    }
}
