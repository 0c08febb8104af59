package robosim.geometry.cli.terminal;

import java.util.function.Function;
import picocli.CommandLine;
import picocli.CommandLine.TypeConversionException;

/** Numbers of options and parameters: what is none is refused in words that are no programmer's. */
public final class Numbers {
    private static final String DECIMAL = "must be a number, such as 12, -0.5 or 1.5e-3";
    private static final String WHOLE = "must be a whole number of at most ";

    private Numbers() {}

    /** Sets how a command and those below it read numbers. */
    public static void register(CommandLine line) {
        add(line, double.class, Double.class, Double::valueOf, DECIMAL);
        add(line, int.class, Integer.class, Integer::valueOf, WHOLE + Integer.MAX_VALUE);
        add(line, long.class, Long.class, Long::valueOf, WHOLE + Long.MAX_VALUE);
    }

    private static <T> void add(
            CommandLine line, Class<T> primitive, Class<T> type, Function<String, T> reader, String rule) {
        CommandLine.ITypeConverter<T> converter = text -> {
            try {
                return reader.apply(text);
            } catch (NumberFormatException e) {
                throw new TypeConversionException(rule + " (got: " + text + ")");
            }
        };
        line.registerConverter(primitive, converter);
        line.registerConverter(type, converter);
    }
}
