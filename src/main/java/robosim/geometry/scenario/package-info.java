/**
 * Scenarios: a world, a conversation and the answers, in one text file in the format of {@code
 * docs/scenario-format.md}. A server {@linkplain robosim.geometry.scenario.Recordings records} them, a {@linkplain
 * robosim.geometry.scenario.Replay replay} runs them without sockets and compares the answers bit for bit, and people
 * can write them by hand.
 *
 * <ul>
 *   <li>{@link Scenario}: a world, a conversation and the answers, in memory
 *   <li>{@link ScenarioReader} and {@link ScenarioWriter}: the same step by step, for files of any length
 *   <li>{@link Step}: a request, its answer and its {@link Timing}
 *   <li>{@link ScenarioHeader}: title, module and options
 *   <li>{@link Replay}: runs a scenario and finds each {@link Mismatch}
 *   <li>{@link Recordings}: record a session, and each session of a server
 *   <li>{@link Watching}: sends running sessions to those who watch
 *   <li>{@link ScenarioException}: a file that is no scenario
 * </ul>
 *
 * <pre>{@code
 * Scenario scenario = Scenario.read(Path.of("worlds/scenarios/by-hand.scenario.jsonl"));
 * scenario.steps().size();                       // 4
 * List<Mismatch> mismatches = Replay.of(scenario);
 * mismatches.size();                             // 0: every answer is as it was, bit for bit
 * }</pre>
 *
 * <p>Requires Jackson's core, as JSON lines do.
 */
@NullMarked
package robosim.geometry.scenario;

import org.jspecify.annotations.NullMarked;
