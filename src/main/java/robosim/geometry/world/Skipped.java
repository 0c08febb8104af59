package robosim.geometry.world;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import robosim.geometry.world.shared.LeftOut;

/**
 * A part of a file that was left out of the world although it may be relevant.
 *
 * @param source the file that contains it
 * @param line   its line, from 1; 0 if it has none
 * @param what   what it is, by its name in the file
 * @param reason why it was left out, and what can be done about it
 */
public record Skipped(String source, int line, String what, String reason) {
    static Skipped of(LeftOut each) {
        return new Skipped(each.source(), each.line(), each.what(), each.reason());
    }

    /** Parts that are named before the others of the same reason are only counted. */
    private static final int MOST_NAMED = 3;

    /** Messages of which each tells a reason once, with the first of the parts that it is the reason for. */
    static List<String> joined(List<Skipped> all) {
        Map<String, List<Skipped>> byReason = new LinkedHashMap<>();
        for (Skipped each : all) {
            int got = each.reason.lastIndexOf(" (got: ");
            String reason = got < 0 ? each.reason : each.reason.substring(0, got);
            byReason.computeIfAbsent(each.source + "\n" + reason, key -> new ArrayList<>())
                    .add(each);
        }
        List<String> messages = new ArrayList<>();
        byReason.forEach((key, same) -> {
            Skipped first = same.get(0);
            String named = same.stream().limit(MOST_NAMED).map(Skipped::what).collect(Collectors.joining(", "));
            String more = same.size() > MOST_NAMED ? " and " + (same.size() - MOST_NAMED) + " more" : "";
            String reason = same.size() == 1 ? first.reason : key.substring(key.indexOf('\n') + 1);
            messages.add(new Skipped(first.source, first.line, named + more, reason).toString());
        });
        return messages;
    }

    /** As a message: file, line, what and why. */
    @Override
    public String toString() {
        return new LeftOut(source, line, what, reason).toString();
    }
}
