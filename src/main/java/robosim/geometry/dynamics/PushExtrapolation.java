package robosim.geometry.dynamics;

import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Twist;

/**
 * How much of a push by a drive a body keeps once its contacts have answered. While the same contacts push and slide, it keeps
 * the same share each time, so what is missing shrinks as a geometric series: a push that is divided by this share arrives at
 * once (Aitken's extrapolation, 1926).
 */
final class PushExtrapolation implements Cloneable {
    /** Shares that differ by less, as a part of them, are the same. */
    private static final double STEADY = 0x1p-10;

    /** Where less is kept, something that cannot be moved is in the way. */
    private static final double LEAST = 0x1p-8;

    private long round = -2;
    private double kept;

    // The velocity before the last push and the push, along the body's own axes, m/s and radians a second.
    private double x;
    private double z;
    private double turn;
    private double pushX;
    private double pushZ;
    private double pushTurn;

    PushExtrapolation copy() {
        try {
            return (PushExtrapolation) clone();
        } catch (CloneNotSupportedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Whether the last push was in this round. */
    boolean isOf(long pushing) {
        return round == pushing;
    }

    /**
     * By how much a push is to be larger than what is missing.
     *
     * @param pushing  the number of the round; one above that of the last push if that was in the same collision
     * @param gyration the square of the radius of gyration, which makes an energy of velocities and turns
     */
    double stretch(Twist now, long pushing, double gyration) {
        double share = Double.NaN;
        if (pushing == round + 1) {
            double energy = pushX * pushX + pushZ * pushZ + gyration * pushTurn * pushTurn;
            double left = (now.x() - x) * pushX
                    + (now.z() - z) * pushZ
                    + gyration * (Degrees.toRadians(now.ry()) - turn) * pushTurn;
            share = left / energy;
        }
        boolean isSteady = Math.abs(share - kept) <= STEADY * kept && share >= LEAST && share < 1;
        kept = share;
        return isSteady ? 1 / share : 1;
    }

    void pushed(Twist before, Twist after, long pushing) {
        round = pushing;
        x = before.x();
        z = before.z();
        turn = Degrees.toRadians(before.ry());
        pushX = after.x() - before.x();
        pushZ = after.z() - before.z();
        pushTurn = Degrees.toRadians(after.ry() - before.ry());
    }
}
