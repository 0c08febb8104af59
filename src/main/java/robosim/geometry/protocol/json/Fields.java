package robosim.geometry.protocol.json;

import java.util.ArrayList;
import java.util.List;

/** The fields of one kind of JSON object; at most 64. */
final class Fields {
    private final List<String> names;
    private final int required;

    private Fields(List<String> names, int required) {
        this.names = names;
        this.required = required;
    }

    /** Takes names separated by spaces; required fields are numbered first, then optional ones. */
    static Fields of(String required, String optional) {
        List<String> names = new ArrayList<>(required.isEmpty() ? List.of() : List.of(required.split(" ")));
        int count = names.size();
        if (!optional.isEmpty()) {
            names.addAll(List.of(optional.split(" ")));
        }
        return new Fields(List.copyOf(names), count);
    }

    /** The number of a field, or -1. */
    int indexOf(String name) {
        return names.indexOf(name);
    }

    /** The number of fields. */
    int count() {
        return names.size();
    }

    String name(int index) {
        return names.get(index);
    }

    boolean isRequired(int index) {
        return index < required;
    }

    /** The first required field whose bit is not set in {@code seen}; -1 if none is missing. */
    int missing(long seen) {
        int first = Long.numberOfTrailingZeros(~seen);
        return first < required ? first : -1;
    }

    @Override
    public String toString() {
        return String.join(", ", names);
    }
}
