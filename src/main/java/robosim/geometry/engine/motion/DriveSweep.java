package robosim.geometry.engine.motion;

import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Twist;

/**
 * How long an object may move with a constant twist before it comes too near to anything: conservative advancement (Mirtich
 * 1996) in the whole world. From a place at which nothing is nearer than a gap, no point of the object can cross the gap
 * before the time that its fastest point needs for it; so nothing is ever sampled. What comes nearer than a resolution counts
 * as blocking.
 */
final class DriveSweep {
    /** Nearer than this share of the object's size, while approaching, it stops. */
    private static final double RESOLUTION = 0x1p-30;

    /** More than what a stored place is off, as a share of the coordinates. */
    private static final double STORED = 0x1p-46;

    /** Most steps; a path that needs more runs along something at a tiny distance. */
    private static final int MOST_STEPS = 20_000;

    /** Makes a share small enough that a drive for that part of the time is free, though rounded up as below. */
    private static final double USABLE = 1 - 0x1p-38;

    private static final double UP = 1 + 0x1p-40;

    private final double[] half = new double[3];
    private final ClearanceQuery clearance;
    private final double[] place = new double[ObjectTable.PLACE];

    DriveSweep(ClearanceQuery clearance, double width, double height, double length) {
        this.clearance = clearance;
        half[0] = width / 2;
        half[1] = height / 2;
        half[2] = length / 2;
    }

    /**
     * The share of the time that is free, 1 only if all of it is.
     *
     * @param start  where the motion begins, laid out as in the table of objects
     * @param margin how far to stay from everything
     */
    double share(AccuracyView view, int id, double[] start, Twist twist, double seconds, double margin) {
        boolean isLevel = view.dimension == Dimension.SPATIAL
                && twist.y() == 0
                && Attitude.isUpright(start, ObjectTable.ROTATION);
        clearance.ignoreBelow(isLevel);
        try {
            return freeShare(view, id, start, twist, seconds, margin);
        } finally {
            clearance.ignoreBelow(false);
        }
    }

    private double freeShare(AccuracyView view, int id, double[] start, Twist twist, double seconds, double margin) {
        System.arraycopy(start, 0, place, 0, place.length);
        double free = 0;
        double speed = 0;
        double size = 0;
        double before = 0;
        for (int step = 0; step < MOST_STEPS; step++) {
            clearance.at(view, id, place);
            if (step == 0) {
                size = size();
                speed = speed(twist);
            }
            double rest = speed * (seconds - free) * UP;
            double slack = STORED * (size + speed * free);
            double gap = Math.min(
                    clearance.distance(id, rest + margin + slack),
                    borderGap(view.dimension, 2 * (rest + margin + slack)));
            if (step == 0 && !(margin > 0 ? gap >= margin : gap > 0)) {
                return 0;
            }
            double room = gap - margin - slack;
            if (room >= rest) {
                return 1;
            }
            if (!(room > 0) || (room < before && room <= RESOLUTION * size)) {
                break;
            }
            double next = free + room / speed;
            if (!(next > free)) {
                break;
            }
            free = next;
            before = room;
            twist.after(start, 0, free, place);
        }
        return free / seconds * USABLE;
    }

    /** The sum of the magnitudes of the bounds. */
    private double size() {
        double sum = 0;
        for (double bound : clearance.box) {
            sum += Math.abs(bound);
        }
        return sum;
    }

    /** No point of the object is ever faster. */
    private double speed(Twist twist) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double far = Math.max(
                    Math.abs(clearance.box[axis] - place[axis]), Math.abs(clearance.box[3 + axis] - place[axis]));
            square += far * far;
        }
        double along = Math.sqrt(twist.x() * twist.x() + twist.y() * twist.y() + twist.z() * twist.z());
        return (along + Degrees.toRadians(Math.abs(twist.ry())) * Math.sqrt(square)) * UP + Double.MIN_NORMAL;
    }

    /** How far the bounds of the object are from the world's; at most the given number. */
    double borderGap(Dimension dimension, double most) {
        double least = most;
        for (int axis = 0; axis < 3; axis += dimension == Dimension.PLANAR ? 2 : 1) {
            double below = clearance.box[axis] + half[axis];
            double above = half[axis] - clearance.box[3 + axis];
            least = Math.min(least, axis == 1 && isStill(below, above) ? most : Math.min(below, above));
        }
        return least;
    }

    /** A level motion changes no height: it may go along the ground of the world. */
    private boolean isStill(double below, double above) {
        return clearance.isBelowIgnored() && below >= 0 && above >= 0;
    }
}
