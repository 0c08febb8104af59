package robosim.geometry.sweep;

import java.io.Serializable;

/**
 * What is carried out in each replicate of a sweep. Many threads run it at once, each with a replicate of its own: an
 * implementation keeps nothing from one run to the next, and takes chance from its replicate alone.
 *
 * <p>Serializable, so that an engine can send it to other machines. The command {@code sweep} makes one by its class's
 * constructor without arguments.
 */
@FunctionalInterface
public interface SweepScenario extends Serializable {
    /**
     * Carries out one replicate.
     *
     * @throws Exception where it fails; that becomes the replicate's outcome, and the sweep goes on
     */
    Result run(Replicate replicate) throws Exception;

    /**
     * Refuses a parameter, or a value of it, before anything is carried out. Asked of each value that a sweep is given,
     * but of those that are the world's own; this one takes them all.
     *
     * @throws IllegalArgumentException where it does not know the parameter, or cannot use the value
     */
    default void check(String parameter, String value) {}

    /**
     * What tells this scenario from another of its name: results are not resumed by, nor merged with, those of another one.
     * Here it is empty: a class's code is not looked at. Who knows better, as {@link ScenarioSweep} does of its file,
     * answers a digest of it or a number of its version; a short text.
     */
    default String fingerprint() {
        return "";
    }

    /**
     * What results are filed under; seeds are made from it too. A class's own name; what was written as a lambda has another
     * one in each run, and is given one by {@link Sweep#of(String, SweepScenario)}.
     */
    default String name() {
        Class<?> type = getClass();
        if (type.isHidden() || type.isSynthetic()) {
            throw new IllegalArgumentException("a scenario that is a lambda must be given a name (got: " + type + ")");
        }
        return type.getName();
    }
}
