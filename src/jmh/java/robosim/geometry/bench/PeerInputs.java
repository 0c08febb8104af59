package robosim.geometry.bench;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** The inputs that the peers read, as the module's own values; little-endian numbers one after the other. */
final class PeerInputs {
    private final Path folder;

    PeerInputs(Path folder) {
        this.folder = folder;
    }

    /** Flat objects in a square of a side, rays with a range each, and small discs to test. */
    record Scene(double side, List<GeometryObject> objects, Ray[] rays, double[] ranges, GeometryObject[] probes) {}

    Scene scene(int objects) throws IOException {
        ByteBuffer in = read("scene2d_" + objects + ".bin");
        int boxes = in.getInt();
        int cylinders = in.getInt();
        int rays = in.getInt();
        int probes = in.getInt();
        Scene scene = new Scene(
                in.getDouble(),
                new ArrayList<>(boxes + cylinders),
                new Ray[rays],
                new double[rays],
                new GeometryObject[probes]);
        for (int k = 0; k < boxes; k++) {
            scene.objects.add(box(in));
        }
        for (int k = 0; k < cylinders; k++) {
            scene.objects.add(disc(in));
        }
        for (int k = 0; k < rays; k++) {
            scene.rays[k] =
                    new Ray(new Point(in.getDouble(), 0, in.getDouble()), new Point(in.getDouble(), 0, in.getDouble()));
            scene.ranges[k] = in.getDouble();
        }
        for (int k = 0; k < probes; k++) {
            scene.probes[k] = disc(in);
        }
        return scene;
    }

    /** Their yaw takes the own X axis to (cos, sin) in (x, z): clockwise where the module's is counter-clockwise. */
    private static GeometryObject box(ByteBuffer in) {
        Point center = new Point(in.getDouble(), 0, in.getDouble());
        double halfX = in.getDouble();
        double halfZ = in.getDouble();
        double yaw = in.getDouble();
        BoxObject box = new BoxObject(center, 2 * halfX, 2, 2 * halfZ);
        double cos = StrictMath.cos(yaw);
        double sin = StrictMath.sin(yaw);
        return yaw == 0 ? box : box.oriented(new double[] {cos, 0, -sin, 0, 1, 0, sin, 0, cos});
    }

    private static GeometryObject disc(ByteBuffer in) {
        return new CylinderObject(new Point(in.getDouble(), 0, in.getDouble()), in.getDouble(), 2);
    }

    /** Solids at any attitude in a cube, rays in all directions and the rays of camera frames, all of one range. */
    record Space(double side, List<GeometryObject> objects, Ray[] rays, Ray[] frames) {
        static final double RANGE = 100;
    }

    Space space(int objects) throws IOException {
        ByteBuffer in = read("scene3d_" + objects + ".bin");
        int boxes = in.getInt();
        int cylinders = in.getInt();
        int spheres = in.getInt();
        Ray[] rays = new Ray[in.getInt()];
        Ray[] frames = new Ray[in.getInt()];
        Space space = new Space(in.getDouble(), new ArrayList<>(objects), rays, frames);
        for (int k = 0; k < boxes; k++) {
            BoxObject box = new BoxObject(point(in), 2 * in.getDouble(), 2 * in.getDouble(), 2 * in.getDouble());
            space.objects.add(box.oriented(rotation(in)));
        }
        for (int k = 0; k < cylinders; k++) {
            CylinderObject cylinder = new CylinderObject(point(in), in.getDouble(), 2 * in.getDouble());
            space.objects.add(cylinder.oriented(rotation(in)));
        }
        for (int k = 0; k < spheres; k++) {
            space.objects.add(new SphereObject(point(in), in.getDouble()));
        }
        for (Ray[] some : new Ray[][] {rays, frames}) {
            for (int k = 0; k < some.length; k++) {
                some[k] = new Ray(point(in), point(in));
            }
        }
        return space;
    }

    private static double[] rotation(ByteBuffer in) {
        double[] rotation = new double[9];
        for (int k = 0; k < 9; k++) {
            rotation[k] = in.getDouble();
        }
        return rotation;
    }

    MeshObject mesh(String name) throws IOException {
        ByteBuffer in = read(name + ".mesh");
        int vertices = in.getInt();
        int triangles = in.getInt();
        List<Point> corners = new ArrayList<>(vertices);
        for (int k = 0; k < vertices; k++) {
            corners.add(point(in));
        }
        int[][] faces = new int[triangles][];
        for (int k = 0; k < triangles; k++) {
            faces[k] = new int[] {in.getInt(), in.getInt(), in.getInt()};
        }
        return new MeshObject(corners, faces);
    }

    /** Rotations and translations of one mesh beside another. */
    record Poses(double[][] rotations, Point[] centers) {}

    Poses poses() throws IOException {
        ByteBuffer in = read("pair.poses");
        int count = in.getInt();
        Poses poses = new Poses(new double[count][], new Point[count]);
        for (int k = 0; k < count; k++) {
            poses.rotations[k] = rotation(in);
            poses.centers[k] = point(in);
        }
        return poses;
    }

    Ray[] rays() throws IOException {
        ByteBuffer in = read("rays.rays");
        Ray[] rays = new Ray[in.getInt()];
        for (int k = 0; k < rays.length; k++) {
            rays[k] = new Ray(point(in), point(in));
        }
        return rays;
    }

    private static Point point(ByteBuffer in) {
        return new Point(in.getDouble(), in.getDouble(), in.getDouble());
    }

    /** Hits and sum of distances of a scene's rays, then hits of its probes, if the folder holds a truth; else null. */
    double @Nullable [] truth(int objects) throws IOException {
        Path file = folder.resolve("data").resolve("truth.txt");
        if (Files.exists(file)) {
            for (String line : Files.readAllLines(file)) {
                // REF W1a N hits_solid H sum S .. W1b P
                String[] words = line.split(" ", -1);
                if (words.length > 6 && words[1].equals("W1a") && words[2].equals("" + objects)) {
                    return new double[] {
                        Double.parseDouble(words[4]),
                        Double.parseDouble(words[6]),
                        Double.parseDouble(words[words.length - 1])
                    };
                }
            }
        }
        return null;
    }

    private ByteBuffer read(String name) throws IOException {
        return ByteBuffer.wrap(Files.readAllBytes(folder.resolve("data").resolve(name)))
                .order(ByteOrder.LITTLE_ENDIAN);
    }
}
