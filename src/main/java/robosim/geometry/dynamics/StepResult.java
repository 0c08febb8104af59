package robosim.geometry.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.dynamics.planar.ContactLog;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * What happened in a step.
 *
 * @param contacts who collided or touches, one entry for each two objects and each face ({@link BodyContact}): those that
 *                 collided in the order of their times, then those that only touch at the end
 * @param stopped  the names of the bodies that were stopped, in the order in which they became bodies; mostly empty. They stand
 *                 where they are free
 * @param ended    the contacts of the step before that are none any more
 * @param stops    why each body in {@code stopped} was, in the same order; empty in a result that was made without reasons
 */
public record StepResult(List<BodyContact> contacts, List<String> stopped, List<BodyContact> ended, List<Stop> stops) {
    /** Why a body was stopped. */
    public enum Reason {
        /** It collided more often than a step allows for a body, or impulses and friction found no balance. */
        COLLISIONS,
        /** It could not be moved: the other object is in the way, or no proof was found that it is not. */
        BLOCKED,
        /** In a SPATIAL world: it overlapped the other object when the step began, so no motion of it could be decided. */
        OVERLAP
    }

    /**
     * A body that was stopped: it lost its velocity, or half of it in a SPATIAL world.
     *
     * @param body   its name
     * @param reason the first one in the step
     * @param other  the name of what stopped it; null for an object without a name, for the world's bounds, and if it is unknown
     */
    public record Stop(String body, Reason reason, @Nullable String other) {
        /** Refuses null where it has no meaning. */
        public Stop {
            Checks.present("body", body);
            Checks.present("reason", reason);
        }
    }

    /** Takes copies of the lists. */
    public StepResult {
        contacts = Checks.list("contacts", contacts);
        stopped = Checks.list("stopped", stopped);
        ended = Checks.list("ended", ended);
        stops = Checks.list("stops", stops);
    }

    /** A step whose result gives no reasons why bodies were stopped. */
    public StepResult(List<BodyContact> contacts, List<String> stopped, List<BodyContact> ended) {
        this(contacts, stopped, ended, List.of());
    }

    /** A step in which no contact has ended. */
    public StepResult(List<BodyContact> contacts, List<String> stopped) {
        this(contacts, stopped, List.of());
    }

    /** What happened according to the log of a step and that of the step before. */
    static StepResult of(ContactLog now, ContactLog before, Runnable betweenParts) {
        List<BodyContact> contacts = new ArrayList<>(now.count());
        for (int k = 0; k < now.count(); k++) {
            betweenParts.run();
            contacts.add(contact(now, k, now.isOld(k) ? BodyContact.Phase.LAST : BodyContact.Phase.BEGIN));
        }
        List<BodyContact> ended = new ArrayList<>();
        for (int k = 0; k < before.count(); k++) {
            betweenParts.run();
            if (!before.goesOn(k)) {
                ended.add(contact(before, k, BodyContact.Phase.END));
            }
        }
        List<Stop> stops = new ArrayList<>(now.stops());
        for (int k = 0; k < now.stops(); k++) {
            stops.add(stop(now, k));
        }
        List<String> stopped = stops.stream().map(Stop::body).toList();
        return new StepResult(contacts, stopped, ended, stops);
    }

    private static Stop stop(ContactLog of, int k) {
        Reason reason = switch (of.cause(k)) {
            case COLLISIONS -> Reason.COLLISIONS;
            case BLOCKED -> Reason.BLOCKED;
            case OVERLAP -> Reason.OVERLAP;
        };
        @Nullable GeometryObject other = of.stopper(k);
        return new Stop(of.stopped(k), reason, other == null ? null : other.name());
    }

    private static BodyContact contact(ContactLog of, int k, BodyContact.Phase phase) {
        @Nullable GeometryObject other = of.other(k);
        return new BodyContact(
                of.body(k),
                other == null ? null : other.name(),
                new Point(of.point(k, 0), of.point(k, 1), of.point(k, 2)),
                new Point(of.normal(k, 0), of.normal(k, 1), of.normal(k, 2)),
                phase == BodyContact.Phase.END ? 0 : of.impulse(k),
                phase);
    }
}
