package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.RayHit;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SenseBuffer.Extra;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;

/** Which part of a group, which triangle of a mesh and which cell of a grid a ray meets, against each of them alone. */
@Tag("slow")
class PartsTest {
    private final SplittableRandom random = new SplittableRandom(61);
    private final SenseBuffer out = new SenseBuffer(Extra.OBJECTS, Extra.PARTS);

    private static double alone(Dimension dimension, GeometryObject part, Ray ray) {
        Geometry world = new Geometry(1000, 1000, 1000, dimension, Accuracy.EXACT);
        assertThat(world.addObjectUnchecked(part)).isTrue();
        RayHit hit = world.castRay(ray, Double.POSITIVE_INFINITY);
        return hit == null ? Double.POSITIVE_INFINITY : hit.distance();
    }

    private GeometryObject solid() {
        Point at = new Point(random.nextInt(-4, 5), random.nextInt(-2, 3), random.nextInt(-4, 5));
        return random.nextBoolean() ? new BoxObject(at, 2, 2, 2) : new SphereObject(at, 1);
    }

    /** Members on a grid, some twice, in groups in groups. */
    private ObjectGroup group(int depth) {
        List<GeometryObject> members = new ArrayList<>();
        for (int k = 0; k < 5; k++) {
            members.add(
                    depth > 0 && k == 2
                            ? group(depth - 1).movedTo(new Point(random.nextInt(-3, 4), 0, 1))
                            : k > 2 && random.nextInt(3) == 0 ? members.get(0) : solid());
        }
        return new ObjectGroup(members);
    }

    @ParameterizedTest
    @EnumSource
    void partsOfGroups(Dimension dimension) {
        int hits = 0;
        int ties = 0;
        int later = 0;
        for (int round = 0; round < Effort.cases(30, 10); round++) {
            ObjectGroup group = group(round % 3);
            Geometry world = new Geometry(1000, 1000, 1000, dimension, Accuracy.EXACT);
            boolean moves = round % 2 == 0;
            Point center = new Point(20, 0, random.nextInt(-2, 3));
            assertThat(world.addObject(moves ? group.movedTo(center).moveable("group") : group.movedTo(center)))
                    .isTrue();
            RayPattern pattern = dimension == Dimension.PLANAR || round % 5 == 0
                    ? RayPattern.fan(-20, 0.25, 160)
                    : RayPattern.pinhole(15, 11, 40);
            Pose pose = Pose.of(new Point(0, random.nextInt(-1, 2), 0), 0);
            world.sense(pose, pattern, SenseOptions.range(0, 100), out);
            List<GeometryObject> parts = group.parts();
            for (int beam = 0; beam < pattern.size(); beam++) {
                double nearest = Double.POSITIVE_INFINITY;
                int first = -1;
                for (int k = 0; k < parts.size(); k++) {
                    Pose inGroup = parts.get(k).pose();
                    double found = alone(
                            dimension,
                            parts.get(k).at(inGroup.within(Pose.of(center, 0))),
                            TogetherTest.beam(pose, pattern, beam));
                    ties += found == nearest && first >= 0 ? 1 : 0;
                    if (found < nearest) {
                        nearest = found;
                        first = k;
                    }
                }
                assertThat(out.distance(beam)).isEqualTo(nearest);
                assertThat(out.part(beam)).as("beam %d of %s", beam, parts).isEqualTo(first);
                assertThat(out.face(beam)).isEqualTo(-1);
                hits += first >= 0 ? 1 : 0;
                later += first > 0 ? 1 : 0;
            }
        }
        assertThat(hits).isGreaterThan(Effort.cases(500, 160));
        assertThat(later).isGreaterThan(hits / 4);
        assertThat(ties).isGreaterThan(hits / 50);
    }

    @ParameterizedTest
    @EnumSource
    void trianglesOfMeshes(Dimension dimension) {
        RandomObjects objects = new RandomObjects(random, 1);
        int met = 0;
        for (int round = 0; round < Effort.cases(40, 12); round++) {
            Pose at = Pose.of(new Point(6, 0, 0), objects.heading()).turned(round % 2 * 30, 0);
            List<Point> corners = new ArrayList<>();
            int[][] faces = new int[12][];
            for (int k = 0; k < 36; k++) {
                corners.add(new Point(
                        random.nextInt(-4, 5) / 2.0, random.nextInt(-4, 5) / 2.0, random.nextInt(-4, 5) / 2.0));
            }
            for (int k = 0; k < 12; k++) {
                faces[k] = new int[] {3 * k, 3 * k + 1, 3 * k + 2};
            }
            MeshObject mesh = new MeshObject(corners, faces);
            ObjectGroup group = new ObjectGroup(List.of(new SphereObject(new Point(0, 50, 0), 0.5), mesh));
            boolean inGroup = round % 3 == 0 && dimension == Dimension.SPATIAL;
            Geometry world = new Geometry(1000, 1000, 1000, dimension, Accuracy.EXACT);
            world.addObject(inGroup ? group.at(at) : mesh.at(at));
            RayPattern pattern =
                    dimension == Dimension.PLANAR ? RayPattern.fan(-20, 0.5, 80) : RayPattern.pinhole(9, 9, 30);
            world.sense(Pose.of(new Point(), 0), pattern, SenseOptions.range(0, 100), out);
            for (int beam = 0; beam < pattern.size(); beam++) {
                if (out.object(beam) == null) {
                    assertThat(out.face(beam)).isEqualTo(-1);
                    assertThat(out.part(beam)).isEqualTo(-1);
                    continue;
                }
                met++;
                assertThat(out.part(beam)).isEqualTo(inGroup ? 1 : 0);
                int first = -1;
                for (int k = 11; k >= 0; k--) {
                    MeshObject triangle = new MeshObject(corners.subList(3 * k, 3 * k + 3), new int[][] {{0, 1, 2}});
                    GeometryObject one = inGroup ? new ObjectGroup(List.of(triangle)).at(at) : triangle.at(at);
                    if (alone(dimension, one, TogetherTest.beam(Pose.ORIGIN, pattern, beam)) == out.distance(beam)) {
                        first = k;
                    }
                }
                assertThat(out.face(beam)).isEqualTo(first);
            }
        }
        assertThat(met).isGreaterThan(Effort.cases(500, 150));
    }

    @ParameterizedTest
    @EnumSource
    void cellsOfGrids(Dimension dimension) {
        BitSet occupied = new BitSet();
        for (int k = 0; k < 400; k++) {
            occupied.set(k, random.nextInt(4) == 0);
        }
        occupied.set(0);
        GridObject grid = new GridObject(new Point(), 0.5, 1, 20, 20, occupied);
        Geometry world = new Geometry(100, 100, 100, dimension, Accuracy.EXACT);
        world.addObject(grid);
        RayPattern fan = RayPattern.fan(0, 1, 360);
        int met = 0;
        int rounds = Effort.cases(10, 4);
        for (int round = 0; round < rounds; round++) {
            Pose pose = Pose.of(new Point(random.nextInt(-8, 9), 0, random.nextInt(-8, 9)), 0);
            world.sense(pose, fan, SenseOptions.range(0, 100), out);
            for (int beam = 0; beam < fan.size(); beam++) {
                int first = -1;
                for (int cell = 399; cell >= 0 && out.object(beam) != null; cell--) {
                    if (occupied.get(cell)
                            && alone(dimension, grid.box(cell % 20, cell / 20), TogetherTest.beam(pose, fan, beam))
                                    == out.distance(beam)) {
                        first = cell;
                    }
                }
                assertThat(out.face(beam)).isEqualTo(first);
                assertThat(out.part(beam)).isEqualTo(first < 0 ? -1 : 0);
                met += first < 0 ? 0 : 1;
            }
        }
        assertThat(met).isGreaterThan(200 * rounds);
    }

    @Test
    void whereOneEnclosureStandsForAGroup() {
        Geometry world = new Geometry(100, 100, 100, Dimension.SPATIAL, Accuracy.OBB);
        world.addObject(new ObjectGroup(
                        List.of(new BoxObject(new Point(), 1, 1, 1), new BoxObject(new Point(3, 0, 0), 1, 1, 1)))
                .movedTo(new Point(10, 0, 0)));
        world.addObject(new SphereObject(new Point(-10, 0, 0), 1));
        world.sense(Pose.ORIGIN, RayPattern.fan(0, 90, 3), SenseOptions.range(0, 100), out);
        assertThat(out.part(0)).isEqualTo(-1);
        assertThat(out.part(1)).isEqualTo(-1);
        assertThat(out.object(0)).isNotNull();
        assertThat(out.part(2)).isEqualTo(0);
    }

    @Test
    void insideASolidMesh() {
        int[][] quads = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
        List<Point> corners = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            corners.add(new Point((k & 1) * 2 - 1, (k >> 1 & 1) * 2 - 1, (k >> 2) * 2 - 1));
        }
        Geometry world = new Geometry(100, 100, 100);
        world.addObject(new MeshObject(corners, quads).solid());
        world.sense(Pose.ORIGIN, RayPattern.fan(0, 90, 3), SenseOptions.range(0, 100), out);
        assertThat(out.distance(0)).isEqualTo(0);
        assertThat(out.part(0)).isEqualTo(0);
        assertThat(out.face(0)).isEqualTo(-1);
    }

    @Test
    void refusals() {
        Geometry world = new Geometry(100, 100, 100);
        RayPattern fan = RayPattern.fan(0, 90, 3);
        assertThatThrownBy(() ->
                        world.sense(Pose.ORIGIN, fan, SenseOptions.range(0, 100).withWidth(5), out))
                .hasMessage("width must be 0 for a buffer with parts, which cones have not (got: 5.0)");
        SenseBuffer plain = new SenseBuffer();
        world.sense(Pose.ORIGIN, fan, SenseOptions.range(0, 100), plain);
        assertThatThrownBy(() -> plain.part(0))
                .hasMessage("the buffer must have been made for PARTS, as by new SenseBuffer(Extra.PARTS) (got: none)");
        assertThatThrownBy(() -> plain.face(0)).hasMessageContaining("PARTS");
    }
}
