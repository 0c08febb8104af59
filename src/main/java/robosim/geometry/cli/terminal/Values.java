package robosim.geometry.cli.terminal;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.TypeConversionException;

/** How the values of options and parameters are read: what is none is refused in words that are no programmer's. */
public final class Values {
    private static final String DECIMAL = "must be a number, such as 12, -0.5 or 1.5e-3";
    private static final String WHOLE = "must be a whole number of at most ";

    private Values() {}

    /** Sets how a command and those below it read values. */
    public static void register(CommandLine line) {
        add(line, double.class, Double.class, Double::valueOf, DECIMAL);
        add(line, int.class, Integer.class, Integer::valueOf, WHOLE + Integer.MAX_VALUE);
        add(line, long.class, Long.class, Long::valueOf, WHOLE + Long.MAX_VALUE);
        addWords(line);
    }

    private static <T> void add(
            CommandLine line, Class<T> primitive, Class<T> type, Function<String, T> reader, String rule) {
        ITypeConverter<T> converter = text -> {
            try {
                return reader.apply(text);
            } catch (NumberFormatException e) {
                throw new TypeConversionException(rule + " (got: " + text + ")");
            }
        };
        line.registerConverter(primitive, converter);
        line.registerConverter(type, converter);
    }

    /** An option whose values are constants takes their names in lower case, with hyphens, and its help lists them. */
    private static void addWords(CommandLine line) {
        CommandSpec spec = line.getCommandSpec();
        for (OptionSpec option : List.copyOf(spec.options())) {
            Class<?> type = option.type();
            if (type.isEnum()) {
                List<String> words =
                        Stream.of(type.getEnumConstants()).map(Values::word).toList();
                ITypeConverter<?> converter = text -> Stream.of(type.getEnumConstants())
                        .filter(each -> word(each).equals(text.toLowerCase(Locale.ROOT)))
                        .findFirst()
                        .orElseThrow(() -> new TypeConversionException(
                                "must be one of " + String.join(", ", words) + " (got: " + text + ")"));
                spec.remove(option);
                spec.add(option.toBuilder()
                        .completionCandidates(words)
                        .converters(converter)
                        .build());
            }
        }
        line.getSubcommands().values().forEach(Values::addWords);
    }

    private static String word(Object constant) {
        return ((Enum<?>) constant).name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
