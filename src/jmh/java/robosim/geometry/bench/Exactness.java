package robosim.geometry.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import robosim.geometry.exact.FilterBound;

/**
 * The price of exactness in ordinary scenes: the time of a question with filters and exact paths, over that with the
 * filters' plain signs believed ({@code -Drobosim.geometry.filter=alone}). JVMs of both sorts run in turn, so that a
 * machine that drifts drifts for both; a pair of them gives one ratio for each scene. Told are the geometric mean of the
 * ratios with its interval of 95 % (bootstrap over the pairs) and how many questions in a million came to pairs of doubles
 * and to an exact path. Robots' trips are recorded with exact verdicts, and both sorts are asked the same questions from the
 * same places, but for the legs told as astray, where a wrong verdict had led a robot elsewhere.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test
 * -Dexec.mainClass=robosim.geometry.bench.Exactness}, with {@code -Dexec.args=} the number of pairs, 15 if none is given.
 */
public final class Exactness {
    // Milliseconds for each scene.
    private static final int WARM_UP = 500;
    private static final int MEASURED = 300;
    private static final int SAMPLES = 10_000;

    /** What the JVMs said of a scene. */
    private static final class Row {
        final List<Double> ratios = new ArrayList<>();
        long questions;
        long fine;
        long falls;
        long strayed;
    }

    private Exactness() {}

    /** Runs the pairs and prints a row for each scene, and one for all. */
    public static void main(String[] args) throws IOException {
        int pairs = args.length > 0 && args[0].matches("\\d+") ? Integer.parseInt(args[0]) : 15;
        Path trips = Files.createTempFile("trips", ".txt");
        try {
            OrdinaryScenes.record(trips);
            compare(pairs, trips);
        } finally {
            Files.delete(trips);
        }
    }

    private static void compare(int pairs, Path trips) throws IOException {
        Map<String, Row> rows = new LinkedHashMap<>();
        for (int pair = 0; pair < pairs; pair++) {
            // Now one goes first, now the other.
            boolean exactFirst = pair % 2 == 0;
            List<String[]> first = run(exactFirst ? "on" : "alone", trips);
            List<String[]> second = run(exactFirst ? "alone" : "on", trips);
            List<String[]> exact = exactFirst ? first : second;
            List<String[]> alone = exactFirst ? second : first;
            for (int k = 0; k < exact.size(); k++) {
                Row row = rows.computeIfAbsent(exact.get(k)[0], name -> new Row());
                row.ratios.add(Double.parseDouble(exact.get(k)[1]) / Double.parseDouble(alone.get(k)[1]));
                row.questions += Long.parseLong(exact.get(k)[2]);
                row.fine += Long.parseLong(exact.get(k)[3]);
                row.falls += Long.parseLong(exact.get(k)[4]);
                row.strayed += Long.parseLong(alone.get(k)[5]);
            }
            Timing.print("pair %d of %d", pair + 1, pairs);
        }
        Timing.print("%d pairs of JVMs %s on %s", pairs, Runtime.version(), System.getProperty("os.arch"));
        Timing.print(
                "%-28s %8s %20s %14s %14s %8s",
                "scene", "ratio", "95 % interval", "pairs/million", "exact/million", "astray");
        rows.forEach(Exactness::print);
        print("all", all(rows, pairs));
    }

    // For each pair the geometric mean over the scenes.
    private static Row all(Map<String, Row> rows, int pairs) {
        Row all = new Row();
        for (int pair = 0; pair < pairs; pair++) {
            double sum = 0;
            for (Row row : rows.values()) {
                sum += StrictMath.log(row.ratios.get(pair));
            }
            all.ratios.add(StrictMath.exp(sum / rows.size()));
        }
        for (Row row : rows.values()) {
            all.questions += row.questions;
            all.fine += row.fine;
            all.falls += row.falls;
            all.strayed += row.strayed;
        }
        return all;
    }

    private static List<String[]> run(String mode, Path trips) throws IOException {
        String said = Answers.run(
                List.of("-D" + FilterBound.PROPERTY + "=" + mode, "-XX:+UseSerialGC"),
                OrdinaryScenes.class,
                List.of("" + WARM_UP, "" + MEASURED, trips.toString()));
        List<String[]> rows = said.lines()
                .map(line -> line.split(";", -1))
                .filter(row -> row.length == 6)
                .toList();
        if (rows.isEmpty()) {
            throw new IOException("the scenes must run (got: " + said + ")");
        }
        return rows;
    }

    private static void print(String name, Row row) {
        double[] logs = row.ratios.stream().mapToDouble(StrictMath::log).toArray();
        double[] means = new double[SAMPLES];
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < SAMPLES; k++) {
            double sum = 0;
            for (int m = 0; m < logs.length; m++) {
                sum += logs[random.nextInt(logs.length)];
            }
            means[k] = sum / logs.length;
        }
        Arrays.sort(means);
        Timing.print(
                "%-28s %8.3f %9.3f to %7.3f %14.1f %14.1f %8d",
                name,
                StrictMath.exp(Arrays.stream(logs).average().orElseThrow()),
                StrictMath.exp(means[SAMPLES / 40]),
                StrictMath.exp(means[SAMPLES - 1 - SAMPLES / 40]),
                1e6 * row.fine / row.questions,
                1e6 * row.falls / row.questions,
                row.strayed);
    }
}
