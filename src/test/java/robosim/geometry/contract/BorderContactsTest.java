package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** The contact with the border of the world: on the side that is reached first, where the object touches it. */
class BorderContactsTest {
    private static final double NEAR = 1e-9;

    private final SplittableRandom random = new SplittableRandom(3626);

    @Test
    void theSideReachedFirst() {
        int[] sides = new int[3];
        for (int k = 0; k < Effort.cases(4000, 1000); k++) {
            GeometryObject mover = shape(k % 6).moveable("mover");
            Geometry world = new Geometry(8, 10, 12);
            assertThat(world.addObject(mover)).isTrue();
            Point way = new Point(random.nextDouble(-40, 40), random.nextDouble(-40, 40), random.nextDouble(-40, 40));
            MoveResult result = world.moveGlobal("mover", new Move(way.x(), way.y(), way.z(), 0, 0));
            if (result.allowed()) {
                continue;
            }
            Point n = result.normal();
            int axis = n.x() != 0 ? 0 : n.y() != 0 ? 1 : 2;
            sides[axis]++;
            double along = axis == 0 ? way.x() : axis == 1 ? way.y() : way.z();
            double at = axis == 0
                    ? result.contact().x()
                    : axis == 1 ? result.contact().y() : result.contact().z();
            String what = mover + " by " + way + ": " + result;
            assertThat(result.obstacle()).as(what).isNull();
            assertThat(n.x() * way.x() + n.y() * way.y() + n.z() * way.z())
                    .as(what)
                    .isLessThan(0);
            assertThat(at).as(what).isEqualTo(Math.signum(along) * (4 + axis));
            Point there = new Point(
                    mover.center().x() + result.fraction() * way.x(),
                    mover.center().y() + result.fraction() * way.y(),
                    mover.center().z() + result.fraction() * way.z());
            assertThat(off(mover.movedTo(there), result.contact())).as(what).isLessThan(NEAR);
        }
        for (int side : sides) {
            assertThat(side).isGreaterThan(100);
        }
    }

    @Test
    void ofATurn() {
        for (int sign = -1; sign <= 1; sign += 2) {
            Geometry world = new Geometry(20, 20, 20);
            world.addObject(new BoxObject(new Point(8.5, 0, 0), 1, 1, 6).moveable("mover"));
            MoveResult result = world.move("mover", new Move(0, 0, 0, 0, sign * 60));
            assertThat(result.allowed()).isFalse();
            assertThat(result.normal()).isEqualTo(new Point(-1, 0, 0));
            assertThat(result.contact().x()).isEqualTo(10);
        }
    }

    private double size() {
        return random.nextDouble(0.3, 1.2);
    }

    private GeometryObject shape(int kind) {
        Point center = new Point(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        double rx = 45 * random.nextInt(4);
        double ry = random.nextBoolean() ? 90 * random.nextInt(4) : random.nextDouble(-180, 180);
        return switch (kind) {
            case 0 -> new BoxObject(center, size(), size(), size()).turned(rx, ry);
            case 1 -> new CylinderObject(center, size() / 2, size()).turned(rx, ry);
            case 2 -> new CapsuleObject(center, size() / 2, size()).turned(rx, ry);
            case 3 -> new SphereObject(center, size() / 2);
            case 4 ->
                RandomObjects.meshOf(new BoxObject(new Point(), size(), size(), size()))
                        .turned(rx, ry)
                        .movedTo(center);
            default ->
                new ObjectGroup(List.of(
                                new BoxObject(new Point(0.2, 0, 0), size(), size(), size()),
                                new SphereObject(new Point(-0.2, 0, 0), size() / 2)))
                        .turned(rx, ry)
                        .movedTo(center);
        };
    }

    /** How far a point is from an object. */
    private static double off(GeometryObject object, Point point) {
        Geometry world = new Geometry(40, 40, 40);
        world.addObjectUnchecked(object.named("it"));
        world.addObjectUnchecked(new SphereObject(point, 0).moveable("point"));
        return world.getProximity("point", 10);
    }
}
