package robosim.geometry.dynamics;

import java.util.List;
import robosim.geometry.exact.Checks;

/**
 * What happened in a step.
 *
 * @param contacts who collided or touches, one entry for each two objects and each face ({@link BodyContact}): those that
 *                 collided in the order of their times, then those that only touch at the end
 * @param stopped  the bodies that were stopped because their motion could not be decided within the bound of events or could
 *                 not be carried out without an overlap; mostly empty. They stand where they are free
 * @param ended    the contacts of the step before that are none any more
 */
public record StepResult(List<BodyContact> contacts, List<String> stopped, List<BodyContact> ended) {
    /** Takes copies of the lists. */
    public StepResult {
        contacts = Checks.list("contacts", contacts);
        stopped = Checks.list("stopped", stopped);
        ended = Checks.list("ended", ended);
    }

    /** A step in which no contact has ended. */
    public StepResult(List<BodyContact> contacts, List<String> stopped) {
        this(contacts, stopped, List.of());
    }
}
