package robosim.geometry.contract;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/**
 * Objects of all six shapes: upright, turned and tipped, some flat or empty, half of them on a grid of eighths, where
 * things touch exactly.
 */
public final class RandomObjects {
    /** Two triangles a side, corners as bits: 1 for X, 2 for Y, 4 for Z. */
    private static final int[][] BOX_TRIANGLES = {
        {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
        {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}
    };

    private static final int[][] BOX_QUADS = {
        {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}
    };

    private final SplittableRandom random;
    private final double spread;
    private final double rise;

    /** Objects of sizes about 1 with centres up to {@code spread} from the origin. */
    public RandomObjects(SplittableRandom random, double spread) {
        this(random, spread, 0.25);
    }

    /** The same, with centres up to {@code rise * spread} above and below the origin. */
    RandomObjects(SplittableRandom random, double spread, double rise) {
        this.rise = rise;
        this.random = random;
        this.spread = spread;
    }

    public GeometryObject next() {
        return placed(shape(0), spread);
    }

    /** A box, cylinder, sphere or capsule. */
    public GeometryObject primitive() {
        return placed(simple(random.nextInt(4)), spread);
    }

    /** A primitive that stands upright. */
    GeometryObject upright() {
        return simple(random.nextInt(4)).turned(0, heading()).movedTo(place(spread));
    }

    public Point place() {
        return place(spread);
    }

    /** A direction of any length but zero, now and then along an axis or a diagonal. */
    public Point direction() {
        while (true) {
            Point direction = random.nextInt(4) == 0
                    ? new Point(random.nextInt(-1, 2), random.nextInt(-1, 2), random.nextInt(-1, 2))
                    : new Point(random.nextDouble(-1, 1), random.nextDouble(-1, 1) / 2, random.nextDouble(-1, 1));
            if (direction.x() != 0 || direction.z() != 0) {
                return direction;
            }
        }
    }

    private GeometryObject shape(int depth) {
        int kind = random.nextInt(depth < 2 ? 8 : 5);
        return switch (kind) {
            case 0, 1, 2 -> simple(kind);
            case 3 -> surface();
            case 4 -> closed();
            case 5 -> simple(3);
            default -> group(depth);
        };
    }

    private GeometryObject simple(int kind) {
        return switch (kind) {
            case 0 -> new BoxObject(new Point(), 2 * size(), 2 * size(), 2 * size());
            case 1 -> new CylinderObject(new Point(), size(), 2 * size());
            case 2 -> new SphereObject(new Point(), size());
            default -> new CapsuleObject(new Point(), size(), 2 * size());
        };
    }

    private GeometryObject group(int depth) {
        List<GeometryObject> members = new ArrayList<>();
        for (int k = random.nextInt(3); k >= 0; k--) {
            members.add(placed(shape(depth + 1), 1.5));
        }
        return new ObjectGroup(members);
    }

    private MeshObject surface() {
        int count = random.nextInt(1, 6);
        List<Point> vertices = new ArrayList<>();
        int[][] faces = new int[count][];
        for (int k = 0; k < count + 2; k++) {
            vertices.add(place(1));
        }
        for (int k = 0; k < count; k++) {
            faces[k] = k % 2 == 1 && k + 3 < vertices.size()
                    ? new int[] {k, k + 1, k + 3, k + 2}
                    : new int[] {k, k + 1, k + 2};
        }
        return new MeshObject(vertices, faces);
    }

    /** A box with pushed corners, of triangles or of quads that are not flat, now and then solid. */
    private MeshObject closed() {
        double push = random.nextInt(3) == 0 ? 0 : 0.4;
        double x = size();
        double y = size();
        double z = size();
        List<Point> vertices = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            vertices.add(new Point(
                    ((k & 1) == 0 ? -x : x) + push * random.nextDouble(),
                    ((k & 2) == 0 ? -y : y) + push * random.nextDouble(),
                    ((k & 4) == 0 ? -z : z) + push * random.nextDouble()));
        }
        MeshObject mesh = new MeshObject(vertices, random.nextBoolean() ? BOX_TRIANGLES : BOX_QUADS);
        return random.nextInt(3) == 0 ? mesh : mesh.solid();
    }

    private GeometryObject placed(GeometryObject shape, double within) {
        GeometryObject there = shape.movedTo(place(within));
        return switch (random.nextInt(5)) {
            case 0 -> there;
            case 1, 2 -> there.turned(0, heading());
            case 3 -> there.turned(90 * random.nextInt(4), heading());
            default -> there.turned(random.nextDouble(-180, 180), heading());
        };
    }

    double heading() {
        return random.nextInt(3) == 0 ? 45 * random.nextInt(-4, 5) : random.nextDouble(-180, 180);
    }

    private Point place(double within) {
        return new Point(coordinate(within), coordinate(rise * within), coordinate(within));
    }

    private double coordinate(double within) {
        double any = random.nextDouble(-within, within);
        return random.nextBoolean() ? any : Math.rint(8 * any) / 8;
    }

    private double size() {
        return switch (random.nextInt(12)) {
            case 0 -> 0;
            case 1, 2, 3 -> random.nextInt(1, 9) / 8.0;
            default -> random.nextDouble(0.1, 1);
        };
    }

    /** The mesh of a box's own corners: its twelve triangles, solid. */
    static MeshObject meshOf(BoxObject box) {
        List<Point> vertices = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            vertices.add(new Point(
                    (k & 1) == 0 ? -box.width() / 2 : box.width() / 2,
                    (k & 2) == 0 ? -box.height() / 2 : box.height() / 2,
                    (k & 4) == 0 ? -box.length() / 2 : box.length() / 2));
        }
        return new MeshObject(vertices, BOX_TRIANGLES).solid().at(box.pose());
    }

    /** The surface of an upright box that faces +X, in its own place. */
    static MeshObject surfaceOf(BoxObject box) {
        MeshObject mesh = meshOf(box);
        return new MeshObject(mesh.vertices(), BOX_TRIANGLES).at(box.pose());
    }
}
