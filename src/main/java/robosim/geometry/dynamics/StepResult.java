package robosim.geometry.dynamics;

import java.util.List;
import robosim.geometry.exact.Checks;

/**
 * What happened in a step.
 *
 * @param contacts the collisions, in the order of their times
 * @param stopped  the bodies that were stopped because their motion could not be decided within the bound of events or could
 *                 not be carried out without an overlap; mostly empty. They stand where they are free
 */
public record StepResult(List<BodyContact> contacts, List<String> stopped) {
    /** Takes copies of the lists. */
    public StepResult {
        contacts = Checks.list("contacts", contacts);
        stopped = Checks.list("stopped", stopped);
    }
}
