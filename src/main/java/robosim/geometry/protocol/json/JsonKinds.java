package robosim.geometry.protocol.json;

import java.io.IOException;
import java.util.List;
import java.util.function.IntPredicate;
import robosim.geometry.protocol.ProtocolException;

/**
 * The kinds of one sort of JSON object, whose fields depend on its kind. The kind may come after the fields, so these are
 * read as those of all kinds together and compared with it at the end.
 */
final class JsonKinds {
    /** The kind is field 0. */
    private final Fields fields;

    private final List<Kind> kinds;
    private final String words;

    /** The fields that a kind must and may have beside those that all have. */
    private record Kind(String word, List<String> must, List<String> may) {}

    /**
     * Kinds of objects.
     *
     * @param fields names all fields; those that are required are those of all kinds
     * @param kinds  for each kind its word, the fields that it must have and those that it may have, separated by spaces
     */
    JsonKinds(Fields fields, String[]... kinds) {
        this.fields = fields;
        this.kinds = List.of(kinds).stream()
                .map(kind -> new Kind(kind[0], List.of(kind[1].split(" ")), List.of(kind[2].split(" "))))
                .toList();
        List<String> all = this.kinds.stream().map(Kind::word).toList();
        words = String.join(", ", all.subList(0, all.size() - 1)) + " or " + all.get(all.size() - 1);
    }

    /** Reads the current value as a kind; returns its number. */
    int read(JsonInput in) throws IOException {
        String text = in.text();
        for (int k = 0; k < kinds.size(); k++) {
            if (kinds.get(k).word.equals(text)) {
                return k;
            }
        }
        throw in.refused("must be " + words + " (got: " + in.told(text) + ")");
    }

    /** Refuses an object that lacks a field of its kind, or has one that its kind has not. */
    void check(JsonInput in, int kind, IntPredicate has) throws ProtocolException {
        Kind of = kinds.get(kind);
        for (int field = 0; field < fields.count(); field++) {
            String name = fields.name(field);
            boolean must = of.must.contains(name);
            if (has.test(field) ? !must && !of.may.contains(name) && !fields.isRequired(field) : must) {
                throw in.refused("of kind \"" + of.word + "\" it must" + (must ? "" : " not") + " have the field \""
                        + name + "\"");
            }
        }
    }
}
