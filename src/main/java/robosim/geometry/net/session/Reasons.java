package robosim.geometry.net.session;

import org.jspecify.annotations.Nullable;
import robosim.geometry.MoveResult;
import robosim.geometry.check.NumberText;
import robosim.geometry.check.Text;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.world.shared.ObjectNames;

/** Describes in words why a request was refused, or what a user should know of one that was carried out. */
public final class Reasons {
    /** Of a length in words. */
    private static final int DIGITS = 4;

    private Reasons() {}

    /** As in {@code blocked by "wall 3" after 0.25 of the way}. */
    public static String of(MoveResult result) {
        return "blocked by " + obstacle(result.obstacle()) + " after " + way(result);
    }

    /** What an exception says, in one line. */
    public static String of(IllegalArgumentException e) {
        return e.getMessage() == null ? e.getClass().getSimpleName() : Text.line(e.getMessage());
    }

    /** A body that fell onto the lower border of its world. */
    public static String ofFall(String name, double drop) {
        return Text.quoted(name) + " has fallen " + NumberText.digits(drop, DIGITS)
                + " onto the lower border of the world; if it should stand on a floor, add one to the world, or make the"
                + " world PLANAR";
    }

    private static String obstacle(@Nullable GeometryObject obstacle) {
        if (obstacle == null) {
            return "the border of the world";
        }
        String name = obstacle.name();
        return name != null ? Text.quoted(name) : ObjectNames.of(obstacle);
    }

    private static String way(MoveResult result) {
        return result.fraction() < 1
                ? share(result.fraction()) + " of the way"
                : share(result.turnFraction()) + " of the turn";
    }

    /** Rounded down to a thousandth. */
    private static String share(double fraction) {
        return NumberText.places(Math.floor(1000 * fraction) / 1000, 3);
    }
}
