package robosim.geometry.junit;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import robosim.geometry.MoveResult;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Text;

/** Numbers, places and refusals as a failure tells them. */
final class Words {
    private static final MathContext DIGITS = new MathContext(9);

    private Words() {}

    /** As short as it can be without being another number. */
    static String number(double value) {
        String text = String.valueOf(value);
        return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
    }

    /** To nine digits: where things are, for people. */
    private static String rounded(double value) {
        return new BigDecimal(value).round(DIGITS).stripTrailingZeros().toPlainString();
    }

    /** A number that was found, in so few digits as tell it from the one that was asked for. */
    static String apart(double found, double asked) {
        String few = rounded(found);
        return few.equals(number(asked)) ? number(found) : few;
    }

    static String point(Point point) {
        return "(" + rounded(point.x()) + ", " + rounded(point.y()) + ", " + rounded(point.z()) + ")";
    }

    static String place(GeometryObject object) {
        return "at " + point(object.center()) + ", heading " + rounded(object.heading());
    }

    /** As in {@code box "wall 3" at (4, 0, 0)}; null is the border. */
    static String object(@Nullable GeometryObject object) {
        if (object == null) {
            return "the border of the world";
        }
        String kind = object.kind().name().toLowerCase(Locale.ROOT);
        String name = object.name();
        return kind + (name == null ? " without a name" : " " + Text.quoted(name)) + " at " + point(object.center());
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

    /** What blocks a move, and after how much of it. */
    static String blocked(Move move, MoveResult result) {
        double length = Math.sqrt(move.x() * move.x() + move.y() * move.y() + move.z() * move.z());
        String after = result.fraction() < 1
                ? rounded(result.fraction() * length) + " of " + rounded(length)
                : rounded(result.turnFraction()) + " of its turn";
        Point contact = result.contact();
        return "blocked after " + after + " by " + object(result.obstacle())
                + (contact == null ? "" : ", where it touches " + point(contact));
    }
}
