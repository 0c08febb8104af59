package robosim.geometry.protocol.json;

import java.util.ArrayList;
import java.util.List;

/**
 * The fields of one kind of JSON object; at most 64. A field that is an angle or a speed of turning may be written with its unit
 * too: {@code turnRadians} is {@code turn}.
 */
final class Fields {
    private static final String ANGLE = "~";
    private static final String UNIT = "Radians";

    private final List<String> names;

    /** The names with their unit, at the same places; empty for a field that has none. */
    private final List<String> withUnit;

    private final int required;

    private Fields(List<String> all, int required) {
        this.names = all.stream().map(name -> name.replace(ANGLE, "")).toList();
        this.withUnit = all.stream()
                .map(name -> name.endsWith(ANGLE) ? name.replace(ANGLE, UNIT) : "")
                .toList();
        this.required = required;
    }

    /**
     * Takes names separated by spaces; required fields are numbered first, then optional ones. A name that ends with ~ may be
     * written with its unit.
     */
    static Fields of(String required, String optional) {
        List<String> names = new ArrayList<>(required.isEmpty() ? List.of() : List.of(required.split(" ")));
        int count = names.size();
        if (!optional.isEmpty()) {
            names.addAll(List.of(optional.split(" ")));
        }
        return new Fields(names, count);
    }

    /** The number of a field, or -1. */
    int indexOf(String name) {
        int index = names.indexOf(name);
        return index < 0 && name.endsWith(UNIT) ? withUnit.indexOf(name) : index;
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
