package robosim.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;

/** Objects that are attached to others move as one group does, and come off where they are. */
class AttachTest {
    private static Geometry world(Dimension dimension) {
        Geometry world = new Geometry(20, 10, 20, dimension, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(-2, 0, 0), 2, 1, 1).moveable("truck"));
        world.addObject(new CylinderObject(new Point(-0.5, 0, 0.1), 0.4, 1).moveable("barrel"));
        world.addObject(new SphereObject(new Point(0.7, 0, -0.2), 0.3).moveable("ball"));
        world.addObject(new BoxObject(new Point(5, 0, 0), 1, 4, 6).named("wall"));
        return world;
    }

    @Test
    void aLoadMovesWithItsCarrierAndComesOffWhereItIs() {
        Geometry world = world(Dimension.SPATIAL);
        world.attach("truck", "barrel");
        assertThat(world.carrierOf("barrel")).isEqualTo("truck");
        assertThat(world.carrierOf("truck")).isNull();
        assertThat(world.simpleTurn("truck", 90)).isTrue();
        assertThat(world.getObject("barrel").center()).isEqualTo(new Point(-1.9, 0, -1.5));
        assertThat(world.simpleMove("truck", 1, 0, 0)).isTrue();
        assertThat(world.getObject("barrel").center()).isEqualTo(new Point(-1.9, 0, -2.5));
        assertThat(world.hasObject("barrel")).isTrue();
        assertThat(world.objects()).hasSize(3);
        world.detach("barrel");
        assertThat(world.objects()).hasSize(4);
        assertThat(world.getObject("barrel")).isInstanceOf(CylinderObject.class);
        assertThat(world.getObject("truck"))
                .isEqualTo(new BoxObject(new Point(-2, 0, -1), 2, 1, 1)
                        .moveable("truck")
                        .turned(0, 90));
        assertThat(world.simpleMove("truck", -1, 0, 0)).isTrue();
        assertThat(world.getObject("barrel").center()).isEqualTo(new Point(-1.9, 0, -2.5));
        assertThat(world.carrierOf("barrel")).isNull();
    }

    @Test
    void aLoadIsSweptAgainstAllElseAndSeenByOthersAlone() {
        Geometry world = world(Dimension.PLANAR);
        assertThat(world.getSonarDistance("truck", 1, 0, 0, 10, 0)).isLessThan(1.2);
        world.attach("truck", "barrel");
        world.attach("barrel", "ball");
        assertThat(world.getSonarDistance("truck", 1, 0, 0, 10, 0)).isEqualTo(6.5);
        MoveResult result = world.move("truck", new Move(8, 0, 0, 0, 0));
        assertThat(result.allowed()).isFalse();
        assertThat(result.fraction()).isEqualTo(3.5 / 8, within(1e-9));
        assertThat(world.castRay(new robosim.geometry.model.Ray(new Point(0.7, 0, 5), new Point(0, 0, -1)), 10)
                        .object()
                        .name())
                .isEqualTo("truck");
        assertThatThrownBy(() -> world.simpleMove("ball", 1, 0, 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("attached to \"truck\"");
    }

    @Test
    void aGivenPoseIsChecked() {
        Geometry world = world(Dimension.SPATIAL);
        assertThat(world.attach("truck", "ball", Pose.of(new Point(2.8, 0, 4), 0)))
                .isTrue();
        near(world.getObject("ball").center(), new Point(0.8, 0, 4));
        List<GeometryObject> before = world.objects();
        assertThat(world.attach("truck", "barrel", Pose.of(new Point(7, 0, 0), 0)))
                .isFalse(); // the wall
        assertThat(world.attach("truck", "barrel", Pose.of(new Point(-7.9, 0, 0), 0)))
                .isFalse(); // the border
        assertThat(world.objects()).isEqualTo(before);
        assertThat(world.attach("truck", "barrel", Pose.of(new Point(0, 0, 0), 30)))
                .isTrue(); // inside its carrier
    }

    @Test
    void whatCannotBeAttachedIsRefusedAndNothingChanges() {
        Geometry world = world(Dimension.SPATIAL);
        world.attach("truck", "barrel");
        List<GeometryObject> before = world.objects();
        for (Runnable each : List.<Runnable>of(
                () -> world.attach("truck", "truck"),
                () -> world.attach("barrel", "truck"),
                () -> world.attach("truck", "barrel"),
                () -> world.attach("ball", "barrel"),
                () -> world.attach("truck", "wall"),
                () -> world.attach("wall", "ball"),
                () -> world.attach("truck", "nobody"),
                () -> world.attach("nobody", "ball"),
                () -> world.detach("ball"),
                () -> world.detach("nobody"),
                () -> world.addObject(new SphereObject(new Point(8, 0, 8), 0.1).named("barrel")),
                () -> world.addObject(new ObjectGroup(List.of(
                                new SphereObject(new Point(), 0.1).moveable("x"),
                                new SphereObject(new Point(1, 0, 0), 0.1).moveable("ball")))
                        .moveable("x")
                        .movedTo(new Point(8, 0, 8))))) {
            assertThatThrownBy(each::run).isInstanceOf(IllegalArgumentException.class);
            assertThat(world.objects()).isEqualTo(before);
        }
    }

    @Test
    void removingTheCarrierOrTheLoadDetaches() {
        Geometry world = world(Dimension.SPATIAL);
        world.attach("barrel", "ball");
        world.attach("truck", "barrel");
        assertThat(world.removeObject("barrel")).isTrue();
        assertThat(world.hasObject("barrel")).isFalse();
        assertThat(world.carrierOf("ball")).isNull();
        assertThat(world.objects()).hasSize(3);
        world.attach("truck", "ball");
        assertThat(world.removeObject("truck")).isTrue();
        near(world.getObject("ball").center(), new Point(0.7, 0, -0.2));
        assertThat(world.objects()).hasSize(2);
    }

    /** Random attaching, moving and detaching, beside the same moves of a group of the same shapes. */
    @Test
    void movesAreThoseOfAGroup() {
        SplittableRandom random = new SplittableRandom(41);
        int refused = 0;
        int made = 0;
        for (int round = 0; round < 60; round++) {
            Dimension dimension = round % 2 == 0 ? Dimension.PLANAR : Dimension.SPATIAL;
            Geometry world = world(dimension);
            boolean isChain = random.nextBoolean();
            world.attach("truck", "barrel");
            world.attach(isChain ? "barrel" : "truck", "ball");
            Geometry other = new Geometry(20, 10, 20, dimension, Accuracy.EXACT);
            Pose truck = world.getObject("truck").pose();
            other.addObject(new ObjectGroup(List.of(
                            new BoxObject(new Point(), 2, 1, 1),
                            new CylinderObject(new Point(1.5, 0, 0.1), 0.4, 1),
                            new SphereObject(new Point(2.7, 0, -0.2), 0.3)))
                    .moveable("truck")
                    .at(truck));
            other.addObject(new BoxObject(new Point(5, 0, 0), 1, 4, 6).named("wall"));
            for (int k = 0; k < 30; k++) {
                Move move =
                        new Move(random.nextDouble(-2, 2), 0, random.nextDouble(-1, 1), 0, random.nextDouble(-60, 60));
                MoveResult a = world.move("truck", move);
                MoveResult b = other.move("truck", move);
                assertThat(a.allowed()).isEqualTo(b.allowed());
                assertThat(a.fraction()).isEqualTo(b.fraction(), within(1e-9));
                assertThat(world.getSonarDistance("truck", 1, 0.3, 0, 30, 10))
                        .isEqualTo(other.getSonarDistance("truck", 1, 0.3, 0, 30, 10), within(1e-9));
                made += a.allowed() ? 1 : 0;
                refused += a.allowed() ? 0 : 1;
                if (random.nextInt(5) == 0) {
                    String load = isChain ? "barrel" : random.nextBoolean() ? "ball" : "barrel";
                    Point at = world.getObject("ball").center();
                    world.detach(load);
                    assertThat(world.getObject("ball").center()).isEqualTo(at);
                    world.attach("truck", load);
                    near(world.getObject("ball").center(), at);
                }
            }
            near(world.getObject("truck").center(), other.getObject("truck").center());
        }
        assertThat(made).isGreaterThan(400);
        assertThat(refused).isGreaterThan(50);
    }

    private static void near(Point a, Point b) {
        assertThat(Math.abs(a.x() - b.x()) + Math.abs(a.y() - b.y()) + Math.abs(a.z() - b.z()))
                .isLessThan(1e-11);
    }

    @Test
    void whatIsTakenBackIsAsBefore() {
        Geometry world = world(Dimension.SPATIAL);
        world.attach("truck", "barrel");
        List<GeometryObject> before = world.objects();
        assertThatThrownBy(() -> world.together("a try", () -> {
                    world.simpleMove("truck", 0.2, 0, 0);
                    world.attach("barrel", "ball");
                    world.simpleTurn("truck", 10);
                    world.detach("barrel");
                    world.removeObject("truck");
                    throw new IllegalStateException("no");
                }))
                .hasMessage("no");
        assertThat(world.objects()).isEqualTo(before);
        assertThat(world.carrierOf("barrel")).isEqualTo("truck");
        assertThat(world.carrierOf("ball")).isNull();
        world.detach("barrel");
        assertThat(world.objects()).hasSize(4);
    }

    @Test
    void copiesOfAWorldKnowWhatIsAttached() throws Exception {
        Geometry world = world(Dimension.SPATIAL);
        world.attach("truck", "barrel");
        world.simpleTurn("truck", 33);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(world.snapshot());
        }
        Snapshot read = (Snapshot) new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())).readObject();
        for (Geometry copy : List.of(world.snapshot().toGeometry(), read.toGeometry())) {
            assertThat(copy.carrierOf("barrel")).isEqualTo("truck");
            assertThat(copy.getObject("barrel")).isEqualTo(world.getObject("barrel"));
            copy.detach("barrel");
            assertThat(copy.simpleMove("truck", -1, 0, 0)).isTrue();
        }
    }
}
