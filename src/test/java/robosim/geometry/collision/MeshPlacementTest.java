package robosim.geometry.collision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.Reference;

/** A mesh's tree stands in its own frame; no triangle is lost on the way there and back. */
class MeshPlacementTest {
    /** Triangles one after the other along X, as high and as long as the unit, the last one at 1000 units. */
    private static MeshObject strip(double unit) {
        List<Point> vertices = new ArrayList<>();
        int[][] faces = new int[41][];
        for (int k = 0; k <= 40; k++) {
            vertices.add(new Point(25 * k * unit, 0, 0));
            vertices.add(new Point(25 * k * unit, unit, 0));
            vertices.add(new Point(25 * k * unit, 0, unit));
            faces[k] = new int[] {3 * k, 3 * k + 1, 3 * k + 2};
        }
        return new MeshObject(vertices, faces);
    }

    private static void touching(GeometryObject a, GeometryObject b) {
        assertThat(Reference.overlap(a, b, Dimension.SPATIAL)).isTrue();
        assertThat(CollisionDetection.intersects(a, b)).isTrue();
        assertThat(CollisionDetection.intersects(b, a)).isTrue();
        assertThat(ContactQuery.contacts(a, b)).isNotEmpty();
    }

    /** Rotations are kept as given where they are orthonormal to 1e-9; their transpose is no inverse then. */
    @ParameterizedTest
    @ValueSource(doubles = {4e-10, -4e-10, 1e-12, 0})
    void aRotationThatIsOneOnlyNearlyLosesNothing(double off) {
        MeshObject mesh = strip(1).oriented(new double[] {1 + off, 0, 0, 0, 1, 0, 0, 0, 1});
        double end = (1 + off) * 1000;
        touching(mesh, new SphereObject(new Point(end, 0.25, 0.25), 0));
        touching(mesh, new BoxObject(new Point(end, 0.25, 0.25), 0, 0.125, 0.125));
        touching(mesh, strip(1).movedTo(new Point(end, 0, 0)));
        touching(strip(0.5).movedTo(new Point(end, 0, 0)), mesh);
        Ray along = new Ray(new Point(end, 0.25, 10), new Point(0, 0, -1));
        assertThat(CollisionDetection.rayDistance(along, mesh)).isEqualTo(9.25);
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.MIN_VALUE, 5 * Double.MIN_VALUE, 0x1p-1060, 0x1p-1020})
    void whatIsTinyLosesNothing(double unit) {
        MeshObject mesh = strip(unit);
        touching(mesh, new SphereObject(new Point(1000 * unit, unit, 0), 0));
        touching(mesh, new SphereObject(new Point(1001 * unit, unit, 0), unit));
        touching(mesh, new BoxObject(new Point(1000 * unit, 0, unit), 2 * unit, 2 * unit, 2 * unit));
        touching(mesh, strip(unit).movedTo(new Point(1000 * unit, 0, 0)));
        Ray along = new Ray(new Point(1000 * unit, 0, 3 * unit), new Point(0, 0, -1));
        assertThat(CollisionDetection.rayDistance(along, mesh)).isEqualTo(2 * unit);
    }
}
