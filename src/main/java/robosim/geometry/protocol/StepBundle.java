package robosim.geometry.protocol;

import java.io.Serial;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.StopAnswer;
import robosim.geometry.protocol.motion.SurfaceMixing;

/**
 * A request to let time pass: bodies move as they are driven, slide, push and bounce, and never overlap. Answered by an
 * {@link Answer}.
 *
 * @param seconds  how long, from 0 to an hour; 0 moves nothing, and gives bodies and commands, or asks where they are
 * @param bodies   given to objects before the step; what was given before stays
 * @param commands what robots are told to do from the beginning of the step on; what they were told before stays
 * @param mixing   how the surfaces of two objects make that of their contact from this step on; null for the rules so far
 */
public record StepBundle(
        double seconds,
        List<BodyRequest> bodies,
        List<DriveCommand> commands,
        @Nullable SurfaceMixing mixing) implements Bundle {
    @Serial
    private static final long serialVersionUID = 1;

    /** The longest step, seconds. */
    public static final double MAX_SECONDS = 3600;

    /** Refuses null, and seconds that are out of range. */
    public StepBundle {
        if (!(seconds >= 0 && seconds <= MAX_SECONDS)) { // written so that NaN fails it
            throw new IllegalArgumentException(
                    "seconds must be a number from 0 to " + (int) MAX_SECONDS + " (got: " + seconds + ")");
        }
        seconds += 0.0;
        bodies = Checks.copy("bodies", bodies, BodyRequest.class);
        commands = Checks.copy("commands", commands, DriveCommand.class);
    }

    /** A step by the rules for surfaces so far. */
    public StepBundle(double seconds, List<BodyRequest> bodies, List<DriveCommand> commands) {
        this(seconds, bodies, commands, null);
    }

    /** How many bodies and commands there are. */
    public int size() {
        return bodies.size() + commands.size();
    }

    /**
     * The answer.
     *
     * @param bodies   all bodies of the world, in the order in which they became bodies
     * @param contacts who collided or touches, one for each two objects, and of a mesh, a group, a grid or the border one for
     *                 each normal along which it is touched: those that collided in the order of their times, those that only touch, and then those that part
     * @param stopped  bodies that were stopped because their motion could not be decided or carried out without an overlap
     * @param stops    why each of these was stopped, in the same order; empty where a peer gives no reasons
     */
    public record Answer(
            List<BodyAnswer> bodies, List<ContactAnswer> contacts, List<String> stopped, List<StopAnswer> stops)
            implements Bundle {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses null, but for the reasons: answers of older peers have none. */
        public Answer(
                List<BodyAnswer> bodies,
                List<ContactAnswer> contacts,
                List<String> stopped,
                @Nullable List<StopAnswer> stops) {
            this.bodies = Checks.copy("bodies", bodies, BodyAnswer.class);
            this.contacts = Checks.copy("contacts", contacts, ContactAnswer.class);
            this.stopped = Checks.copy("stopped", stopped, String.class);
            this.stops = stops == null ? List.of() : Checks.copy("stops", stops, StopAnswer.class);
        }

        /** An answer without reasons. */
        public Answer(List<BodyAnswer> bodies, List<ContactAnswer> contacts, List<String> stopped) {
            this(bodies, contacts, stopped, List.of());
        }

        @Override
        public boolean isAnswer() {
            return true;
        }
    }
}
