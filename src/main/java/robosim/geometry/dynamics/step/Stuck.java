package robosim.geometry.dynamics.step;

import java.util.Arrays;
import robosim.geometry.engine.objects.ObjectTable;

/**
 * Bodies that could not move at all in the last step, what was in their way, and where they wanted to go. As long as neither has
 * moved and the wish is the same, one attempt is enough.
 */
final class Stuck {
    /** Wishes whose directions have a greater cosine are the same. */
    private static final double SAME = 0.99;

    private final ObjectTable objects;
    private int[] obstacle = new int[8];
    private double[] dx = new double[8];
    private double[] dz = new double[8];
    private double[] turn = new double[8];
    private double[] places = new double[16 * ObjectTable.PLACE];

    Stuck(ObjectTable objects) {
        this.objects = objects;
        Arrays.fill(obstacle, -1);
    }

    /** Makes room for so many bodies, none of which is stuck. */
    void forget(int bodies) {
        if (obstacle.length < bodies) {
            obstacle = new int[bodies];
            dx = new double[bodies];
            dz = new double[bodies];
            turn = new double[bodies];
            places = new double[2 * bodies * ObjectTable.PLACE];
        }
        Arrays.fill(obstacle, -1);
    }

    /** Keeps what a body wanted and who was in its way; nobody is if the border was. */
    void keep(int b, int id, int other, double wishX, double wishZ, double wishTurn) {
        obstacle[b] = other;
        if (other >= 0) {
            dx[b] = wishX;
            dz[b] = wishZ;
            turn[b] = wishTurn;
            keepPlace(id, at(b));
            keepPlace(other, at(b) + ObjectTable.PLACE);
        }
    }

    private void keepPlace(int id, int at) {
        int place = objects.place(id);
        if (place >= 0) {
            System.arraycopy(objects.places(), place, places, at, ObjectTable.PLACE);
        }
    }

    /** Whether a body that wants to go somewhere is as stuck as it was. */
    boolean isStuck(int b, int id, double wishX, double wishZ, double wishTurn) {
        if (obstacle[b] < 0) {
            return false;
        }
        double along = wishX * dx[b] + wishZ * dz[b];
        double square = (wishX * wishX + wishZ * wishZ) * (dx[b] * dx[b] + dz[b] * dz[b]);
        return along >= SAME * Math.sqrt(square)
                && wishTurn * turn[b] >= 0
                && (wishTurn == 0) == (turn[b] == 0)
                && isAt(id, at(b))
                && isAt(obstacle[b], at(b) + ObjectTable.PLACE);
    }

    private static int at(int b) {
        return 2 * b * ObjectTable.PLACE;
    }

    private boolean isAt(int id, int at) {
        int place = objects.place(id);
        return place < 0 // what is not moveable
                || Arrays.equals(
                        objects.places(), place, place + ObjectTable.PLACE, places, at, at + ObjectTable.PLACE);
    }
}
