package robosim.geometry.bench.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.collision.AxisAlignedBounds;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** An engine that steps a {@link SideScene}. */
interface SideEngine {
    void stir(double[] velocities);

    void step(double seconds);

    /** All bodies where they are. */
    List<GeometryObject> bodies();

    double energy();

    /** How many bodies could not be carried where they were to go in the last step. */
    int stopped();

    /** This module. */
    final class Own implements SideEngine {
        private final SideScene scene;
        private final Geometry world;
        private final Dynamics dynamics;

        Own(SideScene scene) {
            this.scene = scene;
            world = scene.world();
            dynamics = new Dynamics(world, scene.surface);
            scene.bodies.forEach(body -> dynamics.add(
                    body.name(), Body.ofDensity(body, Arena.DENSITY).withSurface(scene.surface)));
        }

        @Override
        public void stir(double[] v) {
            for (int k = 0; k < scene.bodies.size(); k++) {
                String name = scene.bodies.get(k).name();
                double[] r = world.getObject(name).rotation();
                dynamics.setVelocity(
                        name,
                        new Twist(
                                r[0] * v[3 * k] + r[6] * v[3 * k + 1],
                                0,
                                r[2] * v[3 * k] + r[8] * v[3 * k + 1],
                                v[3 * k + 2]));
            }
        }

        @Override
        public void step(double seconds) {
            dynamics.advance(seconds);
        }

        @Override
        public List<GeometryObject> bodies() {
            return scene.bodies.stream()
                    .map(body -> world.getObject(body.name()))
                    .toList();
        }

        @Override
        public int stopped() {
            return dynamics.last().stopped().size();
        }

        @Override
        public double energy() {
            double sum = 0;
            for (GeometryObject each : scene.bodies) {
                Body body = dynamics.body(each.name());
                Twist v = dynamics.velocity(each.name());
                double w = Math.toRadians(v.ry());
                sum += 0.5 * body.mass() * (v.x() * v.x() + v.z() * v.z()) + 0.5 * body.inertia() * w * w;
            }
            return sum;
        }
    }

    /** dyn4j at its defaults, without gravity; its y is minus z. */
    final class Dyn4j implements SideEngine {
        private final SideScene scene;
        private final World<org.dyn4j.dynamics.Body> world = new World<>();
        private final List<org.dyn4j.dynamics.Body> all = new ArrayList<>();

        Dyn4j(SideScene scene) {
            this.scene = scene;
            world.setGravity(World.ZERO_GRAVITY);
            world.setBounds(new AxisAlignedBounds(8 * scene.half, 8 * scene.half));
            scene.walls.forEach(wall -> world.addBody(body(wall)));
            for (GeometryObject object : scene.bodies) {
                org.dyn4j.dynamics.Body body = body(object);
                all.add(body);
                world.addBody(body);
            }
        }

        private org.dyn4j.dynamics.Body body(GeometryObject object) {
            org.dyn4j.dynamics.Body body = Crowd.body(object);
            BodyFixture fixture = body.getFixture(0);
            fixture.setRestitution(scene.surface.restitution());
            fixture.setFriction(scene.surface.slidingFriction());
            body.setMass(object.isMoveable() ? MassType.NORMAL : MassType.INFINITE);
            return body;
        }

        @Override
        public void stir(double[] v) {
            for (int k = 0; k < all.size(); k++) {
                all.get(k).setAtRest(false);
                all.get(k).setLinearVelocity(new Vector2(v[3 * k], -v[3 * k + 1]));
                all.get(k).setAngularVelocity(Math.toRadians(v[3 * k + 2]));
            }
        }

        @Override
        public void step(double seconds) {
            world.step(1, seconds);
        }

        @Override
        public List<GeometryObject> bodies() {
            List<GeometryObject> placed = new ArrayList<>();
            for (int k = 0; k < all.size(); k++) {
                Vector2 c = all.get(k).getWorldCenter();
                double degrees = Math.toDegrees(all.get(k).getTransform().getRotationAngle());
                GeometryObject object = scene.bodies.get(k);
                // A turn adds to the heading that it was made with.
                placed.add(object.turned(0, degrees - object.heading())
                        .movedTo(new Point(c.x, object.center().y(), -c.y)));
            }
            return placed;
        }

        @Override
        public int stopped() {
            return 0;
        }

        @Override
        public double energy() {
            double sum = 0;
            for (org.dyn4j.dynamics.Body body : all) {
                double speed = body.getLinearVelocity().getMagnitude();
                double w = body.getAngularVelocity();
                sum += 0.5 * body.getMass().getMass() * speed * speed
                        + 0.5 * body.getMass().getInertia() * w * w;
            }
            return sum;
        }
    }
}
