package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;

/**
 * JSON objects of several kinds. The kind may come after the members, so these are read as those of all kinds together; a
 * name that two kinds have is read as the first of them reads it.
 */
final class JsonKinds<T> implements JsonForm<T> {
    private final boolean isTagged;

    /** The article before a kind in a refusal; or if no word tells the kind, what an object must have. */
    private final String words;

    private final List<Kind<T>> kinds;
    private final int[][] places;
    private final JsonObject<@Nullable Object[]> union;
    private final JsonObject<T> reader;

    /** A kind: its word, if a word tells it, the values that are of it, and their form. */
    record Kind<T>(String word, Predicate<Object> has, JsonObject<T> form) {}

    private JsonKinds(boolean isTagged, String words, List<Kind<T>> kinds) {
        this.isTagged = isTagged;
        this.words = words;
        this.kinds = kinds;
        union = JsonObject.union(
                isTagged ? JsonForm.of(this::kind, (out, kind) -> {}) : null,
                kinds.stream().map(Kind::form).toList());
        places = kinds.stream().map(kind -> kind.form.within(union)).toArray(int[][]::new);
        reader = union.as(this::make, value -> new Object[0]);
    }

    /** A kind of records. */
    static <T> Kind<T> kind(String word, JsonObject<? extends T> form) {
        return kind(word, form.type, form);
    }

    /** A kind of values that are made of records. */
    static <T> Kind<T> kind(String word, Class<?> type, JsonObject<? extends T> form) {
        return kind(word, type::isInstance, form);
    }

    /** A kind of the values that a predicate takes; the first that does counts. */
    @SuppressWarnings("unchecked") // it is only given values that it has
    static <T> Kind<T> kind(String word, Predicate<Object> has, JsonObject<? extends T> form) {
        return new Kind<>(word, has, (JsonObject<T>) form);
    }

    /**
     * Objects with a member of the name "kind", which is the word of their kind.
     *
     * @param article by which a refusal speaks of "a box", or empty for "of kind "box" it"
     */
    @SafeVarargs
    @SuppressWarnings("varargs") // is only read
    static <T> JsonKinds<T> tagged(String article, Kind<T>... kinds) {
        return new JsonKinds<>(true, article, List.of(kinds));
    }

    /** Objects whose members tell the kind. */
    @SafeVarargs
    @SuppressWarnings("varargs") // is only read
    static <T> JsonKinds<T> untagged(String must, Kind<T>... kinds) {
        return new JsonKinds<>(false, must, List.of(kinds));
    }

    private Integer kind(JsonInput in) throws IOException {
        String text = in.text();
        for (int k = 0; k < kinds.size(); k++) {
            if (kinds.get(k).word.equals(text)) {
                return k;
            }
        }
        String all = String.join(", ", kinds.stream().map(Kind::word).toList());
        throw in.refused("must be " + all.replaceFirst(", (\\w+)$", " or $1") + " (got: " + in.told(text) + ")");
    }

    private T make(@Nullable Object[] values) {
        int at = isTagged && values[0] instanceof Integer told ? told : untold(values);
        Kind<T> kind = kinds.get(at);
        int[] from = places[at];
        @Nullable Object[] own = new Object[from.length];
        long may = 0;
        long must = 0;
        for (int k = 0; k < from.length; k++) {
            own[k] = values[from[k]];
            may |= 1L << from[k];
            must |= kind.form.isRequired(k) ? 1L << from[k] : 0;
        }
        for (int k = isTagged ? 1 : 0; k < values.length; k++) {
            boolean isWrong = values[k] == null ? (must & 1L << k) != 0 : (may & 1L << k) == 0;
            if (isWrong) {
                throw new IllegalArgumentException(subject(kind) + " must" + (values[k] == null ? "" : " not")
                        + " have the field \"" + union.name(k) + "\"");
            }
        }
        return kind.form.complete(own);
    }

    private String subject(Kind<T> kind) {
        return words.isEmpty() ? "of kind \"" + kind.word + "\" it" : words + " " + kind.word;
    }

    /** The kind that has all members that were given, and no other required ones. */
    private int untold(@Nullable Object[] values) {
        long given = 0;
        for (int k = 0; k < values.length; k++) {
            given |= values[k] == null ? 0 : 1L << k;
        }
        for (int at = 0; at < places.length; at++) {
            long may = 0;
            long must = 0;
            for (int k = 0; k < places[at].length; k++) {
                may |= 1L << places[at][k];
                must |= kinds.get(at).form.isRequired(k) ? 1L << places[at][k] : 0;
            }
            if ((given & must) == must && (given & ~may) == 0) {
                return at;
            }
        }
        throw new IllegalArgumentException(words);
    }

    @Override
    public T read(JsonInput in) throws IOException {
        return reader.read(in);
    }

    @Override
    public void write(JsonGenerator out, T value) throws IOException {
        for (Kind<T> kind : kinds) {
            if (kind.has.test(value)) {
                out.writeStartObject();
                if (isTagged) {
                    out.writeStringField("kind", kind.word);
                }
                kind.form.writeMembers(out, value);
                out.writeEndObject();
                return;
            }
        }
        throw new IllegalArgumentException("a value must be of a known kind (got: " + value + ")");
    }
}
