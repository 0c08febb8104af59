package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Point;

/**
 * Pushes a moveable object from outside: by an impulse before a step, by a force all through it, or by both. One without a body
 * gets {@link BodyRequest#of one}.
 *
 * @param objectName a moveable object
 * @param impulse    newton seconds along the world's axes; null for none
 * @param force      newtons along the world's axes; null for none
 * @param at         where both act, in the world; null for the object's centre
 */
public record PushRequest(
        String objectName,
        @Nullable Point impulse,
        @Nullable Point force,
        @Nullable Point at) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses null for the name, and a push of neither kind. */
    public PushRequest {
        Checks.present("objectName", objectName);
        check("impulse", impulse);
        check("force", force);
        if (impulse == null && force == null) {
            throw new IllegalArgumentException(
                    "impulse or force must be given (got: neither, for \"" + objectName + "\")");
        }
    }

    private static void check(String argument, @Nullable Point push) {
        if (push != null) {
            Amounts.finite(argument + ".x", push.x());
            Amounts.finite(argument + ".y", push.y());
            Amounts.finite(argument + ".z", push.z());
        }
    }

    /** An impulse through the centre. */
    public static PushRequest impulse(String objectName, Point newtonSeconds) {
        return new PushRequest(objectName, newtonSeconds, null, null);
    }

    /** A force through the centre. */
    public static PushRequest force(String objectName, Point newtons) {
        return new PushRequest(objectName, null, newtons, null);
    }
}
