package robosim.geometry.sweep;

import java.io.Serializable;
import java.util.SortedMap;
import robosim.geometry.check.Checks;

/**
 * The code that runs in each replicate of a sweep. Many threads run it at once, each with its own replicate: an
 * implementation must keep no state from one run to the next, and must take random numbers only from its replicate.
 *
 * <p>Serializable, so that a distributed engine can send it to other machines. The command {@code sweep} creates it
 * through its constructor without arguments.
 */
@FunctionalInterface
public interface SweepScenario extends Serializable {
    /**
     * Carries out one replicate.
     *
     * @throws Exception if it fails; the failure becomes the replicate's outcome, and the sweep goes on
     */
    Result run(Replicate replicate) throws Exception;

    /**
     * Refuses a parameter or a value of it before anything is run. Called for each value given to a sweep, except those
     * of the world's own parameters; the default accepts all.
     *
     * @throws IllegalArgumentException if it does not know the parameter, or cannot use the value
     */
    default void check(String parameter, String value) {}

    /**
     * Whether replicates with these values can differ, as far as the scenario can tell. Where none can, a sweep of several
     * replicates repeats itself, and the command says so. The default is true.
     */
    default boolean isRandom(SortedMap<String, String> parameters) {
        return true;
    }

    /**
     * A short text that tells this scenario from another of the same name: results with different fingerprints are not
     * resumed or merged. Empty by default, since a class's code is not examined. An implementation may return a digest,
     * as {@link ScenarioSweep} does for its file, or a version number.
     */
    default String fingerprint() {
        return "";
    }

    /**
     * The name in the results, from which seeds are derived too. By default the name of the class; that of a lambda
     * differs in each run, so give it one with {@link ParameterSweep#of(String, SweepScenario)}.
     */
    default String name() {
        Class<?> type = getClass();
        Checks.refuse(type.isHidden() || type.isSynthetic(), "a scenario that is a lambda must be given a name", type);
        return type.getName();
    }
}
