package robosim.geometry.net;

import robosim.geometry.exact.Checks;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.protocol.Beam;

/**
 * What a session takes where a request leaves it open.
 *
 * @param dimension of a world that comes without settings
 * @param accuracy  of a world that comes without settings
 * @param beam      of a sonar request that comes without one; its width in radians
 */
public record SessionOptions(Dimension dimension, Accuracy accuracy, Beam beam) {
    /** RoboSim's own: a planar world, compared exactly, and a line without an end. */
    public static final SessionOptions ROBOSIM = new SessionOptions(Dimension.PLANAR, Accuracy.EXACT, Beam.LINE);

    /** Refuses null. */
    public SessionOptions {
        Checks.present("dimension", dimension);
        Checks.present("accuracy", accuracy);
        Checks.present("beam", beam);
    }
}
