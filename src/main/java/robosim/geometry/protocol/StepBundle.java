package robosim.geometry.protocol;

import java.io.Serial;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.BodyContact;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Twist;
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
        this(seconds, bodies, commands, null, null);
    }

    /** A step in which everything goes on as before. */
    public static StepBundle of(double seconds) {
        return new StepBundle(seconds, List.of(), List.of());
    }

    /** This step, before which an object gets a body: that of a solid of its shape. */
    public StepBundle withBody(String objectName) {
        return with(BodyRequest.of(objectName));
    }

    /**
     * This step, before which an object gets a body.
     *
     * @param drive what drives it; its command does not count. Null for what it had
     */
    public StepBundle withBody(String objectName, Body body, @Nullable Drive drive) {
        return with(BodyRequest.of(objectName, Checks.present("body", body), drive));
    }

    private StepBundle with(BodyRequest body) {
        return new StepBundle(seconds, appended(bodies, body), commands, mixing, pushes);
    }

    /**
     * This step with commands for robots, each the motion that its drive should reach: m/s forward and to the right, and degrees a
     * second.
     *
     * @param motions by the names of the robots, in the order of the map; not for a car or a drive by forces, whose numbers are
     *                others
     */
    public StepBundle withMotions(Map<String, Twist> motions) {
        List<DriveCommand> all = new ArrayList<>(commands);
        Checks.present("motions", motions)
                .forEach((name, motion) ->
                        all.add(new DriveCommand(name, motion.x(), motion.z(), Degrees.toRadians(motion.ry()))));
        return new StepBundle(seconds, bodies, all, mixing, pushes);
    }

    /**
     * This step with a push.
     *
     * @param impulse newton seconds along the world's axes, before the step; null for none
     * @param force   newtons along the world's axes, all through the step; null for none
     * @param at      where both act, in the world; null for the object's centre
     */
    public StepBundle withPush(String objectName, @Nullable Point impulse, @Nullable Point force, @Nullable Point at) {
        return new StepBundle(
                seconds, bodies, commands, mixing, appended(pushes, new PushRequest(objectName, impulse, force, at)));
    }

    /** This step, from which on surfaces are combined by other rules. */
    public StepBundle withMixing(Surface.Mixing restitution, Surface.Mixing friction) {
        Checks.present("restitution", restitution);
        Checks.present("friction", friction);
        return new StepBundle(seconds, bodies, commands, SurfaceMixing.of(restitution, friction), pushes);
    }

    private static <T> List<T> appended(List<T> list, T last) {
        List<T> all = new ArrayList<>(list);
        all.add(last);
        return all;
    }

    /** The names of the objects that get a body before the step, in order. */
    public List<String> bodyNames() {
        return bodies.stream().map(BodyRequest::objectName).toList();
    }

    /** The commands of the step as {@link #withMotions} takes them; of several for one robot the last. */
    public Map<String, Twist> motions() {
        Map<String, Twist> motions = new LinkedHashMap<>();
        for (DriveCommand each : commands) {
            motions.put(each.objectName(), new Twist(each.forward(), 0, each.right(), Degrees.toDegrees(each.turn())));
        }
        return motions;
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

        /** Where each body is, by its name, in the order in which they became bodies. */
        public Map<String, Pose> places() {
            Map<String, Pose> places = new LinkedHashMap<>();
            bodies.forEach(each -> places.put(each.objectName(), each.pose()));
            return places;
        }

        /** How fast each body moves, by its name: along its own axes, in metres and degrees a second. */
        public Map<String, Twist> velocities() {
            Map<String, Twist> velocities = new LinkedHashMap<>();
            bodies.forEach(
                    each -> velocities.put(each.objectName(), each.velocity().twist()));
            return velocities;
        }

        /** Who touched whom, and which bodies were stopped, as a step of {@link robosim.geometry.dynamics.Dynamics} reports it. */
        public StepResult result() {
            Map<Boolean, List<BodyContact>> byEnd = contacts.stream()
                    .map(ContactAnswer::contact)
                    .collect(Collectors.partitioningBy(each -> each.phase() == BodyContact.Phase.END));
            return new StepResult(
                    byEnd.getOrDefault(false, List.of()),
                    stopped,
                    byEnd.getOrDefault(true, List.of()),
                    stops.stream().map(StopAnswer::stop).toList());
        }

        @Override
        public boolean isAnswer() {
            return true;
        }
    }
}
