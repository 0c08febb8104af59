package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.SerializableString;
import com.fasterxml.jackson.core.io.SerializedString;
import java.io.IOException;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Values of one type as JSON objects. The members of a record are its components, in their order; what they do not say is
 * added by the methods here, each of which returns another form.
 *
 * <p>Values of members are held in an array; one that is absent is null there.
 */
final class JsonObject<T> implements JsonForm<T> {
    private static final String UNIT = "Radians";

    /** What all values are; of values that are made of others, what those are. */
    final Class<?> type;

    private final Member[] members;
    private final String[] names;
    private final String[] namesWithUnit;
    private final Reading<Object>[] readings;
    private final Function<@Nullable Object[], T> make;
    private final Function<T, @Nullable Object[]> take;

    /** Whether a member may be left out when it is read, and is when it is written. */
    private enum Presence {
        REQUIRED,
        /** Always written. */
        OPTIONAL,
        /** Not written if it has its default. */
        OMITTED
    }

    /** A member, of at most 64. An angle or a speed of turning may be written with its unit too. */
    private record Member(
            SerializableString name,
            boolean isAngle,
            JsonForm<Object> form,
            Presence presence,
            @Nullable Object usual) {}

    private JsonObject(
            Class<?> type,
            Member[] members,
            Function<@Nullable Object[], T> make,
            Function<T, @Nullable Object[]> take) {
        this.type = type;
        this.members = members;
        this.names = Stream.of(members).map(each -> each.name.getValue()).toArray(String[]::new);
        this.namesWithUnit = Stream.of(members)
                .map(each -> each.name.getValue() + (each.isAngle ? UNIT : ""))
                .toArray(String[]::new);
        this.readings = readings(members);
        this.make = make;
        this.take = take;
    }

    /** Records. All members are required, and those have a form whose type has one. */
    static <R extends Record> JsonObject<R> of(Class<R> type) {
        RecordComponent[] components = type.getRecordComponents();
        int count = components.length;
        Member[] members = new Member[count];
        MethodHandle[] accessors = new MethodHandle[count];
        Class<?>[] types = new Class<?>[count];
        MethodHandle constructor;
        MethodHandle values;
        try {
            MethodHandles.Lookup lookup = MethodHandles.lookup();
            for (int k = 0; k < count; k++) {
                String name = components[k].getName();
                JsonForm<?> form = JsonForm.ofType(type.getSimpleName() + "." + name, components[k].getGenericType());
                members[k] = new Member(new SerializedString(name), false, untyped(form), Presence.REQUIRED, null);
                types[k] = components[k].getType();
                accessors[k] = lookup.unreflect(components[k].getAccessor())
                        .asType(MethodType.methodType(Object.class, Object.class));
            }
            constructor = lookup.findConstructor(type, MethodType.methodType(void.class, types))
                    .asSpreader(Object[].class, count)
                    .asType(MethodType.methodType(Object.class, Object[].class));
            MethodHandle array = MethodHandles.identity(Object[].class).asCollector(Object[].class, count);
            values = MethodHandles.permuteArguments(
                    MethodHandles.filterArguments(array, 0, accessors),
                    MethodType.methodType(Object[].class, Object.class),
                    new int[count]);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
        return new JsonObject<>(type, members, given -> type.cast(made(constructor, given)), of -> taken(values, of));
    }

    @SuppressWarnings({"unchecked", "rawtypes"}) // an array
    private static Reading<Object>[] readings(Member[] members) {
        return Stream.of(members).map(each -> each.form.reading()).toArray(Reading[]::new);
    }

    private static Object made(MethodHandle constructor, @Nullable Object[] values) {
        try {
            return constructor.invokeExact(values);
        } catch (RuntimeException | Error e) {
            throw e;
        } catch (Throwable e) {
            throw new IllegalStateException(e);
        }
    }

    private static @Nullable Object[] taken(MethodHandle values, Object value) {
        try {
            return (Object[]) values.invokeExact(value);
        } catch (RuntimeException | Error e) {
            throw e;
        } catch (Throwable e) {
            throw new IllegalStateException(e);
        }
    }

    @SuppressWarnings("unchecked") // a member's values are those of its form
    private static JsonForm<Object> untyped(JsonForm<?> form) {
        return (JsonForm<Object>) form;
    }

    private JsonObject<T> with(String names, UnaryOperator<Member> change) {
        Member[] changed = members.clone();
        for (String name : List.of(names.split(" "))) {
            int at = index(name.replace("~", ""));
            Member was = changed[at];
            changed[at] = change.apply(
                    new Member(was.name, was.isAngle || name.endsWith("~"), was.form, was.presence, was.usual));
        }
        return new JsonObject<>(type, changed, make, take);
    }

    private int index(String name) {
        int at = List.of(names).indexOf(name);
        if (at < 0) {
            throw new IllegalArgumentException("name must be one of " + this + " (got: " + name + ")");
        }
        return at;
    }

    /**
     * Members that are not written if they are as usual, and are that where they are absent.
     *
     * @param usual null for none
     * @param names separated by spaces; one that ends with ~ may be written with the unit of angles
     */
    JsonObject<T> omitting(@Nullable Object usual, String names) {
        return with(names, was -> new Member(was.name, was.isAngle, was.form, Presence.OMITTED, usual));
    }

    /** Members that are always written, but may be absent where they are read. */
    JsonObject<T> optional(Object usual, String names) {
        return with(names, was -> new Member(was.name, was.isAngle, was.form, Presence.OPTIONAL, usual));
    }

    /** Members of another form. */
    JsonObject<T> form(String names, JsonForm<?> form) {
        return with(names, was -> new Member(was.name, was.isAngle, untyped(form), was.presence, was.usual));
    }

    /** A member of another name than that of its component. */
    JsonObject<T> named(String component, String name) {
        return with(
                component,
                was -> new Member(new SerializedString(name), was.isAngle, was.form, was.presence, was.usual));
    }

    /** The members of a component in its place. */
    <U> JsonObject<T> inline(String component, JsonObject<U> inner) {
        int at = index(component);
        int more = inner.members.length - 1;
        Member[] all = new Member[members.length + more];
        System.arraycopy(members, 0, all, 0, at);
        System.arraycopy(inner.members, 0, all, at, more + 1);
        System.arraycopy(members, at + 1, all, at + more + 1, members.length - at - 1);
        return new JsonObject<>(
                type,
                all,
                values -> {
                    @Nullable Object[] own = new Object[members.length];
                    System.arraycopy(values, 0, own, 0, at);
                    own[at] = inner.make.apply(Arrays.copyOfRange(values, at, at + more + 1));
                    System.arraycopy(values, at + more + 1, own, at + 1, own.length - at - 1);
                    return make.apply(own);
                },
                value -> {
                    @Nullable Object[] own = take.apply(value);
                    @Nullable Object[] values = new Object[own.length + more];
                    System.arraycopy(own, 0, values, 0, at);
                    @SuppressWarnings("unchecked") // it is a component of this type
                    U part = (U) own[at];
                    if (part != null) {
                        System.arraycopy(inner.take.apply(part), 0, values, at, more + 1);
                    }
                    System.arraycopy(own, at + 1, values, at + more + 1, own.length - at - 1);
                    return values;
                });
    }

    /** Members that are neither written nor read, and are absent where values are made. */
    JsonObject<T> without(String names) {
        List<String> left = List.of(names.split(" "));
        return arranged(
                Stream.of(this.names).filter(name -> !left.contains(name)).toList());
    }

    /** The same with a member at the end. */
    JsonObject<T> last(String name) {
        List<String> all = new ArrayList<>(List.of(names));
        all.remove(name);
        all.add(name);
        return arranged(all);
    }

    private JsonObject<T> arranged(List<String> order) {
        int[] places = order.stream().mapToInt(this::index).toArray();
        Member[] some = new Member[places.length];
        Arrays.setAll(some, k -> members[places[k]]);
        return new JsonObject<>(
                type,
                some,
                values -> {
                    @Nullable Object[] own = new Object[members.length];
                    for (int k = 0; k < own.length; k++) {
                        own[k] = members[k].usual;
                    }
                    for (int k = 0; k < places.length; k++) {
                        own[places[k]] = values[k];
                    }
                    return make.apply(own);
                },
                value -> {
                    @Nullable Object[] own = take.apply(value);
                    @Nullable Object[] values = new Object[places.length];
                    Arrays.setAll(values, k -> own[places[k]]);
                    return values;
                });
    }

    /** The same for values that are made of those of this form. */
    @Override
    public <U> JsonObject<U> as(Function<T, U> made, Function<U, T> of) {
        return new JsonObject<>(
                type, members, values -> made.apply(make.apply(values)), value -> take.apply(of.apply(value)));
    }

    @Override
    public T read(JsonInput in) throws IOException {
        return read(in, false);
    }

    /** Reads a line: a request or an answer, which has a type and may have an id besides its members. */
    T readMessage(JsonInput in) throws IOException {
        in.begin();
        T message = read(in, true);
        in.end();
        return message;
    }

    private T read(JsonInput in, boolean isMessage) throws IOException {
        in.beginObject();
        @Nullable Object[] values = new Object[members.length];
        boolean hasType = false;
        boolean hasId = false;
        int next = 0;
        while (in.advance() == JsonToken.FIELD_NAME) {
            String name = in.fieldName();
            int index = indexOf(name, next);
            boolean isType = index < 0 && isMessage && name.equals("type");
            boolean isId = index < 0 && isMessage && name.equals("id");
            if (index < 0 && !isType && !isId) {
                throw in.refused("a field must be one of " + (isMessage ? "type, " + this + ", id" : this) + " (got: "
                        + in.told(name) + ")");
            }
            if (index >= 0 ? values[index] != null : isType ? hasType : hasId) {
                throw in.refused("a field must occur only once (got: \"" + name + "\" twice)");
            }
            in.advance();
            if (index >= 0) {
                values[index] = readings[index].read(in);
                next = index + 1;
            } else if (isType) {
                in.text();
                hasType = true;
            } else {
                in.readId();
                hasId = true;
            }
        }
        return in.make(() -> complete(values), message -> culprit(message, values));
    }

    /** The number of a member, most often that of the next or a later one; -1 if there is none. */
    private int indexOf(String name, int next) {
        for (int k = 0; k < names.length; k++) {
            int at = k + next < names.length ? k + next : k + next - names.length;
            if (names[at].equals(name) || namesWithUnit[at].equals(name)) {
                return at;
            }
        }
        return -1;
    }

    /** The member that a constructor's message is about, if it was given. */
    private @Nullable String culprit(String message, @Nullable Object[] values) {
        for (int k = 0; k < names.length; k++) {
            if (values[k] != members[k].usual
                    && (message.startsWith(names[k] + " must ") || message.startsWith(names[k] + "["))) {
                return names[k];
            }
        }
        return null;
    }

    /** A value of members, of which some may be absent: they become what is usual. */
    T complete(@Nullable Object[] values) {
        for (int k = 0; k < values.length; k++) {
            if (values[k] == null) {
                if (isRequired(k)) {
                    throw new IllegalArgumentException("must have the field \"" + names[k] + "\" (got: none)");
                }
                values[k] = members[k].usual;
            }
        }
        return make.apply(values);
    }

    @Override
    public void write(JsonGenerator out, T value) throws IOException {
        out.writeStartObject();
        writeMembers(out, value);
        out.writeEndObject();
    }

    /** Writes the members within an object that has begun. */
    void writeMembers(JsonGenerator out, T value) throws IOException {
        @Nullable Object[] values = take.apply(value);
        for (int k = 0; k < members.length; k++) {
            Member member = members[k];
            Object each = values[k];
            if (each != null && (member.presence != Presence.OMITTED || !JsonForm.same(each, member.usual))) {
                out.writeFieldName(member.name);
                member.form.write(out, each);
            }
        }
    }

    String name(int member) {
        return names[member];
    }

    boolean isRequired(int member) {
        return members[member].presence == Presence.REQUIRED;
    }

    /**
     * The members of several forms, each name once, and none of them required; a value is what was given of them.
     *
     * @param kind the form of a required member before them; null for none
     */
    static JsonObject<@Nullable Object[]> union(@Nullable JsonForm<?> kind, List<? extends JsonObject<?>> forms) {
        List<Member> all = new ArrayList<>();
        if (kind != null) {
            all.add(new Member(new SerializedString("kind"), false, untyped(kind), Presence.REQUIRED, null));
        }
        for (JsonObject<?> form : forms) {
            for (Member member : form.members) {
                if (all.stream().noneMatch(each -> each.name.equals(member.name))) {
                    all.add(new Member(member.name, member.isAngle, member.form, Presence.OPTIONAL, null));
                }
            }
        }
        return new JsonObject<>(Object[].class, all.toArray(Member[]::new), values -> values, values -> values);
    }

    /** For each member its number in a union. */
    int[] within(JsonObject<?> union) {
        return Stream.of(names).mapToInt(union::index).toArray();
    }

    @Override
    public String toString() {
        return String.join(", ", names);
    }
}
