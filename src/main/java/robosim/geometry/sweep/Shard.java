package robosim.geometry.sweep;

import java.io.Serializable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import robosim.geometry.check.Checks;

/**
 * A part of a sweep that one machine runs: the shards of one count are disjoint and together contain all replicates.
 * Every shard has replicates of every world and parameter, so that the long ones are spread evenly.
 *
 * @param number number of the shard, from 0
 * @param count  number of shards
 */
public record Shard(int number, int count) implements Serializable {
    private static final long serialVersionUID = 1;
    private static final Pattern FORM = Pattern.compile("(\\d{1,9})/(\\d{1,9})");

    /** The whole sweep. */
    public static final Shard ALL = new Shard(0, 1);

    /** Refuses a number that is not below the count. */
    public Shard {
        if (number < 0 || number >= count) {
            throw new IllegalArgumentException(
                    "shard must be from 0/n to (n - 1)/n, as in 0/4 (got: " + number + "/" + count + ")");
        }
    }

    /** Reads a text such as {@code 0/4}. */
    public static Shard parse(String text) {
        Checks.present("text", text);
        Matcher matcher = FORM.matcher(text);
        Checks.refuse(!matcher.matches(), "shard must be a number and a count, as in 0/4", text);
        return new Shard(Integer.parseInt(matcher.group(1)), Integer.parseInt(matcher.group(2)));
    }

    boolean has(long cell, long replicate) {
        return (cell + replicate) % count == number;
    }

    @Override
    public String toString() {
        return number + "/" + count;
    }
}
