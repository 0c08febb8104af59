package robosim.geometry.sweep;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import robosim.geometry.check.Checks;
import robosim.geometry.sweep.lines.Names;

/**
 * The result of a replicate: numbers by name, in order. A name may end in a unit, as in {@code "nearest [world
 * units]"}; tables and plots show it.
 */
public final class Result {
    private final Map<String, Double> values;

    private Result(Map<String, Double> values) {
        this.values = Collections.unmodifiableMap(values);
    }

    /**
     * A result with one number.
     *
     * @param value finite, or {@code +Infinity} where there is none, as for a beam without an echo
     */
    public static Result of(String name, double value) {
        return new Result(Map.of()).and(name, value);
    }

    /** This result with one more number. */
    public Result and(String name, double value) {
        if (name == null || name.isBlank()) {
            throw new IllegalArgumentException("name must have a visible character (got: " + name + ")");
        }
        if (name.length() > Names.MOST || Names.hasHalf(name)) {
            throw new IllegalArgumentException("name must have at most " + Names.MOST
                    + " characters and no half of a surrogate pair (got: " + name + ")");
        }
        Checks.refuse(
                !(value > Double.NEGATIVE_INFINITY),
                "value of " + name + " must be a number, or +Infinity where there is none",
                value);
        Map<String, Double> more = new LinkedHashMap<>(values);
        if (more.put(name, value + 0.0) != null) { // no -0.0
            throw new IllegalArgumentException("name must be given once (got: " + name + " again)");
        }
        return new Result(more);
    }

    /** The numbers. */
    public Map<String, Double> values() {
        return values;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Result that && values.equals(that.values);
    }

    @Override
    public int hashCode() {
        return values.hashCode();
    }

    @Override
    public String toString() {
        return values.toString();
    }
}
