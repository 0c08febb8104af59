package robosim.geometry.dynamics.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.OmnidirectionalDrive;
import robosim.geometry.dynamics.SpatialVelocity;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/**
 * Bodies that drive, slide, roll and turn over the thresholds of doors, bumps and steps of 1 to 3 cm, and off stages: they trip,
 * tip and fall, or press against what they cannot climb, and no step stops one of them.
 */
@Tag("slow")
class OrdinaryGroundTest {
    private static final double SECONDS = 1.5;

    /** What is in the way, from x = 0.9 on. */
    enum Ground {
        SILL,
        BEVELLED_SILL,
        MESH_SILL,
        BUMP,
        TILES,
        LOW_STEP_DOWN,
        STAGE,
        MESH_STAGE
    }

    /** A prism along Z, from -2 to 2, above a polygon of x and y in order. */
    private static GeometryObject prism(double... xy) {
        int n = xy.length / 2;
        List<Point> corners = new ArrayList<>();
        int[][] faces = new int[n + 2 * (n - 2)][];
        for (int k = 0; k < 2 * n; k++) {
            corners.add(new Point(xy[2 * (k % n)], xy[2 * (k % n) + 1], k < n ? -2 : 2));
        }
        for (int k = 0; k < n; k++) {
            faces[k] = new int[] {k, (k + 1) % n, n + (k + 1) % n, n + k};
        }
        for (int k = 0; k < n - 2; k++) {
            faces[n + 2 * k] = new int[] {0, k + 1, k + 2};
            faces[n + 2 * k + 1] = new int[] {n, n + k + 2, n + k + 1};
        }
        return new MeshObject(corners, faces).solid();
    }

    /** Adds the ground; answers the height at which bodies begin. */
    private static double lay(Geometry world, Ground ground, double h) {
        world.addObject(new BoxObject(new Point(0, -0.5, 0), 19, 1, 7).named("floor"));
        GeometryObject object = switch (ground) {
            case SILL -> new BoxObject(new Point(1, h / 2, 0), 0.1, h, 4);
            case BEVELLED_SILL -> prism(0.9, 0, 0.95, h, 1.05, h, 1.1, 0);
            case MESH_SILL -> prism(0.95, 0, 0.95, h, 1.05, h, 1.05, 0);
            case BUMP -> new CylinderObject(new Point(1, h - 0.1, 0), 0.1, 4).turned(90, 0);
            case TILES -> new BoxObject(new Point(1.25, h / 4, 0), 0.5, h / 2, 4);
            case LOW_STEP_DOWN -> new BoxObject(new Point(0, h / 2, 0), 2, h, 4);
            case STAGE -> new BoxObject(new Point(0, 0.2, 0), 2, 0.4, 4);
            case MESH_STAGE -> prism(-1, 0, -1, 0.4, 1, 0.4, 1, 0);
        };
        assertThat(world.addObjectUnchecked(object.named("ground"))).isTrue();
        if (ground == Ground.TILES) {
            world.addObjectUnchecked(new BoxObject(new Point(1.75, h / 2, 0), 0.5, h, 4).named("next"));
        }
        return switch (ground) {
            case SILL, BEVELLED_SILL, MESH_SILL, BUMP, TILES -> 0;
            case LOW_STEP_DOWN -> h;
            case STAGE, MESH_STAGE -> 0.4;
        };
    }

    private static GeometryObject body(int shape, double low) {
        Point at = new Point(0.3, low + 0.15, 0);
        return switch (shape) {
            case 0 -> new BoxObject(at, 0.5, 0.3, 0.4);
            case 1 -> new CylinderObject(at, 0.25, 0.3);
            case 2 -> new SphereObject(at, 0.15);
            case 3 -> new CapsuleObject(new Point(0.3, low + 0.3, 0), 0.15, 0.3);
            default -> new CylinderObject(at, 0.15, 0.4).turned(90, 0);
        };
    }

    @ParameterizedTest
    @EnumSource(Ground.class)
    void nobodyIsStoppedOn(Ground ground) {
        SplittableRandom random = new SplittableRandom(ground.ordinal());
        int passed = 0;
        int runs = Effort.cases(16);
        for (int run = 0; run < runs; run++) {
            Geometry world = new Geometry(20, 6, 8, Dimension.SPATIAL, Accuracy.EXACT);
            double low = lay(world, ground, random.nextInt(1, 4) / 100.0) + (run % 3 == 0 ? 0 : 2e-8);
            GeometryObject body = body(run % 5, low).turned(0, random.nextInt(-6, 7) * 15);
            assertThat(world.addObjectUnchecked(body.moveable("body"))).isTrue();
            double friction = random.nextInt(4) * 0.25;
            Surface surface = new Surface(random.nextInt(3) * 0.25, friction, 0.9 * friction);
            Dynamics dynamics = new Dynamics(world, surface);
            dynamics.add("body", Body.ofMass(body, 10).withSurface(surface).withFloorFriction(friction));
            double speed = random.nextDouble(0.3, 3);
            if (friction > 0 && random.nextBoolean()) {
                double way = Math.toRadians(body.heading());
                OmnidirectionalDrive drive = new OmnidirectionalDrive(4, 3, 200, 400);
                dynamics.drive("body", drive.driving(speed * Math.cos(way), speed * Math.sin(way), 0));
            } else {
                double turn = random.nextInt(3) * 40;
                dynamics.setSpatialVelocity("body", new SpatialVelocity(speed, 0, 0, 0, turn, 0));
            }
            double step = random.nextInt(3) == 0 ? 0.05 : random.nextBoolean() ? 0.02 : 0.003;
            for (double time = 0; time < SECONDS; time += step) {
                StepResult result = dynamics.step(step);
                assertThat(result.stops())
                        .as(
                                "run %d at %.3f s, at %s",
                                run, time, world.getObject("body").center())
                        .isEmpty();
            }
            passed += world.getObject("body").center().x() > 0.5 ? 1 : 0;
        }
        assertThat(passed).as("have come that far").isGreaterThan(runs / 4);
    }

    /** A frictionless rim that trips over a sill wobbles and lands almost flat, on one point of it after the other. */
    @Test
    void aRimThatWobblesLands() {
        SplittableRandom random = new SplittableRandom(5);
        int runs = Effort.cases(24);
        for (int run = 0; run < runs; run++) {
            Geometry world = new Geometry(20, 6, 8, Dimension.SPATIAL, Accuracy.EXACT);
            lay(world, Ground.SILL, random.nextInt(1, 4) / 100.0);
            world.addObject(body(1, 2e-8).moveable("body"));
            Surface surface = new Surface(random.nextInt(1, 4) * 0.1, 0, 0);
            Dynamics dynamics = new Dynamics(world, surface);
            dynamics.add("body", Body.ofMass(world.getObject("body"), 10).withSurface(surface));
            dynamics.setSpatialVelocity(
                    "body", new SpatialVelocity(random.nextDouble(2, 3), 0, 0, 0, random.nextInt(3) * 30, 0));
            for (double time = 0; time < 1; time += 0.01) {
                assertThat(dynamics.step(0.01).stops())
                        .as("run %d at %.3f s", run, time)
                        .isEmpty();
            }
        }
    }
}
