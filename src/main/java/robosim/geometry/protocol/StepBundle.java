package robosim.geometry.protocol;

import java.io.Serial;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.PushRequest;
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
 * @param pushes   impulses before the step and forces all through it, which act once
 */
public record StepBundle(
        double seconds,
        List<BodyRequest> bodies,
        List<DriveCommand> commands,
        @Nullable SurfaceMixing mixing,
        List<PushRequest> pushes)
        implements Bundle {
    @Serial
    private static final long serialVersionUID = 1;

    /** The longest step, seconds. */
    public static final double MAX_SECONDS = 3600;

    /** Refuses seconds that are out of range, and null, except for pushes: requests of older peers have none. */
    public StepBundle(
            double seconds,
            List<BodyRequest> bodies,
            List<DriveCommand> commands,
            @Nullable SurfaceMixing mixing,
            @Nullable List<PushRequest> pushes) {
        if (!(seconds >= 0 && seconds <= MAX_SECONDS)) { // written so that NaN fails it
            throw new IllegalArgumentException(
                    "seconds must be a number from 0 to " + (int) MAX_SECONDS + " (got: " + seconds + ")");
        }
        this.seconds = seconds + 0.0;
        this.bodies = Checks.copy("bodies", bodies, BodyRequest.class);
        this.commands = Checks.copy("commands", commands, DriveCommand.class);
        this.mixing = mixing;
        this.pushes = pushes == null ? List.of() : Checks.copy("pushes", pushes, PushRequest.class);
    }

    /** A step by the rules for surfaces so far. */
    public StepBundle(double seconds, List<BodyRequest> bodies, List<DriveCommand> commands) {
        this(seconds, bodies, commands, null);
    }

    /** A step without pushes. */
    public StepBundle(
            double seconds, List<BodyRequest> bodies, List<DriveCommand> commands, @Nullable SurfaceMixing mixing) {
        this(seconds, bodies, commands, mixing, List.of());
    }

    /** How many bodies, commands and pushes there are. */
    public int size() {
        return bodies.size() + commands.size() + pushes.size();
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
