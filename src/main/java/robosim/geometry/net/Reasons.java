package robosim.geometry.net;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import robosim.geometry.MoveResult;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Text;

/** Describes in words why a move was refused. */
final class Reasons {
    private Reasons() {}

    /** As in {@code blocked by "wall 3" after 0.25 of the way}. */
    static String of(MoveResult result) {
        return "blocked by " + obstacle(result.obstacle()) + " after " + way(result);
    }

    private static String obstacle(@Nullable GeometryObject obstacle) {
        if (obstacle == null) {
            return "the border of the world";
        }
        String name = obstacle.name();
        if (name != null) {
            return Text.quoted(name);
        }
        Point center = obstacle.center();
        return "a " + obstacle.kind().name().toLowerCase(Locale.ROOT) + " at (" + coordinate(center.x()) + ", "
                + coordinate(center.y()) + ", " + coordinate(center.z()) + ")";
    }

    /** A coordinate to a thousandth; the same text on every JVM, unlike Double.toString. */
    private static String coordinate(double value) {
        return new BigDecimal(value)
                .setScale(3, RoundingMode.HALF_EVEN)
                .stripTrailingZeros()
                .toPlainString();
    }

    private static String way(MoveResult result) {
        return result.fraction() < 1
                ? share(result.fraction()) + " of the way"
                : share(result.turnFraction()) + " of the turn";
    }

    /** A fraction rounded down to a thousandth, without trailing zeros; the same text on every JVM. */
    private static String share(double fraction) {
        int thousandths = (int) (1000 * fraction);
        if (thousandths % 1000 == 0) {
            return String.valueOf(thousandths / 1000);
        }
        return "0." + String.valueOf(1000 + thousandths).substring(1).replaceAll("0+$", "");
    }
}
