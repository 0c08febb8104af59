package robosim.geometry.net.session;

import robosim.geometry.check.Text;
import robosim.geometry.exact.Degrees;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.WorldRequest;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.DriveSettings;

/**
 * Looks for turns above a whole one, which mostly were meant in degrees. They are legal and carried out; the first of a world is
 * told.
 */
public final class LargeTurnWarning {
    private static final double WHOLE = 2 * Math.PI;

    private final WarningLog log;
    private boolean isTold;

    /**
     * Nothing so far.
     *
     * @param log takes the sentence about the first one of a world
     */
    public LargeTurnWarning(WarningLog log) {
        this.log = log;
    }

    /** Begins with a new world. */
    public void forget() {
        isTold = false;
    }

    /** Looks at the moves and places of a request before it is carried out. */
    public void look(Bundle request) {
        if (isTold) {
            return;
        }
        if (request instanceof MoveBundle moves) {
            for (MoveRequest move : moves.moves()) {
                look(move.objectName(), move.rx(), move.ry());
            }
        } else if (request instanceof BatchRequestBundle batch) {
            for (BatchRequest each : batch.requests()) {
                look(each);
            }
        }
    }

    /** Looks at a step that was carried out; the turn of a drive of forces is none. */
    public void look(StepBundle step, BodyStepper motion) {
        for (DriveCommand command : step.commands()) {
            if (motion.kind(command.objectName()) != DriveSettings.Kind.FORCE) {
                look("turn", "radians a second", command.objectName(), command.turn());
            }
        }
    }

    private void look(BatchRequest request) {
        if (request instanceof WorldRequest.Identify identify) {
            look(identify.request());
        } else if (request instanceof WorldRequest.Place place) {
            look("heading", "radians", place.objectName(), place.heading());
        } else if (request instanceof WorldRequest.Go go) {
            look(go.objectName(), go.rx(), go.ry());
        } else if (request instanceof WorldRequest.GoToContact go) {
            look(go.objectName(), go.rx(), go.ry());
        } else if (request instanceof WorldRequest.GoAndSlide go) {
            look(go.objectName(), go.rx(), go.ry());
        }
    }

    private void look(String name, double rx, double ry) {
        look("rx", "radians", name, rx);
        look("ry", "radians", name, ry);
    }

    private void look(String argument, String unit, String name, double value) {
        if (isTold || !(Math.abs(value) > WHOLE)) {
            return;
        }
        isTold = true;
        log.warn(argument + " of " + Text.quoted(name) + " is " + value + " " + unit
                + ", more than a whole turn; angles are in radians, and " + value + " degrees are "
                + Degrees.toRadians(value) + " of them. Others in this world are not logged");
    }
}
