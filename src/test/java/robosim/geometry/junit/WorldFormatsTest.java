package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.Geometry;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** A test's world may be a file of a simulator or a map. */
class WorldFormatsTest {
    private static double ahead(Geometry geometry, double x, double y, double z) {
        return geometry.getRayDistance(new Ray(new Point(x, y, z), new Point(1, 0, 0)), 0, Double.POSITIVE_INFINITY, 0);
    }

    @Test
    @World("src/test/resources/robosim/geometry/world/sdf/inner_walls/model.sdf")
    void sdf(Geometry geometry) {
        assertThat(ahead(geometry, -4, 0.25, 1.5)).isEqualTo(1.5);
    }

    @Test
    @World("src/test/resources/robosim/geometry/world/maps/TenByTen.yaml")
    void map(Geometry geometry) {
        assertThat(ahead(geometry, 0.5, 0, -6)).isCloseTo(3.5, within(1e-12));
    }

    @Test
    @World("src/test/resources/robosim/geometry/world/unit_cube.STL")
    void mesh(Geometry geometry) {
        assertThat(ahead(geometry, -0.6, 0.25, 0.125)).isCloseTo(0.1, within(1e-12));
    }

    /** All that is wrong with a file is in the message, not the first alone. */
    @Test
    void allProblemsAreListed(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("w.xml"), """
                <world xmlns="urn:robosim:world:1" width="10" height="2" length="10">
                  <wall/>
                  <ball/>
                </world>
                """);
        assertThatThrownBy(() -> WorldFile.read(file.toString(), WorldFormatsTest.class))
                .hasMessageContainingAll("w.xml:2:", "<wall> is not allowed", "w.xml:3:", "<ball> is not allowed");
    }

    /** The ground of a world of Gazebo is a floor that robots stand and drive on, and no hit. */
    @Test
    @World("src/test/resources/robosim/geometry/world/sdf/shapes.sdf")
    void theGroundOfGazebo(RobotWorld world) {
        world.robot("box").drives(0.1, 0).forSeconds(1).hitsNothing();
        assertThat(world.robot("box").center().y()).isCloseTo(0.5, within(1e-6));
    }
}
