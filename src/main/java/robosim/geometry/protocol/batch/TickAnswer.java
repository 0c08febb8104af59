package robosim.geometry.protocol.batch;

import java.io.Serial;
import robosim.geometry.check.Checks;

/**
 * What was measured in all copies of a world, in order; of each for all bodies, or beams, that were asked for.
 *
 * @param states    eight numbers for each body: X, Y and Z of its centre, its heading in radians, its velocity along its own axes, and
 *     its speed of turning in radians a second
 * @param touches   for each body in how many contacts it is with objects other than those bodies
 * @param distances of all beams; {@code +Infinity} where nothing echoes
 * @param singles   the same in single precision, as {@link Float#floatToIntBits} has them, in place of the distances
 */
public record TickAnswer(Numbers states, Integers touches, Numbers distances, Integers singles) implements BatchAnswer {
    @Serial
    private static final long serialVersionUID = 1;

    /** How many numbers belong to the state of a body. */
    public static final int STRIDE = 8;

    /** Refuses null, and states and touches of different numbers of bodies. */
    public TickAnswer {
        Checks.present("states", states);
        Checks.present("touches", touches);
        Checks.present("distances", distances);
        Checks.present("singles", singles);
        Checks.refuse(
                states.size() != STRIDE * touches.size(),
                "states must have " + STRIDE + " numbers for each of " + touches.size() + " touches",
                states.size());
    }

    @Override
    public boolean fits(BatchRequest request) {
        Checks.present("request", request);
        return request instanceof CopyRequest.Tick tick
                && touches.size() == tick.copies() * tick.bodies().size()
                && (tick.single() ? distances : singles).equals(tick.single() ? Numbers.NONE : Integers.NONE)
                && touches.size() + distances.size() + singles.size() == tick.size();
    }
}
