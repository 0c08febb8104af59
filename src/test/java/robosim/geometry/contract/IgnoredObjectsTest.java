package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Avoidance;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.RayHit;
import robosim.geometry.SenseBuffer;
import robosim.geometry.Snapshot;
import robosim.geometry.WorldQueries;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldReader;
import robosim.geometry.world.WorldWriter;

/** Queries that leave out objects by name or layer, compared with worlds in which these objects are not. */
class IgnoredObjectsTest {
    private static final int WORLDS = Effort.cases(12, 6);
    private static final Avoidance NO_GLASS = Avoidance.ignoring("glass", "crate");
    private final SplittableRandom random = new SplittableRandom(4040);

    private static boolean isLeftOut(GeometryObject object) {
        return object.layers().contains("glass") || "crate".equals(object.name());
    }

    private List<GeometryObject> objects() {
        return IntStream.range(0, 40)
                .mapToObj(k -> {
                    Point at = new Point(coordinate(), coordinate() / 8, coordinate());
                    GeometryObject object = switch (random.nextInt(4)) {
                        case 0 -> new BoxObject(at, 1.5, 2, 1);
                        case 1 -> new CylinderObject(at, 0.6, 2);
                        case 2 -> new SphereObject(at, 0.8);
                        default -> new CapsuleObject(at, 0.5, 1.5);
                    };
                    object = k == 7 ? object.named("crate") : k % 5 == 0 ? object.moveable("cart " + k) : object;
                    return switch (random.nextInt(4)) {
                        case 0 -> object.withLayers(Set.of("glass"));
                        case 1 -> object.withLayers(Set.of("people", "glass"));
                        case 2 -> object.withLayers(Set.of("people"));
                        default -> object;
                    };
                })
                .toList();
    }

    private double coordinate() {
        return random.nextDouble(-8, 8);
    }

    private static Geometry world(Dimension dimension, Accuracy accuracy, List<GeometryObject> objects) {
        Geometry world = new Geometry(30, 30, 30, dimension, accuracy);
        objects.forEach(world::addObjectUnchecked);
        world.addObjectUnchecked(new CylinderObject(new Point(0, 0, 0), 0.2, 0.5).moveable("robot"));
        return world;
    }

    private static double[] sensed(WorldQueries world, SenseOptions options, RayPattern pattern) {
        SenseBuffer buffer = new SenseBuffer();
        world.sense("robot", Pose.of(new Point(0, 0.1, 0), 0), pattern, options, buffer);
        return buffer.distances().clone();
    }

    @Tag("slow")
    @Test
    void beams() {
        int changed = 0;
        for (int k = 0; k < WORLDS; k++) {
            Dimension dimension = k % 2 == 0 ? Dimension.PLANAR : Dimension.SPATIAL;
            Accuracy accuracy = k % 3 == 0 ? Accuracy.values()[k / 3 % 5] : Accuracy.EXACT;
            List<GeometryObject> objects = objects();
            Geometry all = world(dimension, accuracy, objects);
            Geometry less = world(
                    dimension,
                    accuracy,
                    objects.stream().filter(each -> !isLeftOut(each)).toList());
            Snapshot shared = all.snapshot().withThreads(2);
            for (RayPattern pattern :
                    List.of(RayPattern.fan(0, 1, 360), RayPattern.fan(0, 45, 3), RayPattern.pinhole(24, 16, 100))) {
                for (double width : new double[] {0, 20}) {
                    SenseOptions plain = SenseOptions.range(0.1, 20).withWidth(width);
                    SenseOptions ignoring = plain.ignoring("glass", "crate");
                    double[] expected = sensed(less, plain, pattern);
                    assertThat(sensed(all, ignoring, pattern)).isEqualTo(expected);
                    assertThat(sensed(shared, ignoring, pattern)).isEqualTo(expected);
                    changed += Arrays.equals(sensed(all, plain, pattern), expected) ? 0 : 1;
                }
            }
            for (int ray = 0; ray < 50; ray++) {
                Ray from =
                        new Ray(new Point(coordinate(), 0, coordinate()), new Point(coordinate(), 0.1, coordinate()));
                RayHit hit = all.castRay(from, 20, Set.of("glass", "crate"));
                RayHit expected = less.castRay(from, 20);
                assertThat(hit == null).isEqualTo(expected == null);
                if (hit != null && expected != null) {
                    assertThat(hit).isEqualTo(expected);
                }
            }
        }
        assertThat(changed).isGreaterThan(WORLDS);
    }

    @Test
    void movesAndBatches() {
        int free = 0;
        int changed = 0;
        for (int k = 0; k < WORLDS; k++) {
            Dimension dimension = k % 2 == 0 ? Dimension.PLANAR : Dimension.SPATIAL;
            List<GeometryObject> objects = objects();
            Geometry all = world(dimension, Accuracy.EXACT, objects);
            Geometry less = world(
                    dimension,
                    Accuracy.EXACT,
                    objects.stream().filter(each -> !isLeftOut(each)).toList());
            double[] poses = random.doubles(400, -8, 8).toArray();
            for (int y = 1; y < poses.length; y += 4) {
                poses[y] /= 8;
            }
            long[] found = new long[2];
            long[] expected = new long[2];
            less.freePoses("robot", poses, Avoidance.ALL, expected);
            free += all.freePoses("robot", poses, NO_GLASS, found);
            assertThat(found).isEqualTo(expected);
            all.freePoses("robot", poses, Avoidance.ALL, found);
            changed += Arrays.equals(found, expected) ? 0 : 1;
            Move move = new Move(coordinate(), 0, coordinate(), 0, 40);
            assertThat(all.move("robot", move, NO_GLASS)).isEqualTo(less.move("robot", move, Avoidance.ALL));
        }
        assertThat(free).isBetween(WORLDS * 10, WORLDS * 90);
        assertThat(changed).isGreaterThan(WORLDS / 2);
    }

    @Test
    void layersFollowTheWorld() {
        Geometry world = new Geometry(20, 20, 20);
        world.addObject(new BoxObject(new Point(3, 0, 0), 1, 1, 1).named("pane").withLayers(Set.of("glass")));
        world.addObject(new BoxObject(new Point(6, 0, 0), 1, 1, 1).named("wall"));
        Ray ray = new Ray(new Point(0, 0, 0), new Point(1, 0, 0));
        assertThat(world.castRay(ray, 20, Set.of("glass")).distance()).isEqualTo(5.5);
        world.addObject(
                new BoxObject(new Point(4.5, 0, 0), 1, 1, 1).named("more").withLayers(Set.of("glass")));
        assertThat(world.castRay(ray, 20, Set.of("glass")).distance()).isEqualTo(5.5);
        world.addObject(new SphereObject(new Point(1, 0, 0), 0.25).named("glass"));
        assertThat(world.castRay(ray, 20, Set.of("glass")).distance())
                .as("an object comes first")
                .isEqualTo(2.5);
        assertThat(world.castRay(ray, 20).distance()).as("all count again").isEqualTo(0.75);
        world.removeObject("glass");
        world.removeObject("pane");
        world.removeObject("more");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> world.castRay(ray, 20, Set.of("glass")))
                .withMessage("ignored must name an object or a layer in the world (got: \"glass\")");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> sensed(world, SenseOptions.range(0, 1).ignoring("fog"), RayPattern.fan(0, 1, 4)));
        assertThat(world.castRay(ray, 20).distance()).isEqualTo(5.5);
    }

    @Test
    void layersAreKept() throws IOException, ClassNotFoundException {
        GeometryObject pane =
                new BoxObject(new Point(3, 0, 0), 1, 1, 1).moveable("pane").withLayers(Set.of("glass", "tall"));
        assertThat(pane.turned(0, 30).movedTo(new Point(1, 2, 3)).layers()).isEqualTo(Set.of("glass", "tall"));
        assertThat(pane).isNotEqualTo(pane.withLayers(Set.of())).isNotEqualTo(pane.withLayers(Set.of("tall")));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(pane);
        }
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            assertThat(in.readObject()).isEqualTo(pane);
        }
        String xml = "<world xmlns=\"" + WorldWriter.NAMESPACE + "\" width=\"10\" height=\"10\" length=\"10\">"
                + "<box name=\"a\" layers=\"glass tall\" width=\"1\" height=\"1\" length=\"1\"/></world>";
        World read = WorldReader.read(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "a.xml", null);
        assertThat(read.objects().get(0).object().layers()).isEqualTo(Set.of("glass", "tall"));
        assertThat(WorldWriter.toXml(read)).contains("layers=\"glass tall\"");
        assertThatIllegalArgumentException().isThrownBy(() -> pane.withLayers(Set.of("two words")));
        assertThatIllegalArgumentException().isThrownBy(() -> pane.withLayers(Set.of(" ")));
    }
}
