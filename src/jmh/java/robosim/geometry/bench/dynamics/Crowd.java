package robosim.geometry.bench.dynamics;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dyn4j.collision.AxisAlignedBounds;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;

/**
 * Steps a second of {@link Arena}, here and by dyn4j at its defaults (without gravity), alternating in one JVM; and how often
 * two bodies overlap after a step here. {@code -Dbodies=1000 -Dsteps=500 -Drounds=5}.
 */
public final class Crowd {
    private Crowd() {}

    /** Runs both and prints a line for each round. */
    public static void main(String[] args) {
        int bodies = Integer.getInteger("bodies", 1000);
        int steps = Integer.getInteger("steps", 500);
        int rounds = Integer.getInteger("rounds", 5);
        boolean isAlone = Boolean.getBoolean("alone");
        for (int round = 0; round < rounds; round++) {
            double own = steps / own(bodies, steps);
            double other = isAlone ? Double.NaN : steps / dyn4j(bodies, steps);
            System.out.printf(
                    Locale.ROOT,
                    "%d bodies: %.0f steps/s, dyn4j %.0f steps/s, ratio %.2f; stopped %d, overlaps %d%n",
                    bodies,
                    own,
                    other,
                    own / other,
                    stopped,
                    overlaps);
        }
    }

    private static int stopped;
    private static int overlaps;

    private static double own(int count, int steps) {
        Arena arena = new Arena(count, 1);
        robosim.geometry.Geometry world = arena.world();
        Dynamics dynamics = arena.dynamics(world);
        stopped = 0;
        long nanos = 0;
        for (int step = 0; step < steps; step++) {
            if (step % Arena.STIRRED == 0) {
                arena.stir(world, dynamics, arena.stirring());
            }
            long start = System.nanoTime();
            dynamics.advance(Arena.STEP);
            nanos += System.nanoTime() - start;
            stopped += dynamics.last().stopped().size();
        }
        List<GeometryObject> all = world.objects();
        overlaps = 0;
        for (int i = 0; i < all.size(); i++) {
            for (int j = 0; j < i; j++) {
                overlaps += all.get(i).isMoveable() && CollisionDetection.intersects(all.get(i), all.get(j)) ? 1 : 0;
            }
        }
        return nanos * 1e-9;
    }

    /** A body of dyn4j, whose y is minus z. */
    public static Body body(GeometryObject object) {
        Body body = new Body();
        Convex shape = object instanceof CylinderObject disc
                ? Geometry.createCircle(disc.radius())
                : Geometry.createRectangle(((BoxObject) object).width(), ((BoxObject) object).length());
        BodyFixture fixture = body.addFixture(shape);
        fixture.setDensity(Arena.DENSITY);
        fixture.setFriction(Arena.FRICTION);
        fixture.setRestitution(Arena.RESTITUTION);
        body.setMass(object.isMoveable() ? MassType.NORMAL : MassType.INFINITE);
        body.rotate(Math.toRadians(object.heading()));
        body.translate(object.center().x(), -object.center().z());
        return body;
    }

    private static double dyn4j(int count, int steps) {
        Arena arena = new Arena(count, 1);
        World<Body> world = new World<>();
        world.setGravity(World.ZERO_GRAVITY);
        world.setBounds(new AxisAlignedBounds(4 * arena.half, 4 * arena.half));
        arena.walls().forEach(wall -> world.addBody(body(wall)));
        List<Body> bodies = new ArrayList<>();
        for (GeometryObject object : arena.bodies) {
            Body body = body(object);
            bodies.add(body);
            world.addBody(body);
        }
        long nanos = 0;
        for (int step = 0; step < steps; step++) {
            if (step % Arena.STIRRED == 0) {
                double[] v = arena.stirring();
                for (int k = 0; k < count; k++) {
                    bodies.get(k).setAtRest(false);
                    bodies.get(k).setLinearVelocity(new Vector2(v[3 * k], -v[3 * k + 1]));
                    bodies.get(k).setAngularVelocity(v[3 * k + 2]);
                }
            }
            long start = System.nanoTime();
            world.step(1, Arena.STEP);
            nanos += System.nanoTime() - start;
        }
        return nanos * 1e-9;
    }
}
