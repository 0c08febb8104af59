/**
 * Runs a scenario over worlds, parameters and seeds, on any number of threads and machines, with results that are the
 * same to the bit. {@code docs/sweep.md} describes the formats and how seeds are derived.
 *
 * <!-- java: given SweepScenario wayOut -->
 * <pre>{@code
 * Sweep sweep = Sweep.of(wayOut)
 *         .over(SweepWorld.read(Path.of("worlds/maze.xml")))
 *         .vary("step", "0.25", "0.5")
 *         .replicates(1000)
 *         .seed(42);
 * SweepRun.of(sweep, Path.of("way-out.jsonl")).threads(4).run();
 * }</pre>
 *
 * <p>Requires Jackson's core, as JSON lines do.
 */
@NullMarked
package robosim.geometry.sweep;

import org.jspecify.annotations.NullMarked;
