package robosim.geometry.sweep;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;

/**
 * Writes the results of a sweep as CSV (RFC 4180) for spreadsheets and data frames: a row for each replicate, with a column
 * for each parameter and each number. A cell is empty where there is no value, as for a beam without an echo.
 */
final class SweepCsv {
    private SweepCsv() {}

    /** Writes a file, in the order of the indices. */
    static void write(SweepResults results, Path file) throws IOException {
        Checks.present("results", results);
        Checks.present("file", file);
        List<String> parameters = List.copyOf(results.header().parameters().keySet());
        Set<String> values = new LinkedHashSet<>();
        results.forEach(outcome -> values.addAll(outcome.values().keySet()));
        try (Writer out = Files.newBufferedWriter(file, StandardCharsets.UTF_8)) {
            List<String> heads = new ArrayList<>(List.of("index", "world"));
            heads.addAll(parameters);
            heads.addAll(List.of("replicate", "seed"));
            heads.addAll(values);
            heads.add("error");
            write(out, heads);
            results.forEach(outcome -> {
                List<String> row = new ArrayList<>(List.of(String.valueOf(outcome.index()), outcome.world()));
                parameters.forEach(name -> row.add(outcome.parameters().getOrDefault(name, "")));
                row.addAll(List.of(String.valueOf(outcome.replicate()), Outcome.hex(outcome.seed())));
                values.forEach(name -> row.add(number(outcome.values().get(name))));
                row.add(outcome.error() == null ? "" : outcome.error());
                write(out, row);
            });
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    private static void write(Writer out, List<String> row) {
        try {
            out.write(row.stream().map(SweepCsv::quoted).collect(Collectors.joining(",")));
            out.write("\r\n");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String number(@Nullable Double value) {
        return value == null || value.isInfinite()
                ? ""
                : value == Math.rint(value) && Math.abs(value) < 1e15
                        ? String.valueOf(value.longValue())
                        : value.toString();
    }

    private static String quoted(String cell) {
        return cell.chars().anyMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r')
                ? '"' + cell.replace("\"", "\"\"") + '"'
                : cell;
    }
}
