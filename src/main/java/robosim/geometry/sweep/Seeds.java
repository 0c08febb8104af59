package robosim.geometry.sweep;

import java.util.Map;
import java.util.SortedMap;
import robosim.geometry.check.Checks;

/**
 * Derives the seed of a replicate from the root seed, the scenario's name, the world's name, the parameters and the
 * number of the replicate, and from nothing else. So a replicate has the same seed on any thread, shard or machine, and
 * keeps it when worlds, values or replicates are added to a sweep.
 *
 * <p>The words are mixed in one after the other by {@code h = mix(h ^ word)}, where {@code mix} is the step of
 * SplitMix64 (Steele, Lea and Flood 2014, with Stafford's constants): the root seed; each string as its UTF-16 code
 * units followed by the word 0x10000, which is not a code unit; the number of the replicate.
 */
final class Seeds {
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;
    private static final long END = 0x10000;

    private Seeds() {}

    /** The seed of a replicate; the parameters in the order of their names, each a name and a value. */
    static long of(long root, String scenario, String world, SortedMap<String, String> parameters, long replicate) {
        Checks.present("scenario", scenario);
        Checks.present("world", world);
        Checks.present("parameters", parameters);
        long h = take(take(take(0, root), scenario), world);
        for (Map.Entry<String, String> parameter : parameters.entrySet()) {
            h = take(take(h, parameter.getKey()), parameter.getValue());
        }
        return take(h, replicate);
    }

    /** The seed shared by replicates of one number in all worlds and for all parameters. */
    static long paired(long root, String scenario, long replicate) {
        Checks.present("scenario", scenario);
        return take(take(take(0, root), scenario), replicate);
    }

    /** The seed of one part of a replicate, by its name. */
    static long of(long seed, String part) {
        return take(take(0, seed), part);
    }

    private static long take(long h, String text) {
        long taken = h;
        for (int k = 0; k < text.length(); k++) {
            taken = take(taken, text.charAt(k));
        }
        return take(taken, END);
    }

    private static long take(long h, long word) {
        return mix((h ^ word) + GOLDEN);
    }

    /** A bijective mix of all 64 bits. */
    static long mix(long number) {
        long z = (number ^ (number >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }
}
