package robosim.geometry.junit;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import robosim.geometry.net.session.BodyStepper;
import robosim.geometry.net.session.FallDetector;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.PushRequest;
import robosim.geometry.protocol.motion.StopAnswer;

/** The bodies of a test's world: what they were given and told, and what they met so far. */
final class Bodies {
    private final Map<String, BodyRequest> given = new LinkedHashMap<>();
    private final Map<String, DriveCommand> told = new LinkedHashMap<>();

    /** What changed since the last step. */
    private final Map<String, DriveCommand> news = new LinkedHashMap<>();

    private final List<PushRequest> pushes = new ArrayList<>();
    private final List<Meeting> meetings = new ArrayList<>();

    /** Why bodies were stopped last, by their names, and in which step of the clock. */
    private final Map<String, StopAnswer> stops = new HashMap<>();

    private final Map<String, Long> stopSteps = new HashMap<>();
    private final BodyStepper motion;
    private StepBundle.Answer last = new StepBundle.Answer(List.of(), List.of(), List.of());

    /**
     * Two that met.
     *
     * @param step of the clock
     * @param fall the fall of the body that ended in that step; null if none did
     */
    record Meeting(long step, ContactAnswer contact, FallDetector.@Nullable Fall fall) {
        boolean isOf(String name) {
            return contact.objectName().equals(name) || name.equals(contact.other());
        }

        boolean isBetween(String name, String other) {
            return !name.equals(other) && isOf(name) && isOf(other);
        }

        /** What the one met; null for what has no name. */
        @Nullable
        String other(String name) {
            return contact.objectName().equals(name) ? contact.other() : contact.objectName();
        }
    }

    Bodies(BodyStepper motion) {
        this.motion = motion;
    }

    /** The same bodies, with their velocities and commands, in a world that was changed by other means. */
    Bodies again(BodyStepper other) {
        Bodies again = new Bodies(other);
        again.given.putAll(given);
        again.told.putAll(told);
        again.news.putAll(news);
        again.pushes.addAll(pushes);
        again.meetings.addAll(meetings);
        again.stops.putAll(stops);
        again.stopSteps.putAll(stopSteps);
        again.last = last;
        return again;
    }

    /** The request by which a new session comes to where this one is, with the bodies that are still there. */
    StepBundle anew() {
        List<BodyRequest> all = new ArrayList<>();
        for (BodyAnswer body : last.bodies()) {
            String name = body.objectName();
            if (motion.has(name)) {
                all.add(of(name).withVelocity(body.velocity()));
            } else {
                given.remove(name);
            }
        }
        told.keySet().removeIf(name -> !motion.has(name));
        return new StepBundle(0, all, List.copyOf(told.values()));
    }

    void give(BodyRequest body) {
        given.put(body.objectName(), body);
    }

    BodyRequest of(String name) {
        return given.getOrDefault(name, BodyRequest.of(name));
    }

    void tell(DriveCommand command) {
        news.put(command.objectName(), command);
    }

    void push(PushRequest push) {
        pushes.add(push);
    }

    /** Where a body was after the last step, and its velocity; null if there is no such body. */
    @Nullable
    BodyAnswer answer(String name) {
        return last.bodies().stream()
                .filter(body -> body.objectName().equals(name))
                .findFirst()
                .orElse(null);
    }

    /** The contacts of the last step in which a body takes part. */
    List<ContactAnswer> contacts(String name) {
        return last.contacts().stream()
                .filter(each -> each.objectName().equals(name) || name.equals(each.other()))
                .toList();
    }

    /** The next step; what robots were told since the last one comes with it. */
    StepBundle next(double seconds) {
        told.putAll(news);
        StepBundle step = new StepBundle(seconds, List.of(), List.copyOf(news.values()), null, List.copyOf(pushes));
        news.clear();
        pushes.clear();
        return step;
    }

    /** Carries out a step as a session does. */
    Reply run(StepBundle step, long clock) {
        Map<Integer, String> reasons = new TreeMap<>();
        last = motion.step(step, reasons::put);
        Map<String, FallDetector.Fall> falls = motion.falls();
        for (ContactAnswer contact : last.contacts()) {
            meetings.add(new Meeting(clock, contact, falls.get(contact.objectName())));
        }
        for (StopAnswer stop : last.stops()) {
            stops.put(stop.objectName(), stop);
            stopSteps.put(stop.objectName(), clock);
        }
        List<Problem> problems = new ArrayList<>();
        reasons.forEach((index, reason) -> problems.add(Problem.of(index, reason)));
        return new Reply(last, problems);
    }

    boolean has(String name) {
        return last.bodies().stream().anyMatch(body -> body.objectName().equals(name));
    }

    List<Meeting> meetings() {
        return meetings;
    }

    /** When and why a body was last stopped because its motion could not be decided, for a message; empty if it never was. */
    String lastStop(String name) {
        StopAnswer stop = stops.get(name);
        return stop == null ? "" : "; step " + stopSteps.get(name) + " stopped " + stop.text();
    }
}
