package robosim.geometry.net;

import robosim.geometry.check.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.protocol.Beam;

/**
 * A session's defaults for what a request leaves out.
 *
 * @param dimension of a world that comes without settings
 * @param accuracy  of a world that comes without settings
 * @param beam      of a sonar request that comes without one; its width in radians
 */
public record SessionOptions(Dimension dimension, Accuracy accuracy, Beam beam) {
    /** RoboSim's options: a planar world at exact accuracy, and a beam without width or end. */
    public static final SessionOptions ROBOSIM = new SessionOptions(Dimension.PLANAR, Accuracy.EXACT, Beam.LINE);

    /** Refuses null. */
    public SessionOptions {
        Checks.present("dimension", dimension);
        Checks.present("accuracy", accuracy);
        Checks.present("beam", beam);
    }
}
