package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.dynamics.StepResult;

/**
 * Why a body was stopped in a step.
 *
 * @param objectName the body
 * @param reason     the first one in the step
 * @param other      what stopped it; null for an object without a name, for the border of the world, and if it is unknown
 */
public record StopAnswer(
        String objectName, Reason reason, @Nullable String other) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** Why. */
    public enum Reason {
        /** It collided more often than a step allows for a body, or impulses and friction found no balance. */
        COLLISIONS,
        /** It could not be moved: the other object is in the way, or no proof was found that it is not. */
        BLOCKED,
        /** In a SPATIAL world: it overlapped the other object when the step began. */
        OVERLAP
    }

    /** Refuses null where it has no meaning. */
    public StopAnswer {
        Checks.present("objectName", objectName);
        Checks.present("reason", reason);
    }

    /** A stop as it is sent. */
    public static StopAnswer of(StepResult.Stop stop) {
        return new StopAnswer(stop.body(), Reason.valueOf(stop.reason().name()), stop.other());
    }

    /** The stop. */
    public StepResult.Stop stop() {
        return new StepResult.Stop(objectName, StepResult.Reason.valueOf(reason.name()), other);
    }

    /** The body and why it was stopped, for a message: {@code "crate" (BLOCKED by "wall")}. */
    public String text() {
        String by = other == null ? "" : " by " + Text.quoted(other);
        return Text.quoted(objectName) + " (" + reason + by + ")";
    }
}
