package robosim.geometry.cli.worlds;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.shared.Floor;

/** The ground under the world of a picture. */
class CameraWorldTest {
    private static final Material RED = Material.of(Color.parse("#a03020"));
    private static final BoxObject CRATE = new BoxObject(new Point(3, 0.5, 2), 1, 1, 1);

    /** The floor that an infinite plane becomes. */
    private static BoxObject plane(double top) {
        return Floor.filling(Floor.at(top), 12, 10);
    }

    private static List<BoxObject> wide(CameraWorld.Ground ground, GeometryObject... objects) {
        World world = new World(
                12,
                6,
                10,
                null,
                Dimension.SPATIAL,
                Accuracy.EXACT,
                Stream.of(objects).map(WorldObject::new).toList());
        return new CameraWorld(world, ground)
                .snapshot().objects().stream()
                        .filter(object -> object.bounds().width() > 100)
                        .map(BoxObject.class::cast)
                        .toList();
    }

    private static double top(BoxObject box) {
        return box.bounds().maxY();
    }

    @Test
    void anInfinitePlaneIsTheGroundInItsColour() {
        BoxObject stone = new BoxObject(new Point(-3, -0.5, -2), 1, 2, 1); // half below the ground
        List<BoxObject> found = wide(CameraWorld.Ground.WIDE, plane(0).withMaterial(RED), CRATE, stone);
        assertThat(found).hasSize(1);
        assertThat(top(found.get(0))).isZero();
        assertThat(found.get(0).material().texture()).isInstanceOf(Texture.Checker.class);
        assertThat(((Texture.Checker) found.get(0).material().texture()).first())
                .isEqualTo(RED.color());
    }

    @Test
    void withoutAPlaneItLiesUnderTheLowestObject() {
        List<BoxObject> found = wide(CameraWorld.Ground.WIDE, CRATE);
        assertThat(found).hasSize(1);
        assertThat(top(found.get(0))).isZero();
        assertThat(wide(CameraWorld.Ground.NONE, CRATE)).isEmpty();
        assertThat(wide(CameraWorld.Ground.FLOOR, plane(0), CRATE)).isEmpty();
    }

    /** What fills the world above all else, has a picture of its own, or is a plate is not the ground. */
    @Test
    void ceilingsAndPlatesStay() {
        BoxObject plate = new BoxObject(new Point(0, -0.25, 0), 12, 0.5, 10).withMaterial(RED);
        Material tiled = RED.withTexture(new Texture.Checker(Color.WHITE, Color.BLACK, 1));
        for (GeometryObject other : List.of(plane(2.5).withMaterial(RED), plate, plane(0).withMaterial(tiled))) {
            List<BoxObject> found = wide(CameraWorld.Ground.WIDE, other, CRATE);
            assertThat(found).as("only that which was laid, with %s", other).hasSize(1);
            assertThat(found.get(0).material().color()).isNotEqualTo(RED.color());
        }
    }

    /** Tiles are 1, 2 or 5 times a power of ten, about 24 along the world, and begin at the origin. */
    @Test
    void tilesAreRoundNumbers() {
        BoxObject[][] worlds = {
            {CRATE}, {CRATE, new BoxObject(new Point(-5, 0.5, 0), 1, 1, 1)}, {new BoxObject(new Point(), 0.1, 1, 0.1)}
        };
        double[] tiles = {0.05, 0.5, 0.005}; // above 1 / 24, 9.5 / 24 and 0.1 / 24
        for (int k = 0; k < worlds.length; k++) {
            BoxObject ground = wide(CameraWorld.Ground.WIDE, worlds[k]).get(0);
            double tile = ((Texture.Checker) ground.material().texture()).size();
            assertThat(tile).isCloseTo(tiles[k], within(1e-12));
            double pairs = ground.bounds().maxX() / (2 * tile);
            assertThat(pairs).isCloseTo(Math.rint(pairs), within(1e-6));
        }
    }
}
