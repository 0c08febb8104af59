package robosim.geometry.sweep;

import java.util.Collections;
import java.util.SortedMap;
import robosim.geometry.Geometry;

/** One replicate as a scenario sees it: a world of its own, chance of its own, and the parameters' values. */
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

    /** The world, as its snapshot has it; the replicate's own to change. */
    public Geometry world() {
        return world;
    }

    /** What the world is called. */
    public String worldName() {
        return worldName;
    }

    /** Chance of this replicate alone. */
    public SeededRandom random() {
        return random;
    }

    /**
     * Chance that replicates of this number have in common, in all worlds and for all values of parameters: who compares
     * values by the same draws needs fewer of them.
     */
    public SeededRandom pairedRandom() {
        return pairedRandom;
    }

    /** Which replicate of its world and parameters this is, from 0. */
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
     * @throws IllegalArgumentException where it has none
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
     * @throws IllegalArgumentException where it has none, or it is no number
     */
    public double number(String parameter) {
        String value = text(parameter);
        try {
            return Double.parseDouble(value);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(parameter + " must be a number (got: " + value + ")", e);
        }
    }

    /** A parameter's value as a number, or another number where it has none. */
    public double number(String parameter, double otherwise) {
        return has(parameter) ? number(parameter) : otherwise;
    }
}
