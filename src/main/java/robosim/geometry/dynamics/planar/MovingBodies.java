package robosim.geometry.dynamics.planar;

import java.util.Arrays;
import robosim.geometry.exact.DoubleDouble;

/**
 * The bodies on their way, by index. Each has a time of its own, to which it has come; from there it goes on with the velocity
 * that it has.
 */
final class MovingBodies {
    private static final int FIRST = 8;

    int count;

    /** Ids in the world. */
    int[] id = new int[FIRST];

    /** The time of the step that each has come to, and where it is then: the centre, and radians since the step began. */
    double[] time = new double[FIRST];

    double[] x = new double[FIRST];
    double[] z = new double[FIRST];
    double[] angle = new double[FIRST];

    // m/s and radians a second.
    double[] vx = new double[FIRST];
    double[] vz = new double[FIRST];
    double[] w = new double[FIRST];

    /** One over the mass; 0 for what nothing moves. */
    double[] lightness = new double[FIRST];

    /** One over the moment of inertia. */
    double[] ease = new double[FIRST];

    /** One over the mass and the inertia as long as the body is not held. */
    double[] ownLightness = new double[FIRST];

    double[] ownEase = new double[FIRST];

    /** The centre of mass as seen from the object's own centre, in axes that turn with its heading. */
    double[] offsetX = new double[FIRST];

    double[] offsetZ = new double[FIRST];

    /** The greatest distance of any of its points from the centre. */
    double[] size = new double[FIRST];

    /** Whether a drive pushes the body, so that it keeps no momentum. */
    boolean[] isDriven = new boolean[FIRST];

    int[] firstPiece = new int[FIRST];
    int[] pieces = new int[FIRST];

    /** How often the velocity of each has been changed in this step. */
    int[] changes = new int[FIRST];

    /** Runs between two parts of the work of a step, so that one step cannot keep others waiting. */
    Runnable betweenParts = () -> {};

    int add() {
        if (count == id.length) {
            int room = 2 * count;
            id = Arrays.copyOf(id, room);
            time = Arrays.copyOf(time, room);
            x = Arrays.copyOf(x, room);
            z = Arrays.copyOf(z, room);
            angle = Arrays.copyOf(angle, room);
            vx = Arrays.copyOf(vx, room);
            vz = Arrays.copyOf(vz, room);
            w = Arrays.copyOf(w, room);
            lightness = Arrays.copyOf(lightness, room);
            ease = Arrays.copyOf(ease, room);
            ownLightness = Arrays.copyOf(ownLightness, room);
            ownEase = Arrays.copyOf(ownEase, room);
            offsetX = Arrays.copyOf(offsetX, room);
            offsetZ = Arrays.copyOf(offsetZ, room);
            size = Arrays.copyOf(size, room);
            isDriven = Arrays.copyOf(isDriven, room);
            firstPiece = Arrays.copyOf(firstPiece, room);
            pieces = Arrays.copyOf(pieces, room);
            changes = Arrays.copyOf(changes, room);
        }
        return count++;
    }

    /** Whether a body's centre of mass is not where its object has its own centre. */
    boolean isOffset(int b) {
        return offsetX[b] != 0 || offsetZ[b] != 0;
    }

    /** How far the centre of mass is from the object's centre along X, in a direction given by its cosine and sine. */
    double asideX(int b, double cos, double sin) {
        return cos * offsetX[b] + sin * offsetZ[b];
    }

    double asideZ(int b, double cos, double sin) {
        return cos * offsetZ[b] - sin * offsetX[b];
    }

    /** Where a body is at a time at which its velocity has not changed since its own. */
    double xAt(int b, double t) {
        return x[b] + vx[b] * (t - time[b]);
    }

    double zAt(int b, double t) {
        return z[b] + vz[b] * (t - time[b]);
    }

    double angleAt(int b, double t) {
        return angle[b] + w[b] * (t - time[b]);
    }

    /** Lets a body come to a time. */
    void advance(int b, double t) {
        if (t != time[b]) {
            x[b] = xAt(b, t);
            z[b] = zAt(b, t);
            angle[b] = angleAt(b, t);
            time[b] = t;
        }
    }

    boolean isStill(int b) {
        return vx[b] == 0 && vz[b] == 0 && w[b] == 0;
    }

    void stop(int b) {
        vx[b] = 0;
        vz[b] = 0;
        w[b] = 0;
    }

    /** Nothing moves the body any more in this step. */
    void hold(int b) {
        stop(b);
        lightness[b] = 0;
        ease[b] = 0;
    }

    double energy(int b) {
        return lightness[b] == 0 ? 0 : 0.5 * ((vx[b] * vx[b] + vz[b] * vz[b]) / lightness[b] + w[b] * w[b] / ease[b]);
    }

    /**
     * Gives bodies an angular momentum in addition to what they have, about any point, without changing their momentum. They
     * turn about their common centre as if they were one rigid body, which changes no speed at which two of them approach; if
     * that takes energy, their other motions are slowed to provide it. If these have less, they get what they can provide.
     *
     * @param list  of free bodies
     * @param extra kg m^2/s
     */
    void turnTogether(int[] list, int listed, double extra) {
        double mass = 0;
        double centreX = 0;
        double centreZ = 0;
        double driftX = 0;
        double driftZ = 0;
        for (int k = 0; k < listed; k++) {
            int b = list[k];
            double m = 1 / lightness[b];
            mass += m;
            centreX += m * x[b];
            centreZ += m * z[b];
            driftX += m * vx[b];
            driftZ += m * vz[b];
        }
        centreX /= mass;
        centreZ /= mass;
        driftX /= mass;
        driftZ /= mass;
        double inertia = 0;
        double spin = 0;
        double moving = 0;
        for (int k = 0; k < listed; k++) {
            int b = list[k];
            double m = 1 / lightness[b];
            double atX = x[b] - centreX;
            double atZ = z[b] - centreZ;
            double ownX = vx[b] - driftX;
            double ownZ = vz[b] - driftZ;
            inertia += m * (atX * atX + atZ * atZ) + 1 / ease[b];
            spin += m * (atZ * ownX - atX * ownZ) + w[b] / ease[b];
            moving += 0.5 * (m * (ownX * ownX + ownZ * ownZ) + w[b] * w[b] / ease[b]);
        }
        double most = Math.sqrt(2 * inertia * moving);
        double wanted = Math.max(-most, Math.min(most, spin + extra));
        double inner = moving - 0.5 * spin * spin / inertia;
        double left = moving - 0.5 * wanted * wanted / inertia;
        double share = inner > 0 && left < inner ? Math.sqrt(Math.max(0, left) / inner) : 1;
        double turn = (wanted - share * spin) / inertia;
        for (int k = 0; k < listed; k++) {
            int b = list[k];
            vx[b] = driftX + share * (vx[b] - driftX) + turn * (z[b] - centreZ);
            vz[b] = driftZ + share * (vz[b] - driftZ) - turn * (x[b] - centreX);
            w[b] = share * w[b] + turn;
        }
    }

    /** The sum of a number and its rest, and another number; the rest goes to {@code rests[at]}. */
    static double add(double[] sums, double[] rests, int at, double by) {
        double sum = sums[at] + by;
        rests[at] += DoubleDouble.sumTail(sums[at], by, sum);
        sums[at] = sum;
        return sum;
    }
}
