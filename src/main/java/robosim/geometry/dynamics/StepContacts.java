package robosim.geometry.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.dynamics.planar.ContactLog;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/** Makes the result of a step from what its log and that of the step before have. */
final class StepContacts {
    private StepContacts() {}

    static StepResult result(ContactLog now, ContactLog before, Runnable betweenParts) {
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
        List<StepResult.Stop> stops = new ArrayList<>(now.stops());
        for (int k = 0; k < now.stops(); k++) {
            stops.add(stop(now, k));
        }
        List<String> stopped = stops.stream().map(StepResult.Stop::body).toList();
        return new StepResult(contacts, stopped, ended, stops);
    }

    private static StepResult.Stop stop(ContactLog of, int k) {
        StepResult.Reason reason = switch (of.cause(k)) {
            case COLLISIONS -> StepResult.Reason.COLLISIONS;
            case BLOCKED -> StepResult.Reason.BLOCKED;
            case OVERLAP -> StepResult.Reason.OVERLAP;
        };
        @Nullable GeometryObject other = of.stopper(k);
        return new StepResult.Stop(of.stopped(k), reason, other == null ? null : other.name());
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
