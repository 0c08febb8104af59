package robosim.geometry.dynamics.spatial;

import java.util.Arrays;

/** Points at which bodies touch or nearly do; columns of numbers. */
final class Contacts {
    private static final int FIRST = 64;

    int count;

    /** The body, and the other one; -1 where that stands still. */
    int[] body = new int[FIRST];

    int[] other = new int[FIRST];

    /** The id of the other object; -1 for the border of the world. */
    int[] object = new int[FIRST];

    /** Three numbers each: the point, and the unit normal towards the body. */
    double[] point = new double[3 * FIRST];

    double[] normal = new double[3 * FIRST];

    /** Which of the pieces around the body it is with. */
    int[] piece = new int[FIRST];

    /** How far the two are apart there. */
    double[] apart = new double[FIRST];

    /** What the body has been given along the normal, newton seconds. */
    double[] impulse = new double[FIRST];

    /** The part of it that acts all through a time, as against gravity and drives; not the bounce when that begins. */
    double[] lasting = new double[FIRST];

    void clear() {
        count = 0;
    }

    /** Adds a contact from other columns. */
    void add(Contacts of, int k) {
        int n = 3 * k;
        double[] p = of.point;
        double[] along = of.normal;
        add(
                of.body[k],
                of.other[k],
                of.object[k],
                p[n],
                p[n + 1],
                p[n + 2],
                along[n],
                along[n + 1],
                along[n + 2],
                of.apart[k]);
        lasting[count - 1] = of.lasting[k];
    }

    void add(
            int ofBody,
            int otherBody,
            int otherObject,
            double x,
            double y,
            double z,
            double nx,
            double ny,
            double nz,
            double gap) {
        if (count == body.length) {
            grow();
        }
        int k = count++;
        body[k] = ofBody;
        other[k] = otherBody;
        object[k] = otherObject;
        point[3 * k] = x;
        point[3 * k + 1] = y;
        point[3 * k + 2] = z;
        normal[3 * k] = nx;
        normal[3 * k + 1] = ny;
        normal[3 * k + 2] = nz;
        apart[k] = gap;
        impulse[k] = 0;
        lasting[k] = 0;
    }

    /** Leaves what was given in a share of the time. */
    void keep(double share) {
        for (int k = 0; k < count && share < 1; k++) {
            impulse[k] -= (1 - share) * lasting[k];
            lasting[k] *= share;
        }
    }

    private void grow() {
        int room = 2 * count;
        body = Arrays.copyOf(body, room);
        other = Arrays.copyOf(other, room);
        object = Arrays.copyOf(object, room);
        piece = Arrays.copyOf(piece, room);
        point = Arrays.copyOf(point, 3 * room);
        normal = Arrays.copyOf(normal, 3 * room);
        apart = Arrays.copyOf(apart, room);
        impulse = Arrays.copyOf(impulse, room);
        lasting = Arrays.copyOf(lasting, room);
    }

    /** Moves a contact to another place. */
    void copy(int from, int to) {
        if (from == to) {
            return;
        }
        body[to] = body[from];
        other[to] = other[from];
        object[to] = object[from];
        piece[to] = piece[from];
        System.arraycopy(point, 3 * from, point, 3 * to, 3);
        System.arraycopy(normal, 3 * from, normal, 3 * to, 3);
        apart[to] = apart[from];
        impulse[to] = impulse[from];
        lasting[to] = lasting[from];
    }
}
