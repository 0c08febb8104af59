package robosim.geometry.protocol.batch;

import java.io.Serial;
import robosim.geometry.check.Checks;

/** In place of an answer where no moveable object has the name, or the world refuses the request. */
public record NoAnswer() implements BatchAnswer {
    @Serial
    private static final long serialVersionUID = 1;

    @Override
    public boolean fits(BatchRequest request) {
        Checks.present("request", request);
        return true;
    }
}
