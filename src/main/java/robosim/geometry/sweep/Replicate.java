package robosim.geometry.sweep;

import java.util.Collections;
import java.util.SortedMap;
import java.util.random.RandomGenerator;
import robosim.geometry.Geometry;

/** One replicate as a scenario sees it: its own world, its own random stream, and the parameters' values. */
public final class Replicate {
    private final Geometry world;
    private final String worldName;
    private final SortedMap<String, String> parameters;
    private final long number;
    private final long seed;
    private final SeededRandom random;
    private final SeededRandom pairedRandom;

    Replicate(
            Geometry world,
            String worldName,
            SortedMap<String, String> parameters,
            long number,
            long seed,
            long pairedSeed) {
        this.world = world;
        this.worldName = worldName;
        this.parameters = parameters;
        this.number = number;
        this.seed = seed;
        this.random = new SeededRandom(seed);
        this.pairedRandom = new SeededRandom(pairedSeed);
    }

    /** The world, in the state of its snapshot; the replicate may change it. */
    public Geometry world() {
        return world;
    }

    /** The world's name. */
    public String worldName() {
        return worldName;
    }

    /**
     * The random stream of this replicate alone: SplitMix64 (Steele, Lea and Flood 2014) from {@link #seed}. Its {@code nextLong},
     * {@code nextInt}, {@code nextBoolean}, {@code nextDouble} and {@code nextGaussian} give the same bits on every JVM, and will
     * never change; the other methods of a {@link RandomGenerator} are the JDK's and may change with it.
     */
    public RandomGenerator random() {
        return random;
    }

    /**
     * A random stream shared by all replicates of this number, in all worlds and for all values of parameters (common
     * random numbers): comparisons based on the same draws need fewer replicates.
     */
    public RandomGenerator pairedRandom() {
        return pairedRandom;
    }

    /** The number of this replicate for its world and parameters, from 0. */
    public long number() {
        return number;
    }

    /** The seed of {@link #random()}. */
    public long seed() {
        return seed;
    }

    /** The values of all parameters, by name. */
    public SortedMap<String, String> parameters() {
        return Collections.unmodifiableSortedMap(parameters);
    }

    /** Whether a parameter has a value. */
    public boolean has(String parameter) {
        return parameters.containsKey(parameter);
    }

    /**
     * A parameter's value.
     *
     * @throws IllegalArgumentException if it has none
     */
    public String text(String parameter) {
        String value = parameters.get(parameter);
        if (value == null) {
            throw new IllegalArgumentException("parameter must be one of " + parameters.keySet() + ", or the sweep must"
                    + " be given values of it (got: " + parameter + ")");
        }
        return value;
    }

    /**
     * A parameter's value as a number.
     *
     * @throws IllegalArgumentException if it has none, or it is not a number
     */
    public double number(String parameter) {
        String value = text(parameter);
        try {
            return Double.parseDouble(value);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(parameter + " must be a number (got: " + value + ")", e);
        }
    }

    /** A parameter's value as a number, or {@code otherwise} if it has none. */
    public double number(String parameter, double otherwise) {
        return has(parameter) ? number(parameter) : otherwise;
    }
}
