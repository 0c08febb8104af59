package robosim.geometry.bench.dynamics;
import java.util.*;
import robosim.geometry.*;
import robosim.geometry.dynamics.*;
import robosim.geometry.model.*;
public final class Tmp {
    public static void main(String[] args) {
        SplittableRandom random = new SplittableRandom(3);
        for (int run = 0; run < 8; run++) {
        Geometry world = new Geometry(4000, 5, 4000, Dimension.PLANAR, Accuracy.EXACT);
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        for (int k = 0; k < 12; k++) {
            GeometryObject disc = new CylinderObject(new Point(random.nextDouble(-5, 5), 0, random.nextDouble(-5, 5)), 0.6, 1).moveable("d" + k);
            if (world.addObject(disc)) {
                Body b = Body.ofMass(disc, random.nextDouble(0.5, 4)).withSurface(new Surface(1, 0.4, 0.3));
                dynamics.add("d" + k, b);
                Point c = disc.center();
                dynamics.setVelocity("d" + k, new Twist(-c.x(), 0, -c.z(), random.nextDouble(-90, 90)));
            }
        }
        for (int step = 0; step < 60; step++) {
            StepResult r = dynamics.step(0.05);
            if (!r.stopped().isEmpty()) { System.out.println(step + " " + r); break; }
        }
    }}
}
