package robosim.geometry.scenario;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Text;
import robosim.geometry.protocol.StepBundle;

/** Finds where the answer to a step differs, and says so: the first body, contact or stop that is another. */
final class StepMismatch {
    private StepMismatch() {}

    /** Compares two answers that are not equal; null if they differ only in reasons that the expected one does not give. */
    static @Nullable Mismatch of(long number, Step step, StepBundle.Answer expected, StepBundle.Answer got) {
        if (!expected.bodies().equals(got.bodies())) {
            return differ(number, step, "bodies", expected.bodies(), got.bodies());
        }
        if (!expected.contacts().equals(got.contacts())) {
            return differ(number, step, "contacts", expected.contacts(), got.contacts());
        }
        if (!expected.stopped().equals(got.stopped())) {
            return differ(number, step, "stopped", expected.stopped(), got.stopped());
        }
        return expected.stops().isEmpty() ? null : differ(number, step, "stops", expected.stops(), got.stops());
    }

    private static Mismatch differ(long number, Step step, String what, List<?> wanted, List<?> answered) {
        int first = 0;
        while (first < wanted.size()
                && first < answered.size()
                && wanted.get(first).equals(answered.get(first))) {
            first++;
        }
        String place = what + "[" + first + "]: ";
        return Mismatch.whole(number, step, place + at(wanted, first), at(answered, first));
    }

    private static String at(List<?> items, int index) {
        return index < items.size() ? Text.line(String.valueOf(items.get(index))) : "no more";
    }
}
