package robosim.geometry.bench;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** What the module and the engines printed in all JVMs and turns: medians with their spread, and ratios. */
final class PeerTable {
    /** One peer's measure of one workload and size. */
    private record Key(String peer, String work, String size) {
        boolean isOfSameWork(Key that) {
            return work.equals(that.work) && size.equals(that.size);
        }
    }

    /** One peer's turns in one JVM or beside it. */
    private record Place(Key key, int fork, boolean beside) {}

    private final Map<Place, List<Double>> turns = new LinkedHashMap<>();

    /** The rest of a line, as it came last. */
    private final Map<Key, String> rests = new LinkedHashMap<>();

    private final List<String> facts = new ArrayList<>();
    private int forks;
    private boolean hasBeside;

    /** A line {@code peer workload size ns hits checksum build_ms ...}. */
    void add(String line, int fork, boolean beside) {
        String[] words = line.split(" ", -1);
        Key key = new Key(words[0], words[1], words[2]);
        turns.computeIfAbsent(new Place(key, fork, beside), none -> new ArrayList<>())
                .add(Double.parseDouble(words[3]));
        String rest = String.join(" ", Arrays.copyOfRange(words, 4, 7));
        for (String word : words) {
            rest += word.startsWith("mem_mb=") ? " " + word : "";
        }
        rests.put(key, rest);
        forks = Math.max(forks, fork + 1);
        hasBeside |= beside;
    }

    void addFact(String line) {
        facts.add(line);
    }

    /** A line for each measure, each ratio and each fact. */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        for (Key key : rests.keySet()) {
            double[] alone = medians(key, false);
            lines.add(String.format(
                    Locale.ROOT,
                    "%s %s %s %.1f %s least=%.1f most=%.1f%s",
                    key.peer,
                    key.work,
                    key.size,
                    Timing.median(alone),
                    rests.get(key),
                    least(alone),
                    most(alone),
                    hasBeside ? String.format(Locale.ROOT, " beside=%.1f", Timing.median(medians(key, true))) : ""));
        }
        for (boolean beside : hasBeside ? new boolean[] {false, true} : new boolean[] {false}) {
            for (Key own : rests.keySet()) {
                if (own.peer.equals(Workload.MODULE)) {
                    addRatios(own, beside, lines);
                }
            }
        }
        lines.addAll(facts);
        return lines;
    }

    private void addRatios(Key own, boolean beside, List<String> lines) {
        double[] ours = medians(own, beside);
        for (Key other : rests.keySet()) {
            if (other.isOfSameWork(own) && !other.equals(own)) {
                double[] theirs = medians(other, beside);
                double[] ratios = new double[ours.length];
                Arrays.setAll(ratios, k -> ours[k] / theirs[k]);
                lines.add(String.format(
                        Locale.ROOT,
                        "ratio %s %s %.3f x %s, %.3f to %.3f in %d JVMs%s",
                        own.work,
                        own.size,
                        Timing.median(ratios),
                        other.peer,
                        least(ratios),
                        most(ratios),
                        forks,
                        beside ? ", beside a neighbour that sweeps through memory" : ""));
            }
        }
    }

    /** The median of the turns in each JVM. */
    private double[] medians(Key key, boolean beside) {
        double[] medians = new double[forks];
        for (int fork = 0; fork < forks; fork++) {
            medians[fork] = Timing.median(turns.get(new Place(key, fork, beside)).stream()
                    .mapToDouble(Double::doubleValue)
                    .toArray());
        }
        return medians;
    }

    private static double least(double[] values) {
        return Arrays.stream(values).min().orElseThrow();
    }

    private static double most(double[] values) {
        return Arrays.stream(values).max().orElseThrow();
    }
}
