package robosim.geometry.cli.demo;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Properties;
import robosim.geometry.check.NumberText;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.StepBundle;

/** The summary that the demo prints at its end. */
public final class Summary {
    /** How many obstacles are named; the rest are counted. */
    private static final int NAMED = 6;

    private final Properties environment = new Properties();
    private final Timings timings;

    /** Reads the environment's numbers from the folder of the recording. */
    Summary(Path folder, Timings timings) throws IOException {
        this.timings = timings;
        try (Reader in = Files.newBufferedReader(folder.resolve("environment.properties"))) {
            environment.load(in);
        }
    }

    private long count(String key) {
        return Long.parseLong(environment.getProperty(key, "0"));
    }

    private double micros(String key) {
        return Double.parseDouble(environment.getProperty(key, "0"));
    }

    /** Whether the environment handed the movement over. */
    private boolean isDriven() {
        return environment.containsKey("drive.seconds");
    }

    /** One line, as the caption of a picture. */
    String line(boolean right) {
        if (isDriven()) {
            return format(
                    "%s, %s: %.0f s driven, %s, %s; the audit found %s wrong",
                    NumberText.count(count("robots"), "robot"),
                    NumberText.count(count("steps"), "step"),
                    micros("drive.seconds"),
                    NumberText.count(count("drive.bumps"), "bump"),
                    NumberText.count(count("distances"), "distance"),
                    right ? "nothing" : "something");
        }
        return format(
                "%s, %s: %s asked, %,d refused, %s; the audit found %s wrong",
                NumberText.count(count("robots"), "robot"),
                NumberText.count(count("steps"), "step"),
                NumberText.count(count("moves.asked"), "move"),
                count("moves.asked") - count("moves.made"),
                NumberText.count(count("distances"), "distance"),
                right ? "nothing" : "something");
    }

    /** The whole summary, with the output of the audit. */
    String text(String verdict) {
        long asked = count("moves.asked");
        long made = count("moves.made");
        long distances = count("distances");
        StringBuilder text = new StringBuilder();
        text.append(format(
                "conversation  %s of %s, two processes over TCP%n",
                NumberText.count(count("steps"), "step"), NumberText.count(count("robots"), "robot")));
        if (isDriven()) {
            text.append(format(
                    "driven        %.1f m in %.1f s, %s, %,d stopped%n",
                    micros("drive.way"),
                    micros("drive.seconds"),
                    NumberText.count(count("drive.bumps"), "bump"),
                    count("drive.stopped")));
        } else {
            text.append(format("moves         %,d asked, %,d made, %,d refused%n", asked, made, asked - made));
        }
        refusals(text);
        text.append(format("distances     %,d answered, %,d of them echoes%n", distances, count("echoes")));
        long rounds = Math.max(1, count("sonar.bundles"));
        text.append(format("%-28s %20s %20s%n", "time", "environment", "module"));
        text.append(format("%-28s %10s %9s %10s %9s%n", "", "median", "99 %", "median", "99 %"));
        row(text, "a bundle of " + distances / rounds + " distances", "sonar", 1);
        row(text, "one of its distances", "sonar", Math.max(1, distances / rounds));
        long each = Math.max(1, count("robots"));
        if (isDriven()) {
            row(text, "a step of " + NumberText.count(each, "robot"), "step", 1);
        } else {
            row(text, "a bundle of " + each + " moves", "move", 1);
            row(text, "one of its moves", "move", each);
        }
        return text.append(verdict).toString();
    }

    private void row(StringBuilder text, String what, String kind, long share) {
        text.append(format(
                "  %-26s %7.1f us %6.1f us %7.1f us %6.1f us%n",
                what,
                micros(kind + ".median.us") / share,
                micros(kind + ".99.us") / share,
                timed(kind, 0.5) / share,
                timed(kind, 0.99) / share));
    }

    private double timed(String kind, double share) {
        return timings.micros(
                switch (kind) {
                    case "sonar" -> SonarRequestBundle.class;
                    case "step" -> StepBundle.class;
                    default -> MoveBundle.class;
                },
                share);
    }

    private void refusals(StringBuilder text) {
        List<Map.Entry<String, Integer>> obstacles =
                new ArrayList<>(timings.refusedBy().entrySet());
        obstacles.sort(Map.Entry.<String, Integer>comparingByValue()
                .reversed()
                .thenComparing(Map.Entry.comparingByKey(Comparator.naturalOrder())));
        int rest = 0;
        for (int k = 0; k < obstacles.size(); k++) {
            if (k < NAMED) {
                text.append(format(
                        "  %,10d refused by %s%n",
                        obstacles.get(k).getValue(), obstacles.get(k).getKey()));
            } else {
                rest += obstacles.get(k).getValue();
            }
        }
        if (rest > 0) {
            text.append(format(
                    "  %,10d refused by %s%n", rest, NumberText.count(obstacles.size() - NAMED, "other object")));
        }
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
