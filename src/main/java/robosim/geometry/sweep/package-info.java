/**
 * Runs a scenario over worlds, parameters and seeds, on any number of threads and machines, with results that are the
 * same to the bit. {@code docs/sweep.md} describes the formats and how seeds are derived.
 *
 * <ul>
 *   <li>{@link ParameterSweep}: which scenario, worlds, parameters, seeds
 *   <li>{@link SweepScenario}: one run, in Java; {@link ScenarioSweep} runs a recorded scenario
 *   <li>{@link SweepWorld}: a world, by name
 *   <li>{@link Replicate} and {@link Result}: what a run is given, and the numbers that it returns
 *   <li>{@link SweepRun}: runs a sweep, or a {@link Shard} of it, into a file
 *   <li>{@link SweepResults}: reads files of results: a {@link SweepHeader}, and each {@link Outcome}
 *   <li>{@link SweepSummary}: means and spreads, as a table or a picture
 * </ul>
 *
 * <!-- java: given SweepScenario wayOut -->
 * <pre>{@code
 * ParameterSweep sweep = ParameterSweep.of(wayOut)
 *         .over(SweepWorld.read(Path.of("worlds/maze.xml")))
 *         .vary("step", "0.25", "0.5")
 *         .replicates(1000)
 *         .seed(42);
 * SweepRun.of(sweep, Path.of("way-out.jsonl")).withThreads(4).run();
 * }</pre>
 *
 * <p>Requires Jackson's core, as JSON lines do.
 */
@NullMarked
package robosim.geometry.sweep;

import org.jspecify.annotations.NullMarked;
