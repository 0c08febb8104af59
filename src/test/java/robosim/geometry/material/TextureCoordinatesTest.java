package robosim.geometry.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

class TextureCoordinatesTest {
    private static final double[] POINTS = {0, 0, 1, 0, 1, 1, 0, 1, -3.5, 0.25};

    /** A quad and two triangles. */
    private static MeshObject mesh() {
        return new MeshObject(
                List.of(new Point(), new Point(1, 0, 0), new Point(1, 1, 0), new Point(0, 1, 0), new Point(0, 0, 5)),
                new int[][] {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}});
    }

    private static MeshObject textured() {
        return mesh().withTextureCoordinates(new TextureCoordinates(POINTS, new int[] {0, 1, 2, 3, 4, 1, 2, 1, -1, 2}));
    }

    @Test
    void eachTriangleHasThePointsOfItsCorners() {
        TriangleMesh triangles = textured().triangles();
        double[][][] expected = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}, {{-3.5, 0.25}, {1, 0}, {1, 1}}};
        for (int t = 0; t < 3; t++) {
            assertThat(triangles.isTextured(t)).isTrue();
            for (int corner = 0; corner < 3; corner++) {
                assertThat(triangles.textured(t, corner, 0)).isEqualTo(expected[t][corner][0]);
                assertThat(triangles.textured(t, corner, 1)).isEqualTo(expected[t][corner][1]);
            }
        }
        assertThat(triangles.isTextured(3)).as("one corner has no point").isFalse();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> triangles.textured(3, 0, 0))
                .withMessageEndingWith("(got: 3)");
        assertThat(mesh().triangles().isTextured(0)).isFalse();
        assertThat(mesh().textureCoordinates()).isNull();
    }

    @Test
    void aTexturedMeshIsAValueOfTheSameShape() throws Exception {
        MeshObject textured = textured().named("a").withMaterial(Material.of(Color.BLACK));
        assertThat(textured).isNotEqualTo(mesh().named("a").withMaterial(Material.of(Color.BLACK)));
        assertThat(textured.withTextureCoordinates(null).withMaterial(Material.DEFAULT))
                .isEqualTo(mesh().named("a"));
        assertThat(textured.withTextureCoordinates(textured.textureCoordinates())
                        .triangles())
                .as("equal coordinates keep the triangles and their trees")
                .isSameAs(textured.triangles());
        assertThat(textured.movedTo(new Point(1, 2, 3)).turned(0, 30).triangles())
                .isSameAs(textured.triangles());
        assertThat(textured.vertices()).isEqualTo(mesh().vertices());
        assertThat(textured.faces()).isDeepEqualTo(mesh().faces());
        for (MeshObject each : List.of(textured(), textured)) {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
                out.writeObject(each);
            }
            try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
                assertThat(in.readObject()).isEqualTo(each).hasSameHashCodeAs(each);
            }
        }
    }

    @Test
    void theArraysGivenAreCopied() {
        double[] points = POINTS.clone();
        int[] corners = {0, 1, 2};
        TextureCoordinates coordinates = new TextureCoordinates(points, corners);
        points[0] = 9;
        corners[0] = 3;
        coordinates.points()[0] = 9;
        coordinates.corners()[0] = 3;
        assertThat(coordinates).isEqualTo(new TextureCoordinates(POINTS, new int[] {0, 1, 2}));
        assertThat(coordinates).isNotEqualTo(new TextureCoordinates(POINTS, new int[] {0, 1, 3}));
        assertThat(coordinates).isNotEqualTo(new TextureCoordinates(new double[6], new int[] {0, 1, 2}));
    }

    @Test
    void whatDoesNotFitIsRefused() {
        refused("points must have two numbers each (got: 3 numbers)", new double[3]);
        refused("points[1].v must be", 0, 0, 0, Double.NaN);
        refused("points[0].u must be", Double.POSITIVE_INFINITY, 0);
        refused("corners[1] must be -1 or one of the 5 points, counted from 0 (got: 5)", POINTS, 0, 5);
        refused("corners[0] must be -1 or one of the 5 points, counted from 0 (got: -2)", POINTS, -2);
        for (int[] corners : List.of(new int[0], new int[9], new int[11])) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> mesh().withTextureCoordinates(new TextureCoordinates(POINTS, corners)))
                    .withMessage("corners must have one index for each corner of the 3 faces, 10 (got: "
                            + corners.length + ")");
        }
    }

    private static void refused(String message, double... points) {
        refused(message, points, new int[0]);
    }

    private static void refused(String message, double[] points, int... corners) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new TextureCoordinates(points, corners))
                .withMessageStartingWith(message);
    }
}
