package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** The contact of a blocked move lies on the mover, where it may go to, and on what blocks it. */
@Tag("slow")
class ContactPointsTest {
    /** World units; objects are about 1 large. */
    private static final double NEAR = 1e-9;

    private static final int CASES = Effort.cases(12_000);

    private final SplittableRandom random = new SplittableRandom(261124);

    @Test
    void aContactInSpaceIsOnBoth() {
        int blocked = 0;
        for (int k = 0; k < CASES; k++) {
            GeometryObject obstacle = shape(k % 5, new Point(3, random.nextDouble(-1, 1), random.nextDouble(-1, 1)));
            GeometryObject mover = shape(k / 5 % 5, new Point(0, 0, 0)).moveable("mover");
            Geometry world = new Geometry(20, 20, 20);
            world.addObject(obstacle);
            world.addObject(mover);
            MoveResult move = world.moveGlobal("mover", new Move(4, 0, 0, 0, 0));
            if (!move.allowed()) {
                blocked++;
                Point to = new Point(4 * move.fraction(), 0, 0);
                String pair = mover + " to " + to + ", " + obstacle + ": " + move;
                assertThat(off(obstacle, move.contact())).as(pair).isLessThan(NEAR);
                assertThat(off(mover.movedTo(to), move.contact())).as(pair).isLessThan(NEAR);
            }
        }
        assertThat(blocked).isBetween(CASES / 2, CASES * 9 / 10);
    }

    @Test
    void aContactOfATurnIsOnBoth() {
        int blocked = 0;
        for (int k = 0; k < CASES / 4; k++) {
            Point beside = new Point(random.nextDouble(0.8, 1.6), random.nextDouble(-0.3, 0.3), 0);
            GeometryObject obstacle = shape(k % 5, beside);
            GeometryObject mover = new BoxObject(new Point(0, 0, 0), 2.4, 0.3, 0.3)
                    .turned(0, random.nextDouble(40, 140))
                    .moveable("mover");
            Geometry world = new Geometry(20, 20, 20);
            if (!world.addObject(obstacle) || !world.addObject(mover)) {
                continue;
            }
            MoveResult move = world.move("mover", new Move(0, 0, 0, 0, 180));
            if (!move.allowed()) {
                blocked++;
                String pair = mover + ", " + obstacle + ": " + move;
                // A turn may stop short of contact by 2^-30 of the mover's radius.
                assertThat(off(obstacle, move.contact())).as(pair).isLessThan(NEAR + 0x1p-29);
            }
        }
        assertThat(blocked).isGreaterThan(CASES / 16);
    }

    @Test
    void aContactInThePlaneIsOnBothProjections() {
        int blocked = 0;
        for (int k = 0; k < CASES / 4; k++) {
            GeometryObject obstacle = upright(k % 4, new Point(3, 0, random.nextDouble(-1, 1)));
            GeometryObject mover = upright(k / 4 % 4, new Point(0, 0, 0)).moveable("mover");
            Geometry world = new Geometry(20, 20, 20, Dimension.PLANAR, Accuracy.EXACT);
            world.addObject(obstacle);
            world.addObject(mover);
            MoveResult move = world.moveGlobal("mover", new Move(4, 0, 0, 0, 0));
            if (!move.allowed()) {
                blocked++;
                Point to = new Point(4 * move.fraction(), 0, 0);
                String pair = mover + " to " + to + ", " + obstacle + ": " + move;
                Point level = new Point(move.contact().x(), 0, move.contact().z());
                assertThat(off(obstacle, level)).as(pair).isLessThan(NEAR);
                assertThat(off(mover.movedTo(to), level)).as(pair).isLessThan(NEAR);
            }
        }
        assertThat(blocked).isBetween(CASES / 8, CASES * 9 / 40);
    }

    private double size() {
        return random.nextDouble(0.2, 1.2);
    }

    private GeometryObject shape(int kind, Point center) {
        double turn = random.nextInt(4) * 35;
        double heading = random.nextInt(5) == 0 ? 90 * random.nextInt(4) : random.nextDouble(-180, 180);
        return switch (kind) {
            case 0 -> new BoxObject(center, size(), size(), size()).turned(turn, heading);
            case 1 -> new CylinderObject(center, size() / 2, size()).turned(turn, heading);
            case 2 -> new CapsuleObject(center, size() / 2, size()).turned(turn, heading);
            case 3 -> new SphereObject(center, size() / 2);
            default -> cube(center).turned(turn, heading);
        };
    }

    private GeometryObject upright(int kind, Point center) {
        return switch (kind) {
            case 0 -> new BoxObject(center, size(), 1, size()).turned(0, random.nextDouble(-180, 180));
            case 1 -> new CylinderObject(center, size() / 2, 1);
            case 2 -> new CapsuleObject(center, size() / 2, 1);
            default -> new SphereObject(center, size() / 2);
        };
    }

    private static MeshObject cube(Point center) {
        return RandomObjects.meshOf(new BoxObject(new Point(0, 0, 0), 1, 1, 1)).movedTo(center);
    }

    /** How far a point is from an object, from the formulas for points in its own frame. */
    private static double off(GeometryObject object, Point point) {
        double[] r = object.rotation();
        double dx = point.x() - object.center().x();
        double dy = point.y() - object.center().y();
        double dz = point.z() - object.center().z();
        double x = r[0] * dx + r[3] * dy + r[6] * dz;
        double y = r[1] * dx + r[4] * dy + r[7] * dz;
        double z = r[2] * dx + r[5] * dy + r[8] * dz;
        return switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                yield outside(beyond(x, box.width() / 2), beyond(y, box.height() / 2), beyond(z, box.length() / 2));
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                yield outside(beyond(Math.hypot(x, z), cylinder.radius()), beyond(y, cylinder.height() / 2), 0);
            }
            case CAPSULE -> {
                CapsuleObject capsule = (CapsuleObject) object;
                yield beyond(outside(x, beyond(y, capsule.segment() / 2), z), capsule.radius());
            }
            case SPHERE -> beyond(outside(x, y, z), ((SphereObject) object).radius());
            case MESH -> outside(beyond(x, 0.5), beyond(y, 0.5), beyond(z, 0.5));
            case GROUP, GRID -> throw new AssertionError(object);
        };
    }

    private static double beyond(double coordinate, double half) {
        return Math.max(0, Math.abs(coordinate) - half);
    }

    private static double outside(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }
}
