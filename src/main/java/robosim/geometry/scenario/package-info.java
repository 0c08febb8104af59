/**
 * Scenarios: a world, a conversation and the answers, in one file of text that {@code docs/scenario-format.md} describes.
 * A server {@linkplain robosim.geometry.scenario.Recordings records} one, a {@linkplain robosim.geometry.scenario.Replay
 * replay} carries it out without sockets and compares the answers bit for bit, and people write them by hand.
 *
 * <pre>{@code
 * Scenario scenario = Scenario.read(Path.of("worlds/scenarios/by-hand.scenario.jsonl"));
 * scenario.steps().size();                       // 4
 * List<Mismatch> mismatches = Replay.of(scenario);
 * mismatches.size();                             // 0: every answer is as it was, bit for bit
 * }</pre>
 *
 * <p>Needs Jackson's core beside the module, as JSON lines do.
 */
@NullMarked
package robosim.geometry.scenario;

import org.jspecify.annotations.NullMarked;
