package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.material.Color;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.batch.Integers;
import robosim.geometry.protocol.batch.Numbers;

/** How the values of one type are written as JSON, and read from it. */
interface JsonForm<T> {
    JsonForm<Double> NUMBER = of(JsonInput::number, JsonGenerator::writeNumber);

    /** A number, or null for an infinite one. */
    JsonForm<Double> RANGE = of(in -> in.isNull() ? Double.POSITIVE_INFINITY : in.number(), JsonForm::finiteOrNull);

    JsonForm<Boolean> FLAG = of(JsonInput::flag, JsonGenerator::writeBoolean);
    JsonForm<String> TEXT = of(JsonInput::text, JsonGenerator::writeString);

    /** A whole number that is not negative and that every reader of JSON has exactly. */
    JsonForm<Long> LONG = of(in -> in.whole(0, JsonInput.MAX_ID), JsonGenerator::writeNumber);

    JsonForm<Point> POINT =
            numbers(3).as(at -> new Point(at[0], at[1], at[2]), at -> new double[] {at.x(), at.y(), at.z()});

    /** A heading, of radians. */
    JsonForm<Double> HEADING = NUMBER.as(
            heading -> {
                Checks.radians("heading", heading);
                return heading;
            },
            heading -> heading);

    /** A rotation, row by row. */
    JsonForm<Numbers> ROTATION = numbers(9).as(Numbers::new, Numbers::values);

    /** A text {@code #rrggbb}, or a list of three numbers. */
    JsonForm<Color> COLOR = choice(
            JsonInput::isText,
            TEXT.as(Color::parse, Color::toString),
            Color::isPacked,
            numbers(3).as(at -> new Color(at[0], at[1], at[2]), c -> new double[] {c.red(), c.green(), c.blue()}));

    JsonForm<GeometryObject.Kind> SHAPE = of(JsonForm::shape, (out, kind) -> out.writeString(kind.word()));

    /** Reads a value. */
    T read(JsonInput in) throws IOException;

    /** Writes a value. */
    void write(JsonGenerator out, T value) throws IOException;

    /** The same for values that are made of those of this form; what the constructor refuses is refused at its place. */
    default <U> JsonForm<U> as(Function<T, U> made, Function<U, T> of) {
        return of(
                in -> {
                    T value = read(in);
                    return in.make(() -> made.apply(value));
                },
                (out, value) -> write(out, of.apply(value)));
    }

    /** Reads the current value of a line. */
    @FunctionalInterface
    interface Reading<T> {
        T read(JsonInput in) throws IOException;
    }

    /** Writes a value. */
    @FunctionalInterface
    interface Writing<T> {
        void write(JsonGenerator out, T value) throws IOException;
    }

    /** What reads, without a detour. */
    default Reading<T> reading() {
        return this::read;
    }

    /** A form of two functions. */
    record Pair<T>(Reading<T> reading, Writing<T> writing) implements JsonForm<T> {
        @Override
        public T read(JsonInput in) throws IOException {
            return reading.read(in);
        }

        @Override
        public void write(JsonGenerator out, T value) throws IOException {
            writing.write(out, value);
        }
    }

    static <T> JsonForm<T> of(Reading<T> reading, Writing<T> writing) {
        return new Pair<>(reading, writing);
    }

    /** Either of two forms. */
    static <T> JsonForm<T> choice(
            Function<JsonInput, Boolean> isFirst, JsonForm<T> first, Function<T, Boolean> asFirst, JsonForm<T> second) {
        return of(
                in -> (isFirst.apply(in) ? first : second).read(in),
                (out, value) -> (asFirst.apply(value) ? first : second).write(out, value));
    }

    /** The form of a component of a usual type: a whole number is not negative, and a list has the usual limit. */
    static JsonForm<?> ofType(String component, Type type) {
        if (type instanceof ParameterizedType list && list.getRawType() == List.class) {
            return list(ofType(component, list.getActualTypeArguments()[0]));
        }
        if (type instanceof Class<?> constants && constants.isEnum() && type != GeometryObject.Kind.class) {
            return ofEnum(constants);
        }
        JsonForm<?> usual = Usual.FORMS.get(type);
        return usual == null ? missing(component) : usual;
    }

    /** The forms of usual types. */
    final class Usual {
        private static final Map<Type, JsonForm<?>> FORMS = Map.of(
                double.class,
                NUMBER,
                boolean.class,
                FLAG,
                int.class,
                whole(0, Integer.MAX_VALUE),
                long.class,
                LONG,
                String.class,
                TEXT,
                Point.class,
                POINT,
                Color.class,
                COLOR,
                GeometryObject.Kind.class,
                SHAPE);

        private Usual() {}
    }

    private static JsonForm<?> missing(String component) {
        String what = "the component " + component + " must have a form (got: none)";
        return of(
                in -> {
                    throw new IllegalStateException(what);
                },
                (out, value) -> {
                    throw new IllegalStateException(what);
                });
    }

    @SuppressWarnings({"unchecked", "rawtypes"}) // it is an enum
    private static JsonForm<?> ofEnum(Class<?> type) {
        return constants((Class) type);
    }

    /** The constants of an enum, by their names. */
    static <E extends Enum<E>> JsonForm<E> constants(Class<E> type) {
        return of(in -> in.constant(type), (out, constant) -> out.writeString(constant.name()));
    }

    /** The same, which may be read in small letters too, as in a world file. */
    static <E extends Enum<E>> JsonForm<E> anyCase(Class<E> type) {
        return of(
                in -> {
                    for (E constant : type.getEnumConstants()) {
                        if (constant.name().toLowerCase(Locale.ROOT).equals(in.text())) {
                            return constant;
                        }
                    }
                    return in.constant(type);
                },
                (out, constant) -> out.writeString(constant.name()));
    }

    private static GeometryObject.Kind shape(JsonInput in) throws IOException {
        String word = in.text();
        for (GeometryObject.Kind kind : GeometryObject.Kind.values()) {
            if (kind.word().equals(word)) {
                return kind;
            }
        }
        throw in.refused("must be the kind of an object, as in \"box\" (got: " + in.told(word) + ")");
    }

    static JsonForm<Integer> whole(int least, int most) {
        return of(in -> (int) in.whole(least, most), JsonGenerator::writeNumber);
    }

    static <T> JsonForm<List<T>> list(JsonForm<T> item) {
        return list(item, MessageLimits.MAX_LIST_LENGTH);
    }

    static <T> JsonForm<List<T>> list(JsonForm<T> item, int most) {
        return of(
                in -> {
                    List<T> items = new ArrayList<>();
                    in.list();
                    while (in.more(items.size(), most)) {
                        items.add(item.read(in));
                    }
                    return items;
                },
                (out, items) -> {
                    out.writeStartArray();
                    for (T each : items) {
                        item.write(out, each);
                    }
                    out.writeEndArray();
                });
    }

    /** A list of so many numbers. */
    static JsonForm<double[]> numbers(int count) {
        return of(in -> in.numbers(count), (out, numbers) -> out.writeArray(numbers, 0, numbers.length));
    }

    /** A list of any number of numbers. */
    static JsonForm<double[]> doubles(int most) {
        return of(in -> in.doubles(most), (out, numbers) -> out.writeArray(numbers, 0, numbers.length));
    }

    /** A list of any number of whole numbers. */
    static JsonForm<int[]> wholes(int most, int least, int greatest) {
        return of(in -> in.wholes(most, least, greatest), (out, all) -> out.writeArray(all, 0, all.length));
    }

    /** Bytes in base64, in groups of so many. */
    static JsonForm<byte[]> bytes(int stride, int most) {
        return of(in -> in.base64(stride, most), JsonGenerator::writeBinary);
    }

    /** Numbers in base64, in groups of so many. */
    static JsonForm<Numbers> packed(int stride, int most) {
        return bytes(stride * Double.BYTES, most).as(PackedNumbers::numbers, PackedNumbers::bytes);
    }

    /** Whole numbers in base64. */
    static JsonForm<Integers> packedIntegers(int most) {
        return bytes(Integer.BYTES, most).as(PackedNumbers::integers, PackedNumbers::bytes);
    }

    private static void finiteOrNull(JsonGenerator out, Double number) throws IOException {
        if (number < Double.POSITIVE_INFINITY) {
            out.writeNumber(number);
        } else {
            out.writeNull();
        }
    }

    /** Whether two values of a member are the same; zeros are, whatever their sign. */
    static boolean same(Object a, @Nullable Object b) {
        if (a instanceof Double x && b instanceof Double y) {
            return x.doubleValue() == y.doubleValue();
        }
        return a.equals(b);
    }
}
