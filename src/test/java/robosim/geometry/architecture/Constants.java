package robosim.geometry.architecture;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The values of constants, from the text of their initializers: numbers, sums, products, quotients, parentheses, names of
 * other constants, and the argument of {@code FilterBound.bound}. The source is read, as most constants are private and a
 * system property changes those that pass through the filter.
 */
final class Constants {
    private static final Pattern NUMBER =
            Pattern.compile("0x[0-9a-fA-F]*\\.?[0-9a-fA-F]*p-?[0-9]+|[0-9][0-9_]*(\\.[0-9]+)?");
    private static final Pattern NAME = Pattern.compile("[A-Z][A-Za-z_]*(\\.[A-Za-z_]+)?");

    private final Path root;
    private final String type;
    private final String text;
    private int at;

    private Constants(Path root, String type, String text) {
        this.root = root;
        this.type = type;
        this.text = text;
    }

    /** The value of a constant of a class somewhere below a root; NaN if it has none that can be read. */
    static double value(Path root, String type, String member) throws IOException {
        String source = Files.readString(NumericsPageTest.source(root.toString(), type + ".java"));
        Matcher initializer = Pattern.compile("static final (?:double|int|long) " + member + "\\s*=\\s*([^;]+);")
                .matcher(source);
        if (!initializer.find()) {
            Matcher imported = Pattern.compile("import static [a-z.]+\\.([A-Z][A-Za-z]*)\\." + member + ";")
                    .matcher(source);
            return imported.find() ? value(root, imported.group(1), member) : Double.NaN;
        }
        Constants parser = new Constants(root, type, initializer.group(1));
        double value = parser.sum();
        parser.skip();
        return parser.at == parser.text.length() ? value : Double.NaN;
    }

    /** The value of the longest expression that a text begins with; NaN if it begins with none. */
    static double leading(String text) throws IOException {
        return new Constants(Path.of("."), "", text).sum();
    }

    private double sum() throws IOException {
        double value = product();
        while (!Double.isNaN(value)) {
            int before = at;
            boolean plus = next('+');
            if (!plus && !next('-')) {
                break;
            }
            double more = product();
            if (Double.isNaN(more)) {
                at = before;
                break;
            }
            value += plus ? more : -more;
        }
        return value;
    }

    private double product() throws IOException {
        double value = factor();
        while (!Double.isNaN(value)) {
            int before = at;
            boolean times = next('*');
            if (!times && !next('/')) {
                break;
            }
            double more = factor();
            if (Double.isNaN(more)) {
                at = before;
                break;
            }
            value = times ? value * more : value / more;
        }
        return value;
    }

    private double factor() throws IOException {
        if (next('-')) {
            return -factor();
        }
        if (next('(')) {
            double value = sum();
            return next(')') ? value : Double.NaN;
        }
        Matcher number = NUMBER.matcher(text).region(at, text.length());
        if (number.lookingAt()) {
            at = number.end();
            return Double.parseDouble(number.group().replace("_", ""));
        }
        Matcher name = NAME.matcher(text).region(at, text.length());
        if (!name.lookingAt()) {
            return Double.NaN;
        }
        at = name.end();
        String what = name.group();
        if (what.equals("FilterBound.bound") && next('(')) {
            double value = sum();
            return next(')') ? value : Double.NaN;
        }
        int dot = what.indexOf('.');
        if (type.isEmpty()) {
            return what.equals("U") ? 0x1p-53 : Double.NaN;
        }
        return dot < 0 ? value(root, type, what) : value(root, what.substring(0, dot), what.substring(dot + 1));
    }

    private boolean next(char c) {
        skip();
        if (at < text.length() && text.charAt(at) == c) {
            at++;
            skip();
            return true;
        }
        return false;
    }

    private void skip() {
        while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
            at++;
        }
    }
}
