package robosim.geometry;

import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.LeafColumn;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.Sweep;

/** How far a leg of a motion may go so that a piece of the mover and one that it would meet stay a clearance apart. */
final class StandOff implements Sweep.Stop {
    private final Phase phase;
    private final Distance distance;
    private final double[] box = new double[6];
    private final LeafColumn own = new LeafColumn(1);
    private final LeafColumn other = new LeafColumn(1);

    private Level level;
    private int leaf;
    private int otherLeaf;
    private double clearance;

    @SuppressWarnings("NullAway.Init") // a question begins with its leaves
    StandOff(Phase phase, Scratch scratch) {
        this.phase = phase;
        distance = new Distance(scratch);
    }

    /** From now on it is about leaf i of the mover and leaf j. */
    StandOff of(Level inLevel, int i, int j, double gap) {
        level = inLevel;
        leaf = i;
        otherLeaf = j;
        clearance = gap;
        return this;
    }

    /** The greatest share up to contact at which the two are still as far apart as the clearance. */
    @Override
    public double share(int t, int u, double contact, double least) {
        other.setPiece(level.leaves(), otherLeaf, u);
        if (gap(0, t) < clearance) {
            return 0;
        }
        return phase.turns() ? ofTurn(t, contact) : ofTranslation(t, contact, least);
    }

    /** The gap of convex pieces is a convex function of the way, so it falls all the way to contact. */
    private double ofTranslation(int t, double contact, double least) {
        double low = 0;
        double high = contact;
        if (least < contact) {
            if (gap(least, t) >= clearance) {
                return contact;
            }
            high = least;
        }
        for (int halving = 0; halving < 80 && low < Math.nextDown(high); halving++) {
            double middle = low / 2 + high / 2;
            if (gap(middle, t) >= clearance) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Back from contact, each time by as little as the missing gap could be made up in. */
    private double ofTurn(int t, double contact) {
        level.boundsOf(phase.atStart, 0, phase.atStart.size(), box);
        double reach = 0;
        for (int k = 0; k < 3; k++) {
            double far = Math.max(Math.abs(box[k] - phase.start[k]), Math.abs(box[3 + k] - phase.start[k]));
            reach += far * far;
        }
        double way = Math.sqrt(reach) * phase.angle() * (Math.PI / 180);
        double free = contact;
        for (int step = 0; step < 1000 && free > 0; step++) {
            double missing = clearance - gap(free, t);
            if (missing <= 0) {
                return free;
            }
            free -= Math.max(missing / way, 0x1p-52);
        }
        return 0;
    }

    private double gap(double share, int t) {
        own.setPiece(phase.after(share), leaf, t);
        return distance.between(level.dimension, own, 0, other, 0, Double.POSITIVE_INFINITY);
    }
}
