package robosim.geometry.bench;

import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;

/** A {@link FlatScene} with 16 robots in it. */
@State(Scope.Thread)
public class RobotScene extends FlatScene {
    private static final int ROBOTS = 16;

    private final String[] robots = new String[ROBOTS];

    /** Adds them. */
    @Setup
    public void addRobots() {
        SplittableRandom random = new SplittableRandom(7);
        double most = geometry.width() / 2 - 5;
        for (int k = 0; k < ROBOTS; k++) {
            robots[k] = "robot " + k;
            Point place = new Point(random.nextDouble(-most, most), 0, random.nextDouble(-most, most));
            geometry.addObjectUnchecked(new CylinderObject(place, 0.3, 1).moveable(robots[k]));
        }
    }

    String robot() {
        return robots[next++ & (ROBOTS - 1)];
    }
}
