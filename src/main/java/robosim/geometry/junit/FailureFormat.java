package robosim.geometry.junit;

import java.math.BigDecimal;
import java.math.MathContext;
import org.jspecify.annotations.Nullable;
import robosim.geometry.MoveResult;
import robosim.geometry.check.NumberText;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.ObjectNames;

/**
 * Formats numbers, places and refusals for failure messages: without rounding noise, and so that two numbers that a
 * message compares never look the same.
 */
final class FailureFormat {
    /** The precision of measured numbers. */
    private static final MathContext FOUND = new MathContext(9);

    /** The precision of numbers given in a test: longer than any literal that a person writes, and 0.1 + 0.2 is 0.3. */
    private static final MathContext ASKED = new MathContext(12);

    private static final MathContext DIFFERENCE = new MathContext(2);

    private FailureFormat() {}

    static String number(double value) {
        return NumberText.digits(value, ASKED.getPrecision());
    }

    static String found(double value) {
        return NumberText.digits(value, FOUND.getPrecision());
    }

    private static BigDecimal exactly(double value) {
        return new BigDecimal(value);
    }

    /** A measured number next to a given one: the text is on the same side of it as the number, and not equal. */
    static String apart(double found, double asked) {
        if (found == asked || !Double.isFinite(found) || !Double.isFinite(asked)) {
            return found(found);
        }
        int told = exactly(found).round(FOUND).compareTo(exactly(asked).round(ASKED));
        if (Integer.signum(told) == Double.compare(found, asked)) {
            return found(found);
        }
        BigDecimal off = exactly(found).subtract(exactly(asked)).abs().round(DIFFERENCE);
        return (found < asked ? "just under " : "just over ") + number(asked) + " (by " + NumberText.of(off) + ")";
    }

    /** A part of a whole; anything less than the whole is not shown as the whole, nor anything above zero as zero. */
    private static String share(double share, double whole) {
        if (share == 0) {
            return "0";
        }
        double part = share * whole;
        BigDecimal told = exactly(part).round(FOUND);
        if (share < 1 && told.compareTo(exactly(whole).round(ASKED)) >= 0) {
            return "just under " + number(whole);
        }
        return share < 1e-9 ? "just over 0" : NumberText.of(told);
    }

    /**
     * A place.
     *
     * @param size the size of the object there: a billionth of it, or of the largest coordinate, is rounded away
     */
    static String point(Point point, double size) {
        BigDecimal scale = exactly(Math.max(largest(point), size));
        int decimals = FOUND.getPrecision() - scale.precision() + scale.scale();
        return "(" + NumberText.places(point.x(), decimals) + ", " + NumberText.places(point.y(), decimals) + ", "
                + NumberText.places(point.z(), decimals) + ")";
    }

    static String place(GeometryObject object) {
        return "at " + center(object) + ", heading " + NumberText.places(object.heading(), FOUND.getPrecision());
    }

    static String center(GeometryObject object) {
        return point(object.center(), object.bounds().size());
    }

    private static double largest(Point point) {
        return Math.max(Math.max(Math.abs(point.x()), Math.abs(point.y())), Math.abs(point.z()));
    }

    /** As in {@code box "wall 3" at (4, 0, 0)}; null stands for the world's bounds. */
    static String object(@Nullable GeometryObject object) {
        if (object == null) {
            return "the border of the world";
        }
        String words = ObjectNames.kindAndName(object);
        // The centre of a map says nothing about its walls.
        return object.kind() == GeometryObject.Kind.GRID ? words : words + " at " + center(object);
    }

    static String steps(long count) {
        return NumberText.count(count, "step");
    }

    /** As in {@code drive 2} or {@code turn by 90}. */
    static String move(Move move) {
        boolean turns = move.rx() != 0 || move.ry() != 0;
        boolean goes = move.x() != 0 || move.y() != 0 || move.z() != 0;
        String turn = "turn by " + number(move.ry()) + (move.rx() == 0 ? "" : " and tip by " + number(move.rx()));
        if (turns && !goes) {
            return turn;
        }
        String way = move.y() == 0 && move.z() == 0
                ? "drive " + number(move.x())
                : "move by (" + number(move.x()) + ", " + number(move.y()) + ", " + number(move.z()) + ")";
        return way + (turns ? " and " + turn : "");
    }

    /** What blocks a move, and after which part of it. */
    static String blocked(Move move, MoveResult result) {
        double length = Math.sqrt(move.x() * move.x() + move.y() * move.y() + move.z() * move.z());
        String after = result.fraction() < 1
                ? share(result.fraction(), length) + " of " + number(length)
                : share(result.turnFraction(), 1) + " of its turn";
        Point contact = result.contact();
        GeometryObject obstacle = result.obstacle();
        return "blocked after " + after + " by " + object(obstacle)
                + (contact == null
                        ? ""
                        : ", where it touches "
                                + point(
                                        contact,
                                        obstacle == null ? 0 : obstacle.bounds().size()));
    }
}
