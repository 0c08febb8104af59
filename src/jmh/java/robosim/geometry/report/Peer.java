package robosim.geometry.report;

import robosim.geometry.cases.HardCase;

/** Another engine that can be asked some of the questions. */
public interface Peer {
    String name();

    String version();

    /** Whether two things touch or overlap. */
    boolean overlap(Outline a, Outline b) throws CannotException;

    /** The distance along a line of a length, or +Infinity. */
    double ray(double[] from, double[] direction, double length, Outline of) throws CannotException;

    /** The least distance of two things. */
    double gap(Outline a, Outline b) throws CannotException;

    /** The free share of a straight way or a turn, or +Infinity where all of it is. */
    double move(Outline mover, HardCase.Drive drive, Outline other) throws CannotException;

    /** What its distances, rays and times may be off by, by its own declaration; world units. */
    double tolerance();

    /** What it says of its sets. */
    boolean hasOpenSets();

    /** A question that an engine has no words for. */
    final class CannotException extends Exception {
        private static final long serialVersionUID = 1;

        CannotException(String why) {
            super(why);
        }
    }
}
