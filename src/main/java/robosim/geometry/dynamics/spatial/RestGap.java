package robosim.geometry.dynamics.spatial;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import robosim.geometry.engine.motion.Placer;
import robosim.geometry.model.Pose;

/**
 * Parts bodies from what others have put them in contact with, by as much as bodies rest apart: no direction separates what
 * touches, so it could never be carried. The border of the world counts too, although it may be touched.
 *
 * <p>Each body moves up or aside first. Bodies between others that they overlap by rounding cannot do that alone: of these,
 * all that touch each other are spread. If a direction n separates two convex bodies and the centre of each is within it, then
 * n points from one centre to the other, so both are farther apart if all centres are scaled by 1 + s about any point: by s
 * times the sum of their half widths along n.
 */
final class RestGap {
    /** How far a body goes from what it was put in contact with. */
    private static final double APART = 1.5 * TurningSweep.GAP;

    /** Nearer than this, bodies are spread together, metres. */
    private static final double TOGETHER = 4 * TurningSweep.GAP;

    /** The spread is doubled so often, for bodies that are flat. */
    private static final int MOST_DOUBLINGS = 4;

    /** Points to spread from: three along each axis. */
    private static final int ANCHORS = 27;

    /** Ways to go where up is not enough. */
    private static final double[] SIDES = {1, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1, 0, 0, -1, 0};

    private final List<RigidBody> bodies;
    private final Placer placer;
    private final TurningSweep way;
    private final ContactDetection detection;
    private final double[] gravity;
    private final double[] behind = new double[Pose.PLACE];
    private final double[] anchor = new double[3];
    private final double[] low = new double[3];
    private final double[] high = new double[3];
    private final List<RigidBody> together = new ArrayList<>();
    private final List<double[]> starts = new ArrayList<>();

    RestGap(List<RigidBody> bodies, Placer placer, TurningSweep way, ContactDetection detection, double[] gravity) {
        this.bodies = bodies;
        this.placer = placer;
        this.way = way;
        this.detection = detection;
        this.gravity = gravity;
    }

    /** Parts all bodies from what they touch, where there is room. */
    void loosen() {
        bodies.forEach(this::aside);
        BitSet seen = new BitSet();
        for (int b = 0; b < bodies.size(); b++) {
            if (!seen.get(b) && !isClear(bodies.get(b))) {
                gather(b, seen);
                if (together.size() > 1) {
                    spread();
                }
            }
        }
    }

    /** Moves a body up, and to each side, from what it touches there. */
    private void aside(RigidBody body) {
        double g = RigidBody.length(gravity, 0);
        aside(body, g > 0 ? -gravity[0] / g : 0, g > 0 ? -gravity[1] / g : 1, g > 0 ? -gravity[2] / g : 0);
        for (int side = 0; side < SIDES.length; side += 3) {
            aside(body, SIDES[side], SIDES[side + 1], SIDES[side + 2]);
        }
    }

    /** Moves a body along a direction if it touches anything, or hardly more than touches what is behind it. */
    private void aside(RigidBody body, double x, double y, double z) {
        System.arraycopy(body.place, 0, behind, 0, Pose.PLACE);
        behind[0] -= TurningSweep.GAP / 2 * x;
        behind[1] -= TurningSweep.GAP / 2 * y;
        behind[2] -= TurningSweep.GAP / 2 * z;
        if (!placer.isFree(body.id, body.place) || !placer.isFree(body.id, behind)) {
            way.lift(body, APART * x, APART * y, APART * z);
        }
    }

    /** Whether a body is far enough from all else to be carried. */
    private boolean isClear(RigidBody body) {
        return placer.isFree(body.id, body.place) && detection.apart(body) > 0;
    }

    /** Finds the bodies that touch a body, those that touch them, and so on. */
    private void gather(int first, BitSet seen) {
        BitSet reached = new BitSet();
        reached.set(first);
        together.clear();
        starts.clear();
        for (int b = first; b >= 0; b = reached.nextSetBit(0)) {
            reached.clear(b);
            seen.set(b);
            RigidBody body = bodies.get(b);
            together.add(body);
            starts.add(body.place.clone());
            detection.neighbours(body, TOGETHER, reached);
            reached.andNot(seen);
        }
    }

    /** Spreads the bodies found last from the first point that makes all of them clear, else leaves them where they are. */
    private void spread() {
        double smallest = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Double.POSITIVE_INFINITY;
            high[axis] = Double.NEGATIVE_INFINITY;
        }
        for (RigidBody body : together) {
            smallest = Math.min(smallest, body.reach);
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], body.place[axis] - body.reach);
                high[axis] = Math.max(high[axis], body.place[axis] + body.reach);
            }
        }
        for (int k = 0; k < ANCHORS; k++) {
            choose(k);
            double share = APART / (2 * smallest);
            for (int doubling = 0; doubling <= MOST_DOUBLINGS; doubling++) {
                place(share);
                if (together.stream().allMatch(this::isClear)) {
                    return;
                }
                share *= 2;
            }
        }
        place(0);
    }

    /** Chooses a point to spread from: below the middle first. */
    private void choose(int k) {
        int which = k;
        for (int axis = 0; axis < 3; axis++) {
            double below = gravity[axis] > 0 ? high[axis] : low[axis];
            double above = gravity[axis] > 0 ? low[axis] : high[axis];
            double middle = 0.5 * (below + above);
            boolean isLevel = gravity[axis] == 0;
            anchor[axis] =
                    which % 3 == 0 ? (isLevel ? middle : below) : which % 3 == 1 ? (isLevel ? below : middle) : above;
            which /= 3;
        }
    }

    /** Puts the bodies where they are if their distances from the point are scaled by 1 and a share. */
    private void place(double share) {
        for (int k = 0; k < together.size(); k++) {
            RigidBody body = together.get(k);
            System.arraycopy(starts.get(k), 0, body.place, 0, Pose.PLACE);
            for (int axis = 0; axis < 3; axis++) {
                body.place[axis] += share * (body.place[axis] - anchor[axis]);
            }
            placer.put(body.id, body.place);
        }
    }
}
