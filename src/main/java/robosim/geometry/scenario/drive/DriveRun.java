package robosim.geometry.scenario.drive;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.check.Text;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.StopAnswer;
import robosim.geometry.scenario.ScenarioWriter;
import robosim.geometry.scenario.Step;
import robosim.geometry.world.World;
import robosim.geometry.world.shared.ObjectNames;

/** Robots that are driven through a world for a time, as a conversation that can be recorded. */
public final class DriveRun {
    /** What a body met that stands on the lower border of the world. */
    public static final String GROUND = "the ground";

    private final Session session;
    private final @Nullable ScenarioWriter record;
    private final Map<String, Track> tracks = new LinkedHashMap<>();
    private final Map<String, StopAnswer> stopped = new LinkedHashMap<>();
    private double time;
    private long steps;
    private long contacts;

    /** What happened to a body. */
    public static final class Track {
        private final BodyAnswer first;
        private BodyAnswer last;
        private double way;
        private long met;
        private double firstMet = Double.NaN;
        private final Set<String> others = new LinkedHashSet<>();

        private Track(BodyAnswer first) {
            this.first = first;
            this.last = first;
        }

        private void goesTo(BodyAnswer now) {
            double dx = now.center().x() - last.center().x();
            double dy = now.center().y() - last.center().y();
            double dz = now.center().z() - last.center().z();
            way += Math.sqrt(dx * dx + dy * dy + dz * dz);
            last = now;
        }

        private void meets(String other, double time) {
            firstMet = met++ == 0 ? time : firstMet;
            others.add(other);
        }

        public BodyAnswer first() {
            return first;
        }

        public BodyAnswer last() {
            return last;
        }

        /** The length of its way, from step to step. */
        public double way() {
            return way;
        }

        /** How many contacts of it began. */
        public long met() {
            return met;
        }

        /** When the first one began, seconds, at the end of that step; NaN if none did. */
        public double firstMet() {
            return firstMet;
        }

        /** What it met, each once, in words: a name in quotes, or what is meant. */
        public Set<String> others() {
            return others;
        }
    }

    /**
     * Begins in a world as its file has it.
     *
     * @param record takes the conversation; null for none
     * @throws IllegalArgumentException if a body or a command cannot be given
     */
    public DriveRun(World world, List<BodyRequest> bodies, List<DriveCommand> commands, @Nullable ScenarioWriter record)
            throws IOException {
        this.session = new Session(SessionOptions.ROBOSIM, SessionListener.NONE, "drive");
        this.record = record;
        InitBundle init = WorldOpening.init(world);
        session.reply(init);
        write(new Step(init, null));
        List<BodyRequest> all = new ArrayList<>(WorldBodies.of(world));
        Set<String> given = new LinkedHashSet<>();
        bodies.forEach(body -> given.add(body.objectName()));
        all.removeIf(body -> given.contains(body.objectName()));
        all.addAll(bodies);
        StepBundle.Answer begin = carryOut(new StepBundle(0, all, commands));
        begin.bodies().forEach(body -> tracks.put(body.objectName(), new Track(body)));
    }

    /** Lets time pass, in one step. */
    public void step(double seconds) throws IOException {
        StepBundle.Answer answer = carryOut(new StepBundle(seconds, List.of(), List.of()));
        time += seconds;
        steps++;
        for (BodyAnswer body : answer.bodies()) {
            Objects.requireNonNull(tracks.get(body.objectName())).goesTo(body);
        }
        for (ContactAnswer contact : answer.contacts()) {
            if (contact.phase() == ContactAnswer.Phase.BEGIN) {
                contacts++;
                String other = contact.other();
                meet(contact.objectName(), other == null ? nameless(contact) : Text.quoted(other));
                if (other != null) {
                    meet(other, Text.quoted(contact.objectName()));
                }
            }
        }
        answer.stops().forEach(stop -> stopped.putIfAbsent(stop.objectName(), stop));
    }

    private void meet(String name, String other) {
        Track track = tracks.get(name);
        if (track != null) {
            track.meets(other, time);
        }
    }

    private String nameless(ContactAnswer contact) {
        Geometry world = Objects.requireNonNull(session.world());
        if (Nameless.isGround(world, contact)) {
            return GROUND;
        }
        GeometryObject object = Nameless.at(world, contact.point());
        return object == null ? "the border of the world" : ObjectNames.of(object);
    }

    private StepBundle.Answer carryOut(StepBundle step) throws IOException {
        Reply reply = Objects.requireNonNull(session.reply(step));
        if (!reply.problems().isEmpty()) {
            throw new IllegalArgumentException(reply.problems().get(0).reason());
        }
        write(new Step(step, reply));
        return (StepBundle.Answer) reply.bundle();
    }

    private void write(Step step) throws IOException {
        if (record != null) {
            record.write(step);
        }
    }

    /** What happened to each body so far. */
    public Map<String, Track> tracks() {
        return tracks;
    }

    /** The bodies that were stopped because their motion could not be decided, and why each was for the first time. */
    public Collection<StopAnswer> stopped() {
        return stopped.values();
    }

    /** Seconds so far. */
    public double time() {
        return time;
    }

    public long steps() {
        return steps;
    }

    /** How many contacts began so far. */
    public long contacts() {
        return contacts;
    }
}
