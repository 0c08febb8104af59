package robosim.geometry.viewer.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;

/** What covers what in a plan, and which edges of meshes it shows. */
class LayersTest {
    /** A floor of two triangles with a wall of two triangles along its edge at z = -5, as one mesh. */
    private static MeshObject room() {
        return new MeshObject(
                List.of(
                        new Point(-5, 0, -5),
                        new Point(5, 0, -5),
                        new Point(5, 0, 5),
                        new Point(-5, 0, 5),
                        new Point(-5, 3, -5),
                        new Point(5, 3, -5),
                        new Point(-5, 3, -4),
                        new Point(5, 3, -4)),
                new int[][] {{0, 1, 2}, {0, 2, 3}, {4, 5, 7}, {4, 7, 6}});
    }

    private static List<Layers.Layer> layers(GeometryObject... objects) {
        List<Scene.Thing> things = new ArrayList<>();
        for (GeometryObject object : objects) {
            things.add(new Scene.Thing(object, null));
        }
        return Layers.fromBelow(things);
    }

    private static Set<String> lines(List<Layers.Layer> layers) {
        Set<String> lines = new HashSet<>();
        for (Layers.Layer layer : layers) {
            for (double[] line : layer.lines()) {
                String from = line[0] + "," + line[1];
                String to = line[2] + "," + line[3];
                lines.add(from.compareTo(to) < 0 ? from + " " + to : to + " " + from);
            }
        }
        return lines;
    }

    @Test
    void aTableIsAboveTheFloorOfAMeshAndBelowItsWalls() {
        BoxObject table = new BoxObject(new Point(0, 0.5, 0), 2, 1, 1);
        for (GeometryObject house : List.of(room(), new ObjectGroup(List.of(room())))) {
            List<Layers.Layer> layers = layers(house, table);
            int at = layers.stream()
                    .map(layer -> layer.thing().object())
                    .toList()
                    .indexOf(table);
            assertThat(at).isBetween(1, layers.size() - 2);
            assertThat(layers.subList(0, at)).allMatch(layer -> layer.isMesh() && layer.height() == 0);
            assertThat(layers.subList(at + 1, layers.size())).allMatch(layer -> layer.isMesh() && layer.height() == 1);
            assertThat(layers.stream()
                            .filter(Layers.Layer::isMesh)
                            .mapToInt(layer -> layer.areas().size())
                            .sum())
                    .isEqualTo(4);
        }
    }

    @Test
    void noDiagonalOfAFlatFaceIsDrawn() {
        assertThat(lines(layers(room())))
                .containsExactlyInAnyOrder(
                        "-5.0,-5.0 5.0,-5.0",
                        "5.0,-5.0 5.0,5.0",
                        "-5.0,5.0 5.0,5.0",
                        "-5.0,-5.0 -5.0,5.0",
                        "-5.0,-4.0 -5.0,-5.0",
                        "-5.0,-4.0 5.0,-4.0",
                        "5.0,-4.0 5.0,-5.0");
    }

    /** Without shared vertices, and with each face twice in opposite senses, as exporters write thin walls. */
    @Test
    void repeatedCornersAndFacesAreOne() {
        List<Point> corners = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        int[][] sheets = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
        Point[] square = {new Point(0, 0, 0), new Point(1, 0, 0), new Point(1, 0, 1), new Point(0, 0, 1)};
        for (int[] sheet : sheets) {
            faces.add(new int[] {corners.size(), corners.size() + 1, corners.size() + 2});
            for (int corner : sheet) {
                corners.add(square[corner]);
            }
        }
        assertThat(lines(layers(new MeshObject(corners, faces.toArray(int[][]::new)))))
                .containsExactlyInAnyOrder("0.0,0.0 1.0,0.0", "1.0,0.0 1.0,1.0", "0.0,1.0 1.0,1.0", "0.0,0.0 0.0,1.0");
    }

    /** A ring of faces that bend by 10 degrees has no lines but its outline. */
    @Test
    void aSmoothSurfaceHasAnOutlineOnly() {
        int count = 36;
        List<Point> corners = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            double angle = 2 * Math.PI * (k + 0.5) / count;
            corners.add(new Point(StrictMath.cos(angle), StrictMath.sin(angle), -2));
            corners.add(new Point(StrictMath.cos(angle), StrictMath.sin(angle), 2));
            int next = 2 * ((k + 1) % count);
            faces.add(new int[] {2 * k, 2 * k + 1, next + 1, next});
        }
        Set<String> lines = lines(layers(new MeshObject(corners, faces.toArray(int[][]::new))));
        // Along the tube only its two sides: a face stands upright at each, with a line on both of its edges or at one.
        assertThat(lines.stream().filter(line -> line.contains(",-2.0") && line.contains(",2.0")))
                .hasSizeBetween(1, 4)
                .allMatch(line -> line.contains("0.99619"));
    }
}
