package robosim.geometry.protocol;

import java.io.Serial;
import java.util.List;
import robosim.geometry.check.Checks;

/**
 * As a request, moves to make, in order; as an answer, the moves that were made, in the same order.
 *
 * @param moves the moves, each carried out in the world as the earlier ones left it
 */
public record MoveBundle(List<MoveRequest> moves) implements Bundle {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses a list or a move that is null. */
    public MoveBundle {
        moves = Checks.copy("moves", moves, MoveRequest.class);
    }
}
