/**
 * Scenarios: a world, a conversation and the answers, in one file of text that {@code docs/scenario-format.md} describes.
 * A server {@linkplain robosim.geometry.scenario.Recordings records} one, a {@linkplain robosim.geometry.scenario.Replay
 * replay} carries it out without sockets and compares the answers bit for bit, and people write them by hand.
 *
 * <!-- java: compiled -->
 * <pre>{@code
 * for (Mismatch mismatch : Replay.of(Scenario.read(Path.of("bug.scenario.jsonl")))) {
 *     System.out.println(mismatch);
 * }
 * }</pre>
 *
 * <p>Needs Jackson's core beside the module, as JSON lines do.
 */
@NullMarked
package robosim.geometry.scenario;

import org.jspecify.annotations.NullMarked;
