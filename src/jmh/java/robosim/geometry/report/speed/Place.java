package robosim.geometry.report.speed;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;

/** A world of a file, and questions of robots in it. */
final class Place {
    static final List<String> NAMES = List.of("rooms", "maze", "warehouse", "cylinders", "meshes", "hard");
    static final double RANGE = 20;
    static final double CONE_DEGREES = 15;

    private final World world;
    private final SplittableRandom random = new SplittableRandom(Form.SEED);
    private final Geometry exact;
    private final double height;

    private Place(World world) {
        this.world = world;
        exact = geometry(Dimension.SPATIAL, Accuracy.EXACT);
        height = exact.objects().stream()
                .filter(GeometryObject::isMoveable)
                .mapToDouble(object -> object.center().y())
                .average()
                .orElse(0);
    }

    static Place of(String name) throws IOException {
        return new Place(WorldReader.read(Path.of("worlds", name + ".xml")));
    }

    World world() {
        return world;
    }

    Geometry geometry(Dimension dimension, Accuracy accuracy) {
        Geometry geometry = new Geometry(world.width(), world.height(), world.length(), dimension, accuracy);
        for (WorldObject object : world.objects()) {
            geometry.addObjectUnchecked(object.object());
        }
        return geometry;
    }

    String[] robots() {
        return exact.objects().stream()
                .filter(GeometryObject::isMoveable)
                .map(GeometryObject::name)
                .toArray(String[]::new);
    }

    private Point anywhere() {
        return new Point(
                random.nextDouble(-0.48, 0.48) * world.width(),
                height,
                random.nextDouble(-0.48, 0.48) * world.length());
    }

    /** Robots' bodies anywhere, at the height at which this world's own robots stand. */
    GeometryObject[] probes(int count) {
        List<GeometryObject> probes = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            probes.add(
                    k % 2 == 0
                            ? new CylinderObject(anywhere(), 0.3, 0.3)
                            : new BoxObject(anywhere(), 0.6, 0.3, 0.4).turned(0, random.nextDouble(-180, 180)));
        }
        return probes.toArray(GeometryObject[]::new);
    }

    /** Level rays in any direction from where a robot of radius 0.3 may stand. */
    Ray[] rays(int count) {
        Ray[] rays = new Ray[count];
        for (int k = 0; k < count; k++) {
            Point start = anywhere();
            while (exact.testObject(new CylinderObject(start, 0.3, 0.1))) {
                start = anywhere();
            }
            double angle = random.nextDouble(2 * Math.PI);
            rays[k] = new Ray(start, new Point(StrictMath.cos(angle), 0, StrictMath.sin(angle)));
        }
        return rays;
    }

    /** Short ways, two numbers each. */
    double[] ways(int count) {
        double[] ways = new double[2 * count];
        for (int k = 0; k < ways.length; k++) {
            ways[k] = random.nextDouble(-0.05, 0.05);
        }
        return ways;
    }
}
