package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

class ObjWriterTest {
    @TempDir
    Path folder;

    private MeshObject written(GeometryObject... objects) throws IOException {
        List<WorldObject> all = new ArrayList<>();
        for (GeometryObject object : objects) {
            all.add(new WorldObject(object));
        }
        Path file = folder.resolve("w.obj");
        WorldWriter.writeObj(new World(100, 100, 100, all), file, done -> {});
        return WorldReader.readMesh(file);
    }

    /** All are closed surfaces, which look outwards, of the volume that the shape has or a little less. */
    @Test
    void shapesAreClosedAndOfTheirVolume() throws IOException {
        Point at = new Point(3, -4, 5);
        MeshObject box = written(new BoxObject(at, 2, 3, 4).turned(20, 30));
        assertThat(box.solid().isSolid()).isTrue();
        assertThat(ObjReaderTest.volume(box)).isCloseTo(24, within(1e-12));
        double sides = ObjWriter.SIDES;
        MeshObject cylinder = written(new CylinderObject(at, 2, 3).turned(50, 10));
        assertThat(cylinder.solid().isSolid()).isTrue();
        assertThat(ObjReaderTest.volume(cylinder))
                .isCloseTo(3 * 4 * sides / 2 * StrictMath.sin(2 * Math.PI / sides), within(1e-12));
        MeshObject ball = written(new SphereObject(at, 2).turned(50, 10));
        assertThat(ball.solid().isSolid()).isTrue();
        MeshObject capsule = written(new CapsuleObject(at, 2, 3).turned(50, 10));
        assertThat(capsule.solid().isSolid()).isTrue();
        double full = (32.0 / 3 + 3 * 4) * Math.PI;
        assertThat(ObjReaderTest.volume(capsule)).isBetween(0.99 * full, full);
        assertThat(ObjReaderTest.volume(ball)).isBetween(0.99 * 32 / 3 * Math.PI, 32.0 / 3 * Math.PI);
    }

    /** Cells side by side are one box, so that a wall has no faces inside. */
    @Test
    void cellsOfAGridAreJoinedToBoxes() throws IOException {
        // Rows ##.. and ##.#: a box of four cells and one of one.
        GridObject grid = GridObject.of(new Point(1, 2, 3), 0.5, 4, 4, 2, new byte[] {(byte) 0b1011_0011});
        MeshObject straight = written(grid);
        assertThat(straight.vertices()).hasSize(16);
        assertThat(straight.solid().isSolid()).isTrue();
        assertThat(straight.vertices()).contains(new Point(0, 0, 2.5), new Point(1, 4, 3.5), new Point(2, 4, 3.5));
        assertThat(ObjReaderTest.volume(straight)).isCloseTo(5 * 0.25 * 4, within(1e-12));
        MeshObject turned = written(grid.turned(0, 90));
        assertThat(turned.bounds()).isEqualTo(grid.turned(0, 90).bounds());
    }

    @Test
    void groupsAndMeshesStandWhereTheyAre() throws IOException {
        MeshObject wedge = new MeshObject(
                List.of(new Point(0, 0, 0), new Point(1, 0, 0), new Point(0, 1, 0), new Point(0, 0, 1)),
                new int[][] {{0, 1, 2}, {0, 2, 3}});
        MeshObject read = written(
                new ObjectGroup(List.of(wedge.movedTo(new Point(10, 0, 0))))
                        .turned(0, 90)
                        .movedTo(new Point(0, 5, 0)),
                wedge);
        assertThat(read.vertices())
                .containsExactly(
                        new Point(0, 5, -10),
                        new Point(0, 5, -11),
                        new Point(0, 6, -10),
                        new Point(1, 5, -10),
                        new Point(0, 0, 0),
                        new Point(1, 0, 0),
                        new Point(0, 1, 0),
                        new Point(0, 0, 1));
        assertThat(read.faces()).isDeepEqualTo(new int[][] {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
    }

    @Test
    void objectsHaveNamesAndProgressIsTold() throws IOException {
        List<WorldObject> all = List.of(
                new WorldObject(new SphereObject(new Point(), 1).named("a ball\nof two lines")),
                new WorldObject(new SphereObject(new Point(), 1)));
        List<Long> told = new ArrayList<>();
        Path file = folder.resolve("w.obj");
        WorldWriter.writeObj(new World(4, 4, 4, all), file, told::add);
        assertThat(told).containsExactly(0L, 1L);
        assertThat(Files.readAllLines(file))
                .startsWith("# 4 x 4 x 4, Y up")
                .contains("o a_ball_of_two_lines", "o object_2");
    }

    @Test
    void allOrNothing() throws IOException {
        Path file = Files.writeString(folder.resolve("old.obj"), "old");
        World world = new World(4, 4, 4, List.of(new WorldObject(new SphereObject(new Point(), 1))));
        assertThatThrownBy(() -> WorldWriter.writeObj(world, file, done -> {
                    throw new IllegalStateException("stopped");
                }))
                .hasMessage("stopped");
        assertThat(file).hasContent("old");
        assertThatThrownBy(() -> WorldWriter.writeObj(world, folder.resolve("no/such.obj"), done -> {}))
                .isInstanceOf(WorldException.class)
                .hasMessageStartingWith(folder.resolve("no/such.obj") + ": the file could not be written: ");
    }
}
