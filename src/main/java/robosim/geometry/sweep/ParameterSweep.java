package robosim.geometry.sweep;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.WorkLimit;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.sweep.lines.Fingerprint;
import robosim.geometry.sweep.lines.Names;

/**
 * A scenario over worlds, parameters and seeds: every world with every combination of values is a cell, and every cell
 * has the same number of replicates. A replicate is identified by its index, and its outcome depends on nothing else.
 * Immutable: each method returns another sweep.
 *
 * <p>Safe to use from many threads at once, and serializable if its scenario is; the worlds' static objects are shared
 * by all replicates. The parameters {@link #ACCURACY} and {@link #DIMENSION} set the world's own; all others are the
 * scenario's.
 */
public final class ParameterSweep implements Serializable {
    /** The parameter that sets the world's {@link Accuracy}. */
    public static final String ACCURACY = "accuracy";

    /** The parameter that sets the world's {@link Dimension}. */
    public static final String DIMENSION = "dimension";

    private static final long serialVersionUID = 1;

    private final String name;
    private final SweepScenario scenario;

    @SuppressWarnings("serial") // always a list of the JDK, which is serializable
    private final List<SweepWorld> worlds;

    @SuppressWarnings("serial") // a tree map of such lists
    private final SortedMap<String, List<String>> parameters;

    private final long replicates;
    private final long seed;

    /** The most units of work of a replicate. */
    private long work = Long.MAX_VALUE;

    private transient SweepWorld.Views views = new SweepWorld.Views();

    private ParameterSweep(
            String name,
            SweepScenario scenario,
            List<SweepWorld> worlds,
            Map<String, List<String>> parameters,
            long replicates,
            long seed) {
        this.name = Names.check("name of a scenario", name);
        this.scenario = scenario;
        this.worlds = List.copyOf(worlds);
        this.parameters = new TreeMap<>(parameters);
        this.replicates = replicates;
        this.seed = seed;
    }

    /** A sweep over no worlds yet, with one replicate of each cell and root seed 0. */
    public static ParameterSweep of(SweepScenario scenario) {
        Checks.present("scenario", scenario);
        return of(scenario.name(), scenario);
    }

    /** The same with a given name, for a lambda, which has none. */
    public static ParameterSweep of(String name, SweepScenario scenario) {
        Checks.present("scenario", scenario);
        return new ParameterSweep(name, scenario, List.of(), Map.of(), 1, 0);
    }

    /** This sweep over one more world. */
    public ParameterSweep over(SweepWorld world) {
        Checks.present("world", world);
        if (worlds.stream().anyMatch(each -> each.name().equals(world.name()))) {
            throw new IllegalArgumentException("worlds must have names of their own (got twice: " + world.name() + ")");
        }
        List<SweepWorld> more = new ArrayList<>(worlds);
        more.add(world);
        return new ParameterSweep(name, scenario, more, parameters, replicates, seed).with(work);
    }

    /**
     * This sweep over the values of a parameter, in this order; they replace earlier ones.
     *
     * @throws IllegalArgumentException if a value is not valid for the parameter, or the scenario {@linkplain
     *                                  SweepScenario#check refuses} it
     */
    public ParameterSweep vary(String parameter, String... values) {
        Names.check("name of a parameter", parameter);
        Checks.present("values", values);
        Checks.refuse(
                values.length == 0 || Arrays.stream(values).distinct().count() < values.length,
                "values of " + parameter + " must be at least one, and each once",
                Arrays.toString(values));
        for (String value : values) {
            Names.check("value of " + parameter, value);
            if (parameter.equals(ACCURACY)) {
                constant(ACCURACY, Accuracy.class, value);
            } else if (parameter.equals(DIMENSION)) {
                constant(DIMENSION, Dimension.class, value);
            } else {
                scenario.check(parameter, value);
            }
        }
        Map<String, List<String>> more = new TreeMap<>(parameters);
        more.put(parameter, List.of(values));
        return new ParameterSweep(name, scenario, worlds, more, replicates, seed).with(work);
    }

    private static <E extends Enum<E>> E constant(String parameter, Class<E> type, String value) {
        try {
            return Enum.valueOf(type, value.toUpperCase(Locale.ROOT));
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(
                    parameter + " must be one of " + Arrays.toString(type.getEnumConstants()) + " (got: " + value + ")",
                    e);
        }
    }

    /** This sweep with another number of replicates of each cell, at least 1. */
    public ParameterSweep replicates(long number) {
        Checks.refuse(
                number < 1 || number > Integer.MAX_VALUE, "replicates must be from 1 to " + Integer.MAX_VALUE, number);
        return new ParameterSweep(name, scenario, worlds, parameters, number, seed).with(work);
    }

    /** This sweep with another root seed. */
    public ParameterSweep seed(long root) {
        return new ParameterSweep(name, scenario, worlds, parameters, replicates, root).with(work);
    }

    /**
     * This sweep with a limit of each replicate: one in which its world would take more units of {@link WorkLimit} fails, always
     * the same ones.
     *
     * @param units at least 0
     */
    public ParameterSweep limitWork(long units) {
        return new ParameterSweep(name, scenario, worlds, parameters, replicates, seed)
                .with(WorkLimit.of(units).units());
    }

    private ParameterSweep with(long units) {
        work = units; // this sweep is a new one
        return this;
    }

    /** The header of its results, which identifies the sweep. */
    public SweepHeader header() {
        Map<String, String> prints = new LinkedHashMap<>();
        worlds.forEach(world -> prints.put(world.name(), Fingerprint.of(world.snapshot())));
        Map<String, String> values = new LinkedHashMap<>();
        parameters.forEach((parameter, each) -> values.put(parameter, String.join(",", each)));
        return new SweepHeader(name, scenario.fingerprint(), seed, replicates, prints, values);
    }

    /**
     * The number of cells: worlds times combinations of values.
     *
     * @throws IllegalStateException if there is no world yet
     */
    public long cells() {
        long cells = worlds.size();
        if (cells == 0) {
            throw new IllegalStateException("a sweep must have at least one world; add it by over(world) (got: none)");
        }
        for (List<String> values : parameters.values()) {
            cells = times(cells, values.size());
        }
        return cells;
    }

    /**
     * The total number of replicates.
     *
     * @throws IllegalStateException if there is no world yet
     */
    public long size() {
        return times(cells(), replicates);
    }

    /** Whether it has one replicate of each cell, or those of some cell can differ. */
    public boolean canDiffer() {
        long cells = replicates == 1 ? 0 : cells();
        boolean differs = cells == 0;
        for (long cell = 0; cell < cells && !differs; cell += worlds.size()) {
            differs = scenario.isRandom(Collections.unmodifiableSortedMap(values(cell)));
        }
        return differs;
    }

    private static long times(long count, long by) {
        if (Math.multiplyHigh(count, by) != 0 || count * by < 0) {
            throw new IllegalArgumentException("a sweep must have fewer than 2^63 replicates (got: more)");
        }
        return count * by;
    }

    /** Whether a replicate belongs to a shard. */
    public boolean isOf(Shard shard, long index) {
        Checks.present("shard", shard);
        return shard.has(index % cells(), index / cells());
    }

    private SortedMap<String, String> values(long cell) {
        SortedMap<String, String> values = new TreeMap<>();
        long rest = cell / worlds.size();
        for (Map.Entry<String, List<String>> parameter : parameters.entrySet()) {
            int count = parameter.getValue().size();
            values.put(parameter.getKey(), parameter.getValue().get((int) (rest % count)));
            rest /= count;
        }
        return values;
    }

    /**
     * Runs one replicate. Safe to call from many threads at once.
     *
     * @param index from 0 up to, not including, {@link #size()}
     */
    public Outcome run(long index) {
        if (index < 0 || index >= size()) {
            throw new IllegalArgumentException("index must be from 0 to " + (size() - 1) + " (got: " + index + ")");
        }
        long cell = index % cells();
        long number = index / cells();
        int at = (int) (cell % worlds.size());
        SweepWorld world = worlds.get(at);
        SortedMap<String, String> values = values(cell);
        long own = Seeds.of(seed, name, world.name(), values, number);
        long paired = Seeds.paired(seed, name, number);
        try {
            Snapshot snapshot = snapshot(at, world, values);
            Geometry made = snapshot.toGeometry();
            Result result = run(made, new Replicate(made, world.name(), values, number, own, paired));
            return Outcome.of(index, world.name(), values, number, own, result);
        } catch (StackOverflowError e) {
            return Outcome.failed(index, world.name(), values, number, own, e);
        } catch (VirtualMachineError e) {
            throw e; // out of memory or a broken JVM: the next replicate would fail too
        } catch (Throwable e) {
            return Outcome.failed(index, world.name(), values, number, own, e);
        }
    }

    /** Runs a replicate within its limit of work, if it has one. */
    private Result run(Geometry world, Replicate replicate) throws Exception {
        if (work == Long.MAX_VALUE) {
            return scenario.run(replicate);
        }
        world.limitWork(WorkLimit.of(work));
        Callable<Result> run = () -> scenario.run(replicate);
        return world.together("a replicate", () -> ParameterSweep.<RuntimeException>called(run));
    }

    /** Calls something; what it throws goes on as it is, checked or not. */
    @SuppressWarnings({"unchecked", "TypeParameterUnusedInFormals"})
    private static <E extends Exception> Result called(Callable<Result> run) throws E {
        try {
            return run.call();
        } catch (Exception e) {
            throw (E) e;
        }
    }

    private Snapshot snapshot(int at, SweepWorld world, SortedMap<String, String> values) {
        String accuracy = values.get(ACCURACY);
        String dimension = values.get(DIMENSION);
        return views.of(
                at,
                world,
                dimension == null ? world.snapshot().dimension() : constant(DIMENSION, Dimension.class, dimension),
                accuracy == null ? world.snapshot().accuracy() : constant(ACCURACY, Accuracy.class, accuracy));
    }

    @Serial
    private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
        in.defaultReadObject();
        views = new SweepWorld.Views();
    }
}
