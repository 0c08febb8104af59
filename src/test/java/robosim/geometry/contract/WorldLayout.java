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

/** How the objects of a random world are made and where they stand. */
enum WorldLayout {
    UNIFORM,
    /** In a few dense heaps. */
    CLUSTERED,
    /** Much higher than it is wide. */
    TALL,
    /** A wall of boxes side by side, and things before it. */
    WALL,
    /** A floor of tiles of equal height, and things that stand on it. */
    TILES,
    /** All coordinates and sizes are small integers. */
    LATTICE,
    HUGE_AMONG_TINY,
    TINY_AND_HUGE_CLUSTERS,
    /** Far away from the origin, where coordinates are coarse. */
    FAR,
    MESHES,
    GROUPS,
    /** Half of the objects move. */
    MOVERS,
    /** Flat sets, segments and points. */
    FLAT,
    /** Next to each other within a few last bits. */
    CLOSE,
    /** Robots alone, more of them than are looked for one by one, side by side on a lattice in a narrow world. */
    SWARM,
    /** A hundred beside each other, many of which move. */
    CROWD,
    /** A hundred, most of them above others. */
    STACKED;

    private static final int[][] QUADS = {
        {0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}
    };

    /** Half the width of the places where things stand. */
    double spread() {
        return switch (this) {
            case TALL, CLOSE, STACKED -> 3;
            case CROWD -> 12;
            case TINY_AND_HUGE_CLUSTERS, HUGE_AMONG_TINY -> 10;
            default -> 5;
        };
    }

    /** The extent of the world along each axis. */
    double extent() {
        return switch (this) {
            case FAR -> 4096;
            case TALL -> 80;
            case SWARM -> 11;
            default -> 32;
        };
    }

    /** How many objects there are, about. */
    int count() {
        return switch (this) {
            case CLOSE, FLAT, LATTICE, TILES, WALL -> 10;
            case UNIFORM -> 40;
            case SWARM -> 20;
            case CROWD, STACKED -> 100;
            default -> 16;
        };
    }

    double moveable(SplittableRandom random) {
        return switch (this) {
            case SWARM -> 0;
            case MOVERS -> random.nextDouble();
            default -> 3 * random.nextDouble();
        };
    }

    Point middle() {
        return this == FAR ? new Point(1700.3, 900.7, -1900.1) : new Point();
    }

    private static double coordinate(SplittableRandom random, double within) {
        double any = random.nextDouble(-within, within);
        return random.nextInt(3) > 0 ? any : Math.rint(4 * any) / 4;
    }

    /** A place where something may stand, or from where something may be asked. */
    Point place(SplittableRandom random) {
        double s = spread();
        Point m = middle();
        Point p = switch (this) {
            case LATTICE -> new Point(random.nextInt(-6, 7), random.nextInt(-2, 3), random.nextInt(-6, 7));
            case CLUSTERED, TINY_AND_HUGE_CLUSTERS -> {
                double cx = s * (random.nextInt(3) - 1) / 1.5;
                double cz = s * (random.nextInt(3) - 1) / 1.5;
                yield new Point(cx + coordinate(random, 1.2), coordinate(random, 1), cz + coordinate(random, 1.2));
            }
            case SWARM -> new Point(random.nextInt(-4, 5), random.nextInt(-1, 2) * 0.75, random.nextInt(-4, 5));
            case STACKED -> new Point(coordinate(random, s), coordinate(random, 12), coordinate(random, s));
            case TALL -> new Point(coordinate(random, s), coordinate(random, 36), coordinate(random, s));
            case WALL -> new Point(random.nextDouble(-3, 3), coordinate(random, 0.5), coordinate(random, s));
            case TILES -> new Point(coordinate(random, s), 0.5 * random.nextInt(3), coordinate(random, s));
            default -> new Point(coordinate(random, s), coordinate(random, s / 4), coordinate(random, s));
        };
        return new Point(p.x() + m.x(), p.y() + m.y(), p.z() + m.z());
    }

    /** Objects that the world begins with, before any at random. */
    List<GeometryObject> ground(SplittableRandom random) {
        List<GeometryObject> all = new ArrayList<>();
        if (this == WALL) {
            double width = random.nextBoolean() ? 1 : 0.7;
            for (int k = 0; k < 12; k++) {
                all.add(new BoxObject(new Point(4, 0, (k - 6) * width), 1, 3, width));
            }
        } else if (this == TILES) {
            double width = random.nextBoolean() ? 2 : 1.9;
            for (int k = 0; k < 16; k++) {
                Point at = new Point((k % 4 - 1.5) * width, -1, (k / 4 - 1.5) * width);
                all.add(new BoxObject(at, width, 2, width));
            }
        } else if (this == HUGE_AMONG_TINY) {
            all.add(new BoxObject(new Point(0, -4, 0), 24, 6, 24).turned(0, random.nextInt(2) * 30));
        }
        return all;
    }

    /** The next object, somewhere; it has no name and does not move. */
    GeometryObject next(SplittableRandom random, List<GeometryObject> others) {
        GeometryObject shape = shape(random, size(random));
        GeometryObject there = shape.movedTo(place(random));
        if (this == CLOSE && !others.isEmpty() && random.nextInt(3) > 0) {
            there = shape.movedTo(beside(random, others.get(random.nextInt(others.size()))));
        }
        if (this == TILES && random.nextInt(3) > 0) {
            Point at = there.center();
            return there.movedTo(new Point(at.x(), halfHeight(shape), at.z())).turned(0, 15 * random.nextInt(24));
        }
        return turned(random, there);
    }

    /** Of what is upright; what has its own frame is let stand at its origin. */
    private static double halfHeight(GeometryObject object) {
        return switch (object.kind()) {
            case BOX -> ((BoxObject) object).height() / 2;
            case CYLINDER -> ((CylinderObject) object).height() / 2;
            case SPHERE -> ((SphereObject) object).radius();
            case CAPSULE -> ((CapsuleObject) object).height() / 2;
            case MESH, GROUP, GRID -> 0;
        };
    }

    private GeometryObject turned(SplittableRandom random, GeometryObject there) {
        return switch (this == LATTICE ? random.nextInt(2) : random.nextInt(6)) {
            case 0 -> there;
            case 1 -> there.turned(0, 90 * random.nextInt(4));
            case 2 -> there.turned(90 * random.nextInt(4), 90 * random.nextInt(4));
            case 3 -> there.turned(random.nextDouble(-180, 180), random.nextDouble(-180, 180));
            default -> there.turned(0, random.nextDouble(-180, 180));
        };
    }

    /** A place near another object's, off by a size of either or by that and a few last bits. */
    private static Point beside(SplittableRandom random, GeometryObject other) {
        Point c = other.center();
        double by = random.nextInt(1, 9) / 4.0;
        double off = random.nextInt(3) == 0 ? 0 : random.nextInt(-4, 5) * Math.ulp(by + Math.abs(c.x()));
        return random.nextBoolean()
                ? new Point(c.x() + by + off, c.y(), c.z())
                : new Point(c.x(), c.y(), c.z() - by - off);
    }

    private double size(SplittableRandom random) {
        return switch (this) {
            case LATTICE -> random.nextInt(1, 3);
            case CLOSE -> random.nextInt(1, 5) / 4.0;
            case SWARM -> random.nextInt(1, 4) / 4.0;
            case HUGE_AMONG_TINY -> random.nextInt(40) == 0 ? 3 : random.nextDouble(0.02, 0.3);
            case TINY_AND_HUGE_CLUSTERS ->
                random.nextInt(8) == 0 ? random.nextDouble(1, 3) : Math.scalb(1.0, -random.nextInt(2, 30));
            case FLAT -> random.nextInt(3) == 0 ? 0 : random.nextInt(1, 5) / 4.0;
            case TILES, WALL -> random.nextBoolean() ? 0.5 : random.nextDouble(0.1, 0.6);
            default -> random.nextInt(8) == 0 ? random.nextInt(1, 5) / 4.0 : random.nextDouble(0.1, 1);
        };
    }

    private double extent(SplittableRandom random, double size) {
        return switch (this) {
            case LATTICE -> random.nextInt(1, 4);
            case FLAT -> random.nextInt(3) == 0 ? 0 : size;
            default -> random.nextInt(3) == 0 ? 2 * size : 2 * size * random.nextDouble(0.2, 1);
        };
    }

    private GeometryObject shape(SplittableRandom random, double size) {
        int kind = random.nextInt(this == MESHES ? 4 : 12);
        if (this == GROUPS || kind == 1) {
            return group(random, size);
        }
        return kind <= 1 || this == MESHES ? mesh(random, size) : simple(random, size);
    }

    private GeometryObject simple(SplittableRandom random, double size) {
        double e = extent(random, size);
        double half = this == LATTICE ? Math.ceil(size / 2) : size / 2;
        return switch (random.nextInt(6)) {
            case 0, 1 -> new BoxObject(new Point(), e, extent(random, size), extent(random, size));
            case 2, 3 -> new CylinderObject(new Point(), half, e);
            case 4 -> new CapsuleObject(new Point(), half, e);
            default -> new SphereObject(new Point(), half);
        };
    }

    private GeometryObject group(SplittableRandom random, double size) {
        List<GeometryObject> members = new ArrayList<>();
        for (int k = random.nextInt(1, 4); k > 0; k--) {
            GeometryObject member = random.nextInt(6) == 0 ? mesh(random, size) : simple(random, size);
            Point at = new Point(corner(random, size), corner(random, size), corner(random, size));
            members.add(turned(random, member.movedTo(at)));
        }
        return new ObjectGroup(members);
    }

    private double corner(SplittableRandom random, double size) {
        double any = size * random.nextDouble(-1, 1);
        return this == LATTICE ? Math.rint(any) : any;
    }

    /** A loose surface, or a closed one that is solid now and then. */
    private MeshObject mesh(SplittableRandom random, double size) {
        List<Point> vertices = new ArrayList<>();
        if (random.nextBoolean()) {
            int count = random.nextInt(1, 4);
            int[][] faces = new int[count][];
            for (int k = 0; k < count + 2; k++) {
                vertices.add(new Point(corner(random, size), corner(random, size), corner(random, size)));
            }
            for (int k = 0; k < count; k++) {
                faces[k] = new int[] {k, k + 1, k + 2};
            }
            return new MeshObject(vertices, faces);
        }
        double push = random.nextBoolean() ? 0 : size / 3;
        for (int k = 0; k < 8; k++) {
            vertices.add(new Point(
                    ((k & 1) == 0 ? -size : size) + push * random.nextDouble(),
                    ((k & 2) == 0 ? -size : size) + push * random.nextDouble(),
                    ((k & 4) == 0 ? -size : size) + push * random.nextDouble()));
        }
        MeshObject closed = new MeshObject(vertices, QUADS);
        return random.nextBoolean() ? closed.solid() : closed;
    }

    /** A step of a move along one axis. */
    double step(SplittableRandom random) {
        return switch (this == LATTICE ? random.nextInt(3) : random.nextInt(8)) {
            case 0 -> 0;
            case 1 -> random.nextInt(-3, 4);
            case 2 -> random.nextInt(-12, 13) / 4.0;
            case 3 -> random.nextDouble(-0.05, 0.05) * spread();
            case 4 -> random.nextInt(-3, 4) * 0x1p-50;
            default -> random.nextDouble(-0.5, 0.5) * spread();
        };
    }
}
