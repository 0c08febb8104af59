package example;

import java.util.random.RandomGenerator;
import robosim.geometry.Geometry;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.sweep.Replicate;
import robosim.geometry.sweep.Result;
import robosim.geometry.sweep.SweepScenario;

/**
 * How far does a robot get that goes straight on until its sonar is nearer to something than it likes, and then turns
 * anywhere? Its parameter is that distance, {@code keep}, in world units.
 */
public final class Patrol implements SweepScenario {
    private static final long serialVersionUID = 1;
    private static final int STEPS = 300;

    @Override
    public Result run(Replicate replicate) throws Exception {
        Geometry world = replicate.world();
        RandomGenerator random = replicate.random();
        GeometryObject robot = new CylinderObject(new Point(), 0.25, 1).moveable("patrol");
        boolean isPlaced = false;
        while (!isPlaced) {
            Point start = new Point(
                    random.nextDouble(-0.45, 0.45) * world.width(), 0, random.nextDouble(-0.45, 0.45) * world.length());
            isPlaced = world.addObject(robot.movedTo(start));
        }
        double keep = replicate.number("keep", 0.5);
        double way = 0;
        int bumps = 0;
        for (int step = 0; step < STEPS; step++) {
            // A sonar of 30 degrees, blind up to 0.3 units; its reading is off by some percent.
            double seen = world.getSonarDistance("patrol", 1, 0, 0.3, 8, 30) * (1 + 0.03 * random.nextGaussian());
            if (seen - 0.25 < keep) {
                world.simpleTurn("patrol", random.nextDouble(-180, 180));
            } else if (world.simpleMove("patrol", 0.25, 0, 0)) {
                way += 0.25;
            } else {
                bumps++;
                world.simpleTurn("patrol", random.nextDouble(-180, 180));
            }
        }
        return Result.of("way [world units]", way).and("bumps", bumps);
    }
}
