package robosim.geometry.sweep;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.NumberText;

/** Averages over the replicates of each cell. Must be given all outcomes by ascending index. */
public final class SweepSummary implements Consumer<Outcome> {
    private final Map<Cell, Map<String, Spread>> cells = new LinkedHashMap<>();
    private final Map<Cell, Integer> failed = new LinkedHashMap<>();

    /** A summary without outcomes yet. */
    public SweepSummary() {}

    /**
     * A world with one combination of values.
     *
     * @param world      the world's name
     * @param parameters the values, by name
     */
    record Cell(String world, Map<String, String> parameters) {}

    /**
     * Statistics of one number over the replicates of a cell; replicates without a value, as for a beam without an
     * echo, are counted separately.
     */
    public static final class Spread {
        private long count;
        private long none;
        private double mean;
        private double squares;
        private double min = Double.POSITIVE_INFINITY;
        private double max = Double.NEGATIVE_INFINITY;

        private Spread() {}

        private void add(double value) {
            if (value == Double.POSITIVE_INFINITY) {
                none++;
                return;
            }
            // Welford 1962: avoids the cancellation in a difference of sums of squares.
            count++;
            double off = value - mean;
            mean += off / count;
            squares += off * (value - mean);
            min = Math.min(min, value);
            max = Math.max(max, value);
        }

        /** The number of values. */
        public long count() {
            return count;
        }

        /** The number of replicates without a value. */
        public long none() {
            return none;
        }

        /** The mean; NaN if there are no values. */
        public double mean() {
            return count == 0 ? Double.NaN : mean;
        }

        /** The sample standard deviation; 0 for a single value. */
        public double deviation() {
            return count < 2 ? 0 : Math.sqrt(squares / (count - 1));
        }

        /** Half the width of the 95 % confidence interval of the mean, for many values. */
        public double margin() {
            return count < 2 ? 0 : 1.96 * deviation() / Math.sqrt((double) count);
        }

        /** The minimum; {@code +Infinity} if there are no values. */
        public double min() {
            return min;
        }

        /** The maximum. */
        public double max() {
            return max;
        }
    }

    @Override
    public void accept(Outcome outcome) {
        Checks.present("outcome", outcome);
        Cell cell = new Cell(outcome.world(), Map.copyOf(outcome.parameters()));
        Map<String, Spread> spreads = cells.computeIfAbsent(cell, c -> new LinkedHashMap<>());
        failed.merge(cell, outcome.isFailed() ? 1 : 0, Integer::sum);
        outcome.values()
                .forEach((name, value) ->
                        spreads.computeIfAbsent(name, n -> new Spread()).add(value));
    }

    /**
     * The statistics of one number for a world and one combination of values; null if no outcome has it.
     *
     * @param world      the world's name
     * @param parameters the values, by name
     * @param number     the name of the number
     */
    public @Nullable Spread spread(String world, Map<String, String> parameters, String number) {
        Checks.present("world", world);
        Checks.present("parameters", parameters);
        Checks.present("number", number);
        return cells.getOrDefault(new Cell(world, Map.copyOf(parameters)), Map.of())
                .get(number);
    }

    /** The statistics by cell and number, in order of first appearance. */
    Map<Cell, Map<String, Spread>> cells() {
        return Collections.unmodifiableMap(cells);
    }

    /** Whether there are several replicates of a cell, and those of each cell gave the same numbers. */
    public boolean isRepetition() {
        boolean several = false;
        for (Map<String, Spread> spreads : cells.values()) {
            for (Spread spread : spreads.values()) {
                if (spread.count > 0 && (spread.none > 0 || spread.min != spread.max)) {
                    return false;
                }
                several |= spread.count + spread.none > 1;
            }
        }
        return several && failures() == 0;
    }

    /** The number of replicates that failed. */
    public long failures() {
        return failed.values().stream().mapToLong(Integer::longValue).sum();
    }

    /**
     * The summary as a picture, SVG: a panel for each number, its mean over the values of the parameter with the most numeric
     * ones, a line for each world and combination of the others; bars are the interval of {@link Spread#margin()}. If no
     * parameter varies, the worlds stand side by side. A number that is the same everywhere gets a sentence below.
     *
     * @param header of the sweep that is summarized
     */
    public String svg(SweepHeader header) {
        return SweepPlot.svg(header, this);
    }

    /**
     * A table for people, in Markdown: a row for each cell and number. The ends of robots are left out: the rows of the
     * results have them.
     */
    public String markdown() {
        List<String> parameters = cells.keySet().stream()
                .flatMap(cell -> cell.parameters().keySet().stream())
                .distinct()
                .sorted()
                .toList();
        List<String> heads = new ArrayList<>(List.of("world"));
        heads.addAll(parameters);
        heads.addAll(List.of("result", "replicates", "mean", "+-", "deviation", "least", "greatest", "none"));
        List<List<String>> rows = new ArrayList<>(List.of(heads));
        cells.forEach((cell, spreads) -> {
            spreads.forEach((name, spread) -> {
                if (!RobotArrivals.isEnd(name)) {
                    rows.add(row(cell, parameters, name, spread));
                }
            });
            int failures = failed.getOrDefault(cell, 0);
            if (failures > 0) {
                List<String> row = key(cell, parameters);
                row.addAll(List.of("failures", String.valueOf(failures), "", "", "", "", "", ""));
                rows.add(row);
            }
        });
        return table(rows, 2 + parameters.size());
    }

    private static List<String> key(Cell cell, List<String> parameters) {
        List<String> row = new ArrayList<>(List.of(cell.world()));
        parameters.forEach(name -> row.add(cell.parameters().getOrDefault(name, "")));
        return row;
    }

    private static List<String> row(Cell cell, List<String> parameters, String name, Spread spread) {
        List<String> row = key(cell, parameters);
        row.add(name.replace("|", "\\|"));
        row.add(String.valueOf(spread.count + spread.none));
        boolean hasAny = spread.count > 0;
        for (double number :
                new double[] {spread.mean(), spread.margin(), spread.deviation(), spread.min, spread.max}) {
            row.add(hasAny ? number(number) : "");
        }
        row.add(spread.none == 0 ? "" : String.valueOf(spread.none));
        return row;
    }

    /** A number to five digits, without trailing zeros. */
    static String number(double number) {
        if (number == Math.rint(number) && Math.abs(number) < 1e9) {
            return String.valueOf((long) number);
        }
        return NumberText.digits(number, 5);
    }

    private static String table(List<List<String>> rows, int left) {
        int columns = rows.get(0).size();
        int[] widths = new int[columns];
        rows.forEach(row -> {
            for (int k = 0; k < columns; k++) {
                widths[k] = Math.max(widths[k], row.get(k).length());
            }
        });
        StringBuilder text = new StringBuilder();
        for (int r = 0; r < rows.size(); r++) {
            for (int k = 0; k < columns; k++) {
                String cell = rows.get(r).get(k);
                String space = " ".repeat(widths[k] - cell.length());
                text.append("| ").append(k < left ? cell + space : space + cell).append(' ');
            }
            text.append("|\n");
            for (int k = 0; r == 0 && k < columns; k++) {
                text.append('|').append(k < left ? ' ' : '-').append("-".repeat(widths[k]));
                text.append(k < left ? " " : ":").append(k == columns - 1 ? "|\n" : "");
            }
        }
        return text.toString();
    }
}
