package robosim.geometry.sweep;

import java.util.random.RandomGenerator;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;

/** A robot that goes where chance takes it and looks around; now and then it fails. */
public final class Wander implements SweepScenario {
    private static final long serialVersionUID = 1;

    /** Longer runs, for who wants to be there while they last. */
    private final int pauseMillis;

    /** As the command makes it. */
    public Wander() {
        this(0);
    }

    Wander(int pauseMillis) {
        this.pauseMillis = pauseMillis;
    }

    @Override
    public Result run(Replicate replicate) throws Exception {
        Thread.sleep(pauseMillis);
        RandomGenerator random = replicate.random();
        if (random.nextInt(40) == 0) {
            throw new IllegalStateException("a flat battery");
        }
        double step = replicate.number("step", 1);
        var world = replicate.world();
        CylinderObject body = new CylinderObject(new Point(), 0.2, 1).moveable("wanderer");
        Point start = new Point(random.nextDouble(-15, 15), 0, random.nextDouble(-10, 10));
        while (!world.addObject(body.movedTo(start))) {
            start = new Point(random.nextDouble(-15, 15), 0, random.nextDouble(-10, 10));
        }
        int refused = 0;
        double nearest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 40; k++) {
            world.simpleTurn("wanderer", 30 * random.nextGaussian());
            refused += world.simpleMove("wanderer", step * random.nextDouble(), 0, 0) ? 0 : 1;
            nearest = Math.min(nearest, world.getSonarDistance("wanderer", 1, 0, 0, 0.5, 10));
        }
        Point end = world.getObject("wanderer").center();
        double x = end.x() - start.x();
        double z = end.z() - start.z();
        return Result.of("refused", refused).and("nearest [m]", nearest).and("way [m]", Math.sqrt(x * x + z * z));
    }

    @Override
    public String name() {
        return "wander"; // whatever it pauses
    }
}
