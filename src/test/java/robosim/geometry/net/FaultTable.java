package robosim.geometry.net;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Faults tried and survived, by kind. */
final class FaultTable {
    private final Map<String, int[]> rows = new TreeMap<>();
    private final List<String> failures = new ArrayList<>();

    /** Enters one fault; {@code failure} is empty where it was survived. */
    synchronized void enter(String kind, String failure) {
        int[] counts = rows.computeIfAbsent(kind, key -> new int[2]);
        counts[0]++;
        if (failure.isEmpty()) {
            counts[1]++;
        } else {
            failures.add(kind + ": " + failure);
        }
    }

    /** What went wrong, in words. */
    synchronized List<String> failures() {
        return List.copyOf(failures);
    }

    synchronized int tried() {
        return rows.values().stream().mapToInt(counts -> counts[0]).sum();
    }

    synchronized String markdown() {
        StringBuilder table = new StringBuilder("| fault | tried | survived |\n|---|---:|---:|\n");
        rows.forEach((kind, counts) -> table.append("| %s | %d | %d |%n".formatted(kind, counts[0], counts[1])));
        return table.toString();
    }
}
