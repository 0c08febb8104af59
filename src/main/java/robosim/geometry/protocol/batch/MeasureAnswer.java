package robosim.geometry.protocol.batch;

import java.io.Serial;
import robosim.geometry.check.Checks;

/**
 * What was measured.
 *
 * @param numbers those of each place or motion, one after the other, as {@link MeasureRequest.Question} lists them
 */
public record MeasureAnswer(Numbers numbers) implements BatchAnswer {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses null. */
    public MeasureAnswer {
        Checks.present("numbers", numbers);
    }

    @Override
    public boolean fits(BatchRequest request) {
        return request instanceof MeasureRequest measure
                && numbers.size() == measure.size() * measure.question().answered;
    }
}
