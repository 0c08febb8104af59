package robosim.geometry.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Worlds with everything that a file can hold, most of it awkward. */
final class RandomWorlds {
    private static final String[] NAMES = {
        "robot",
        "a \"quoted\" <one> & more",
        " spaces  around ",
        "tab\there",
        "line\nbreak\r",
        "\u00fcml\u00e4ut",
        "\ud83e\udd16",
        "]]>",
        "'",
        "&amp;"
    };

    private final SplittableRandom random;

    RandomWorlds(long seed) {
        random = new SplittableRandom(seed);
    }

    World next() {
        List<WorldObject> objects = new ArrayList<>();
        int count = random.nextInt(8);
        for (int k = 0; k < count; k++) {
            boolean isGrid = random.nextInt(8) == 0;
            GeometryObject object = isGrid ? surfaced(grid()) : object(0);
            object = random.nextBoolean() ? object.named(NAMES[random.nextInt(NAMES.length)] + k) : object;
            object = !isGrid && random.nextInt(3) == 0 ? object.moveable("mover " + k) : object;
            String color = random.nextBoolean() ? "#%06x".formatted(random.nextInt(1 << 24)) : null;
            objects.add(new WorldObject(object, color, isGrid || object.name() == null ? List.of() : sonars()));
        }
        Unit[] units = Unit.values();
        return new World(
                Math.max(size(), Double.MIN_VALUE),
                Math.max(size(), Double.MIN_VALUE),
                Math.max(size(), Double.MIN_VALUE),
                random.nextBoolean() ? units[random.nextInt(units.length)] : null,
                random.nextBoolean() ? Dimension.PLANAR : Dimension.SPATIAL,
                Accuracy.values()[random.nextInt(5)],
                objects);
    }

    private List<SonarRing> sonars() {
        List<SonarRing> sonars = new ArrayList<>();
        for (int k = random.nextInt(3); k > 0; k--) {
            double min = random.nextBoolean() ? 0 : random.nextDouble();
            double max = random.nextBoolean() ? Double.POSITIVE_INFINITY : min + random.nextDouble(10);
            sonars.add(new SonarRing(1 + random.nextInt(100), angle(), angle(), min, max, random.nextDouble(180)));
        }
        return sonars;
    }

    private GeometryObject grid() {
        int columns = 1 + random.nextInt(9);
        int rows = 1 + random.nextInt(9);
        BitSet occupied = new BitSet();
        occupied.set(random.nextInt(columns * rows));
        for (int k = random.nextInt(40); k > 0; k--) {
            occupied.set(random.nextInt(columns * rows));
        }
        GeometryObject grid = new GridObject(new Point(), random.nextDouble(0.01, 3), size(), columns, rows, occupied);
        grid = grid.movedTo(new Point(random.nextDouble(-100, 100), number(), random.nextDouble(-100, 100)));
        return switch (random.nextInt(4)) {
            case 0 -> grid;
            case 1 -> grid.turned(0, 90 * random.nextInt(8));
            case 2 -> grid.oriented(new double[] {0.8, 0, 0.6, 0, 1, 0, -0.6, 0, 0.8});
            default -> drifted(grid);
        };
    }

    private GeometryObject object(int depth) {
        GeometryObject shape = switch (random.nextInt(depth < 3 ? 7 : 5)) {
            case 0 -> new BoxObject(new Point(), size(), size(), size());
            case 1 -> new CylinderObject(new Point(), size(), size());
            case 2 -> new SphereObject(new Point(), size());
            case 3 -> new CapsuleObject(new Point(), size(), size());
            case 4 -> mesh();
            default -> group(depth);
        };
        shape = surfaced(shape);
        shape = random.nextInt(4) == 0 ? shape : shape.movedTo(new Point(number(), number(), number()));
        return switch (random.nextInt(6)) {
            case 0 -> shape;
            case 1 -> shape.turned(0, 90 * random.nextInt(8));
            case 2 -> shape.turned(90, 90 * random.nextInt(8));
            case 3 -> shape.turned(angle(), angle());
            case 4 -> shape.oriented(new double[] {0.8, -0.6, 0, 0.6, 0.8, 1e-10, 0, 0, 1});
            default -> drifted(shape);
        };
    }

    private GeometryObject surfaced(GeometryObject object) {
        return switch (random.nextInt(4)) {
            case 0 -> object.withMaterial(Material.of(color()));
            case 1 ->
                object.withMaterial(Material.of(color())
                        .withDiffuse(share())
                        .withSpecular(share())
                        .withShininess(1 + Math.min(size(), 1e5))
                        .withMirror(share())
                        .withEmission(color())
                        .withTexture(texture())
                        .withReflectance(share())
                        .withLabel(random.nextInt(1 << random.nextInt(31))));
            default -> object;
        };
    }

    private double share() {
        return random.nextBoolean() ? random.nextInt(3) / 2.0 : random.nextDouble();
    }

    private Color color() {
        return switch (random.nextInt(3)) {
            case 0 -> Material.DEFAULT.color();
            case 1 -> Color.ofPacked(random.nextInt(1 << 24));
            default -> new Color(share(), share(), 1e-300 * share());
        };
    }

    private @Nullable Texture texture() {
        double size = Math.max(size(), Double.MIN_VALUE);
        return switch (random.nextInt(4)) {
            case 0 -> null;
            case 1 -> new Texture.Checker(color(), color(), size);
            case 2 -> new Texture.Stripes(color(), color(), size, angle());
            default -> {
                int columns = 1 + random.nextInt(5);
                int rows = 1 + random.nextInt(5);
                int[] pixels = random.ints(columns * rows, 0, 1 << 24).toArray();
                yield new ImageTexture(columns, rows, pixels, size, 1.0 / 3);
            }
        };
    }

    /** An upright object whose heading, after many turns, is more than one double can say. */
    private GeometryObject drifted(GeometryObject shape) {
        GeometryObject turned = shape;
        for (int k = random.nextInt(20); k > 0; k--) {
            turned = turned.turned(0, angle());
        }
        return turned;
    }

    private GeometryObject group(int depth) {
        List<GeometryObject> members = new ArrayList<>();
        for (int k = random.nextInt(3); k >= 0; k--) {
            GeometryObject member = object(depth + 1);
            members.add(random.nextInt(4) == 0 ? member.moveable("member") : member);
        }
        return new ObjectGroup(members, random.nextBoolean() ? bounds() : null);
    }

    private MeshObject mesh() {
        double s = random.nextDouble(2);
        // A tetrahedron, whose first face is made of other faces now and then.
        List<Point> vertices =
                new ArrayList<>(List.of(new Point(), new Point(s, 0, 0), new Point(0, s, 0), new Point(0, 0, s)));
        int[][] faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
        boolean open = random.nextBoolean();
        if (open) {
            vertices.add(new Point(number(), number(), number()));
            faces = new int[][] {{0, 1, 2, 3}, {4, 4, 4}, {0, 2, 1}, {1, 2, 3, 4}, {3, 2, 1, 0}};
        }
        @Nullable GeometryObject bounds = random.nextBoolean() ? bounds() : null;
        MeshObject mesh = bounds == null ? new MeshObject(vertices, faces) : new MeshObject(vertices, faces, bounds);
        mesh = open || random.nextBoolean() ? mesh : mesh.solid();
        if (random.nextInt(3) > 0) {
            return mesh;
        }
        double[] points = new double[2 * random.nextInt(5)];
        Arrays.setAll(points, k -> number());
        int corners = Arrays.stream(faces).mapToInt(face -> face.length).sum();
        return mesh.withTextureCoordinates(new TextureCoordinates(
                points, random.ints(corners, -1, points.length / 2).toArray()));
    }

    private GeometryObject bounds() {
        double far = 1e9;
        return switch (random.nextInt(3)) {
            case 0 -> new BoxObject(new Point(number(), 0, 1), far, far, far).turned(0, angle());
            case 1 -> new CylinderObject(new Point(), far, far).named("bounds");
            default -> new SphereObject(new Point(1, 2, number()), far).turned(angle(), angle());
        };
    }

    private double angle() {
        return random.nextDouble(-400, 400);
    }

    private double size() {
        return Math.abs(number());
    }

    private double number() {
        return switch (random.nextInt(8)) {
            case 0 -> 0;
            case 1 -> random.nextInt(-9, 9);
            case 2 -> 1.0 / 3;
            case 3 -> Double.MIN_VALUE;
            case 4 -> 1e-300 * random.nextDouble();
            case 5 -> random.nextDouble(-1e6, 1e6);
            default -> random.nextDouble(-10, 10);
        };
    }
}
