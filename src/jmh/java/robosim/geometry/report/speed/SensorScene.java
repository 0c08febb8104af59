package robosim.geometry.report.speed;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;

/** A world of a file as sensors see it: with heights, on a floor of squares, with a texture on every third object. */
final class SensorScene {
    static final List<String> NAMES = List.of("rooms", "warehouse", "meshes");

    static final int WIDTH = 320;
    static final int HEIGHT = 240;
    static final double DEGREES = 87;
    static final int LAYERS = 16;
    static final int COLUMNS = 1800;
    static final double RANGE = 100;

    /** Where sensors stand. */
    static final int POSES = 6;

    private static final Texture SQUARES = new Texture.Checker(Color.parse("#d9d4c8"), Color.parse("#a8a294"), 0.5);
    private static final Texture STRIPES = new Texture.Stripes(Color.parse("#d0a020"), Color.parse("#303030"), 0.2, 45);

    final String name;
    final List<GeometryObject> objects = new ArrayList<>();
    final Geometry geometry;
    final List<Pose> poses;

    private SensorScene(String name, World world) {
        this.name = name;
        double ground = Double.POSITIVE_INFINITY;
        for (WorldObject each : world.objects()) {
            GeometryObject object = each.object();
            ground = Math.min(ground, object.bounds().minY());
            Material material = object.material();
            objects.add(
                    objects.size() % 3 == 0
                            ? object.withMaterial(material.withTexture(objects.size() % 2 == 0 ? SQUARES : STRIPES))
                            : object);
        }
        double thick = 0.1;
        objects.add(new BoxObject(new Point(0, ground - thick / 2, 0), world.width(), thick, world.length())
                .withMaterial(Material.DEFAULT.withTexture(SQUARES)));
        geometry = geometry(world, objects);
        poses = poses(world, geometry, ground);
    }

    static SensorScene of(String name) throws IOException {
        return new SensorScene(name, WorldReader.read(Path.of("worlds", name + ".xml")));
    }

    private static Geometry geometry(World world, List<GeometryObject> objects) {
        Geometry geometry = new Geometry(
                2 * world.width(), 2 * world.height() + 4, 2 * world.length(), Dimension.SPATIAL, Accuracy.EXACT);
        objects.forEach(geometry::addObjectUnchecked);
        return geometry;
    }

    /** At the height of a person's hip, and free. */
    private static List<Pose> poses(World world, Geometry geometry, double ground) {
        SplittableRandom random = new SplittableRandom(Form.SEED);
        List<Pose> poses = new ArrayList<>();
        while (poses.size() < POSES) {
            Point at = new Point(
                    random.nextDouble(-0.45, 0.45) * world.width(),
                    ground + 1.2,
                    random.nextDouble(-0.45, 0.45) * world.length());
            if (!geometry.testObject(new SphereObject(at, 0.3))) {
                poses.add(Pose.of(at, random.nextDouble(-180, 180)));
            }
        }
        return poses;
    }

    /** The rays of a depth camera. */
    static RayPattern camera() {
        return RayPattern.pinhole(WIDTH, HEIGHT, DEGREES);
    }

    /** The rays of a lidar with 16 layers from -15 to 15 degrees. */
    static RayPattern turn() {
        double[] elevations = new double[LAYERS];
        for (int k = 0; k < LAYERS; k++) {
            elevations[k] = 2 * k - 15;
        }
        return RayPattern.layers(elevations, 180, -360.0 / COLUMNS, COLUMNS);
    }
}
