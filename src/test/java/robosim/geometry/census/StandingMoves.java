package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;

/**
 * Straight moves of a box that starts in contact with a box or in an overlap, beside another one. All corners are whole numbers of
 * units: in adversarial cases far from the origin, where the unit is the last bit of a coordinate.
 *
 * <p>The twin knows no planes of shapes: for a direction of given signs the corners that lie farthest are known, so that for
 * each choice of signs it asks for a direction that a few whole-number inequalities hold for.
 */
final class StandingMoves implements Kernel {
    private static final double UNIT = 0x1p-12;
    private static final String[] CONTACTS = {"", "face", "edge", "corner"};

    /** A box of whole numbers: least and greatest on each axis. */
    private record Box(long[] low, long[] high) {}

    private enum Start {
        APART,
        TOUCHING,
        OVERLAPPING
    }

    private final Dimension dimension;
    private final int[] axes;
    private final Geometry world;

    StandingMoves(Dimension dimension) {
        this.dimension = dimension;
        world = new Geometry(0x1p42, 0x1p42, 0x1p42, dimension, Accuracy.EXACT);
        axes = dimension == Dimension.PLANAR ? new int[] {0, 2} : new int[] {0, 1, 2};
    }

    @Override
    public String name() {
        return "straight move from contact, boxes, " + dimension.name().toLowerCase(java.util.Locale.ROOT);
    }

    @Override
    public List<String> regimes() {
        List<String> regimes =
                new ArrayList<>(List.of("apart", "overlap, free", "overlap, blocked", "contact, nothing in the way"));
        for (int k = 1; k <= axes.length; k++) {
            String contact = CONTACTS[k + 3 - axes.length];
            for (String outcome : List.of("into", "next behind the plane", "next in the way")) {
                regimes.add(contact + ", " + outcome);
            }
        }
        return regimes;
    }

    @Override
    public Visit ask(SplittableRandom random, boolean adversarial) {
        int up = axes[random.nextInt(axes.length)];
        int kind = random.nextInt(21);
        Box mover = box(random, up, 0, 1, adversarial);
        Box piece = piece(random, mover, up, kind, adversarial);
        int aim = random.nextInt(7);
        long[] way = way(random, up, kind, adversarial);
        if (aim < 2) {
            goInto(way, mover, piece, random);
        } else if (aim < 6) {
            way[up] = 0;
        }
        Box next = next(random, mover, up, way, aim == 2 || aim == 3, adversarial);
        double base = adversarial ? 0x1p40 : 0;
        double unit = adversarial ? UNIT : 0x1p-3;

        boolean isAdded = world.addObjectUnchecked(object(piece, base, unit).named("piece"))
                && world.addObjectUnchecked(object(next, base, unit).named("next"))
                && world.addObjectUnchecked(object(mover, base, unit).moveable("mover"));
        if (!isAdded) {
            throw new IllegalStateException("the world must be large enough");
        }
        Move move = new Move(unit * way[0], unit * way[1], unit * way[2], 0, 0);
        MoveResult result = world.moveGlobal("mover", move);

        List.of("piece", "next", "mover").forEach(world::removeObject);

        List<Box> others = List.of(piece, next);
        boolean isBlocked = false;
        for (Box other : others) {
            isBlocked |= blocks(mover, way, other) && !isBehind(mover, way, others, other);
        }
        boolean isRight = result.allowed() != isBlocked && (result.allowed() || result.fraction() < 1);
        String regime = regime(mover, way, piece, next, isBlocked);
        return isRight
                ? Visit.right(regime)
                : Visit.wrong(
                        regime,
                        "%s by %s beside %s and %s: %s"
                                .formatted(
                                        object(mover, base, unit),
                                        move,
                                        object(piece, base, unit),
                                        object(next, base, unit),
                                        result));
    }

    private String regime(Box mover, long[] way, Box piece, Box next, boolean isBlocked) {
        Start start = start(mover, piece);
        String outcome = isBlocked ? "blocked" : "free";
        if (start == Start.OVERLAPPING || start(mover, next) == Start.OVERLAPPING) {
            return "overlap, " + outcome;
        }
        if (start == Start.APART) {
            return "apart";
        }
        int flush = 0;
        for (int axis : axes) {
            long shared = Math.min(mover.high[axis], piece.high[axis]) - Math.max(mover.low[axis], piece.low[axis]);
            flush += shared == 0 ? 1 : 0;
        }
        // What is flat may be flush on more axes than it is wide on.
        String contact = CONTACTS[Math.max(1, flush) + 3 - axes.length];
        if (blocks(mover, way, piece)) {
            return contact + ", into";
        }
        if (!blocks(mover, way, next)) {
            return "contact, nothing in the way";
        }
        return contact + (isBlocked ? ", next in the way" : ", next behind the plane");
    }

    private Box box(SplittableRandom random, int up, long least, int side, boolean adversarial) {
        long[] low = new long[3];
        long[] high = new long[3];
        for (int axis = 0; axis < 3; axis++) {
            long half = random.nextInt(12) == 0 ? 0 : random.nextInt(2, 40) * (adversarial ? 100L : 1);
            low[axis] = axis == up ? (side > 0 ? least : least - 2 * half) : -half + random.nextInt(-20, 21);
            high[axis] = low[axis] + 2 * half;
        }
        return new Box(low, high);
    }

    /** Under the level that the mover stands on, flush on so many axes; or apart, or in it. */
    private Box piece(SplittableRandom random, Box mover, int up, int kind, boolean adversarial) {
        long least = kind < 2 ? random.nextInt(1, 30) : kind < 3 ? -random.nextInt(1, 30) : 0;
        Box piece = box(random, up, least, -1, adversarial);
        int flush = kind < (axes.length == 2 ? 13 : 11) ? 0 : kind < 16 ? 1 : 2;
        for (int axis : axes) {
            if (axis == up) {
                continue;
            }
            long size = piece.high[axis] - piece.low[axis];
            if (flush-- > 0) {
                piece.low[axis] = random.nextBoolean() ? mover.high[axis] : mover.low[axis] - size;
                piece.high[axis] = piece.low[axis] + size;
            }
        }
        return piece;
    }

    private long[] way(SplittableRandom random, int up, int kind, boolean adversarial) {
        long[] way = new long[3];
        long scale = adversarial ? 100 : 1;
        for (int axis = 0; axis < 3; axis++) {
            way[axis] = random.nextInt(4) == 0 ? 0 : scale * random.nextInt(-150, 151) + random.nextInt(-2, 3);
        }
        way[up] = switch (random.nextInt(kind < 3 ? 2 : 6)) {
            case 0 -> way[up];
            case 1 -> random.nextInt(-1, 2);
            default -> 0;
        };
        return way;
    }

    /** On each axis towards the middle of a piece, if only by a unit. */
    private static void goInto(long[] way, Box mover, Box piece, SplittableRandom random) {
        for (int axis = 0; axis < 3; axis++) {
            long ahead = piece.low[axis] + piece.high[axis] - mover.low[axis] - mover.high[axis];
            way[axis] = Long.signum(ahead) * (random.nextBoolean() ? 1 : random.nextInt(1, 100));
        }
    }

    /** Somewhere on the way, under the level or, most of them if so wanted, out of it by a little. */
    private Box next(SplittableRandom random, Box mover, int up, long[] way, boolean isOut, boolean adversarial) {
        long top = isOut ? random.nextInt(1, 3) : random.nextInt(4) == 0 ? random.nextInt(-1, 3) : 0;
        Box next = box(random, up, top, -1, adversarial);
        for (int axis = 0; axis < 3; axis++) {
            if (axis != up) { // large enough to be met
                next.low[axis] -= 20;
                next.high[axis] += 20;
            }
        }
        double share = random.nextInt(3) == 0 ? 0.3 + 0.7 * random.nextDouble() : 1;
        for (int axis = 0; axis < 3; axis++) {
            if (axis != up) {
                long by = Math.round(share * way[axis]) + (mover.low[axis] + mover.high[axis]) / 2;
                next.low[axis] += by;
                next.high[axis] += by;
            }
        }
        return next;
    }

    private static BoxObject object(Box box, double base, double unit) {
        double[] middle = new double[3];
        double[] size = new double[3];
        for (int k = 0; k < 3; k++) {
            middle[k] = base + unit * ((box.low[k] + box.high[k]) / 2);
            size[k] = unit * (box.high[k] - box.low[k]);
        }
        return new BoxObject(new Point(middle[0], middle[1], middle[2]), size[0], size[1], size[2]);
    }

    // The twin.

    private Start start(Box a, Box b) {
        for (int axis : axes) {
            if (a.low[axis] > b.high[axis] || b.low[axis] > a.high[axis]) {
                return Start.APART;
            }
        }
        return hasBetween(a, new long[3], b, b) ? Start.TOUCHING : Start.OVERLAPPING;
    }

    private boolean blocks(Box mover, long[] way, Box other) {
        boolean moves = false;
        for (int axis : axes) {
            moves |= way[axis] != 0;
        }
        if (!moves) {
            return false;
        }
        return switch (start(mover, other)) {
            case APART -> meets(mover, way, other);
            case TOUCHING -> !hasBetween(mover, way, other, other);
            case OVERLAPPING -> isAgainstLeast(mover, way, other);
        };
    }

    private boolean isBehind(Box mover, long[] way, List<Box> others, Box other) {
        return others.stream().anyMatch(p -> start(mover, p) == Start.TOUCHING && hasBetween(mover, way, p, other));
    }

    /** Whether the times, from 0 to 1, at which the two share a place on each axis have one in common. */
    private boolean meets(Box mover, long[] way, Box other) {
        long[] from = {0, 1};
        long[] to = {1, 1};
        for (int axis : axes) {
            long enter = other.low[axis] - mover.high[axis];
            long leave = other.high[axis] - mover.low[axis];
            long speed = way[axis];
            if (speed == 0) {
                if (enter > 0 || leave < 0) {
                    return false;
                }
                continue;
            }
            long first = speed > 0 ? enter : -leave;
            long last = speed > 0 ? leave : -enter;
            long under = Math.abs(speed);
            from = first * from[1] > from[0] * under ? new long[] {first, under} : from;
            to = last * to[1] < to[0] * under ? new long[] {last, under} : to;
        }
        return from[0] * to[1] <= to[0] * from[1];
    }

    private boolean isAgainstLeast(Box mover, long[] way, Box other) {
        long least = Long.MAX_VALUE;
        boolean against = true;
        for (int axis : axes) {
            for (int side = -1; side <= 1; side += 2) {
                long depth = side > 0 ? other.high[axis] - mover.low[axis] : mover.high[axis] - other.low[axis];
                boolean isAgainst = side * way[axis] < 0;
                if (depth < least) {
                    least = depth;
                    against = isAgainst;
                } else if (depth == least) {
                    against &= isAgainst;
                }
            }
        }
        return against;
    }

    /** Whether a plane has a box on its way on its upper side and two others on its lower, all closed. */
    private boolean hasBetween(Box mover, long[] way, Box one, Box two) {
        int n = axes.length;
        for (int signs = 0; signs < 1 << n; signs++) {
            long[][] limits = new long[4 + n][n]; // each is to have a product of at most 0 with the direction
            for (int k = 0; k < n; k++) {
                boolean positive = (signs >> k & 1) != 0;
                int axis = axes[k];
                long mine = positive ? mover.low[axis] : mover.high[axis];
                long first = positive ? one.high[axis] : one.low[axis];
                long second = positive ? two.high[axis] : two.low[axis];
                limits[0][k] = first - mine;
                limits[1][k] = second - mine;
                limits[2][k] = first - mine - way[axis];
                limits[3][k] = second - mine - way[axis];
                limits[4 + k][k] = positive ? -1 : 1;
            }
            if (n == 2 ? hasDirection(limits) : hasDirectionInSpace(limits)) {
                return true;
            }
        }
        return false;
    }

    private static boolean hasDirection(long[][] limits) {
        for (long[] limit : limits) {
            if (holds(limits, -limit[1], limit[0], 0) || holds(limits, limit[1], -limit[0], 0)) {
                return true;
            }
        }
        return false;
    }

    private static boolean hasDirectionInSpace(long[][] limits) {
        for (int i = 0; i < limits.length; i++) {
            for (int j = i + 1; j < limits.length; j++) {
                long[] a = limits[i];
                long[] b = limits[j];
                long x = a[1] * b[2] - a[2] * b[1];
                long y = a[2] * b[0] - a[0] * b[2];
                long z = a[0] * b[1] - a[1] * b[0];
                if (holds(limits, x, y, z) || holds(limits, -x, -y, -z)) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean holds(long[][] limits, long x, long y, long z) {
        if (x == 0 && y == 0 && z == 0) {
            return false;
        }
        for (long[] limit : limits) {
            if (limit[0] * x + limit[1] * y + (limit.length > 2 ? limit[2] * z : 0) > 0) {
                return false;
            }
        }
        return true;
    }
}
