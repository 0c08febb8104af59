package robosim.geometry.report.speed;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/**
 * Prints what each query takes at each level over what it takes at EXACT, in worlds of files and random ones and in both
 * dimensions: by the clock of the thread, the least of rounds in which all levels took turns. Each level has a world of its
 * own. At the end stands how many of these ratios are above {@link #MOST}.
 *
 * <p>{@code -Dworlds=rooms,100} and {@code -Dqueries=ray,cone} measure some only, {@code -Drounds=9} more rounds, {@code -Dwarm=1} a longer
 * warm-up, in seconds of each level.
 */
final class Levels {
    /** No level is to take more than this many times what EXACT takes. */
    private static final double MOST = 1.05;

    private static final int QUERIES = 64;
    private static final int ROBOTS = 8;
    private static final double LONG = 3;
    private static final double SHORT = 0.01;

    /** A round of a level takes about this long. */
    private static final double ROUND_NANOS = 4e5;

    /** Each level runs about this long before it is measured. */
    private static final double WARM_NANOS = Double.parseDouble(System.getProperty("warm", "0.06")) * 1e9;

    private static final List<Accuracy> LEVELS =
            List.of(Accuracy.EXACT, Accuracy.DOP, Accuracy.OBB, Accuracy.AABB, Accuracy.SPHERE);

    private final int rounds = Integer.getInteger("rounds", 7);
    private final List<String> wanted =
            Arrays.asList(System.getProperty("queries", "").split(",", -1));
    private int cells;
    private int above;
    private double sum;

    private Levels() {}

    /** Measures and prints. */
    public static void main(String[] args) throws IOException {
        String worlds = System.getProperty("worlds", "rooms,warehouse,meshes,100,10000");
        Levels levels = new Levels();
        for (String world : worlds.split(",", -1)) {
            for (Dimension dimension : Dimension.values()) {
                levels.measure(world, dimension);
            }
        }
        levels.print("%d of %d ratios are above %.2f%n", levels.above, levels.cells, MOST);
    }

    private void print(String format, Object... values) {
        System.out.print(String.format(Locale.ROOT, format, values));
    }

    private void measure(String world, Dimension dimension) throws IOException {
        List<Geometry> geometries = new ArrayList<>();
        Questions questions = null;
        for (Accuracy level : LEVELS) {
            Geometry geometry = geometry(world, dimension, level);
            questions = questions == null ? new Questions(geometry) : questions;
            geometries.add(geometry);
        }
        if (questions == null) {
            throw new IllegalStateException("there are no levels");
        }
        for (Query query : Query.values()) {
            String name = query.name().toLowerCase(Locale.ROOT);
            if (wanted.contains("") || wanted.contains(name)) {
                print("%-10s %-8s %-14s", world, dimension, name);
                row(geometries, query.of(questions));
            }
        }
    }

    private static Geometry geometry(String world, Dimension dimension, Accuracy level) throws IOException {
        if (!Character.isDigit(world.charAt(0))) {
            return Place.of(world).geometry(dimension, level);
        }
        Field field = new Field(Integer.parseInt(world), Form.SEED);
        Geometry geometry = new Geometry(field.side + 20, 10, field.side + 20, dimension, level);
        field.objects.forEach(geometry::addObjectUnchecked);
        Geometry free = new Geometry(field.side + 20, 10, field.side + 20, Dimension.SPATIAL, Accuracy.EXACT);
        field.objects.forEach(free::addObjectUnchecked);
        SplittableRandom random = new SplittableRandom(Form.SEED);
        double side = Math.min(field.side, 100);
        for (int k = 0; k < ROBOTS; k++) {
            GeometryObject robot;
            do {
                Point at = new Point(random.nextDouble(-0.5, 0.5) * side, -1.5, random.nextDouble(-0.5, 0.5) * side);
                robot = k % 2 == 0
                        ? new CylinderObject(at, 0.3, 0.6)
                        : new BoxObject(at, 0.6, 0.6, 0.4).turned(0, random.nextDouble(-180, 180));
            } while (!free.addObject(robot));
            geometry.addObjectUnchecked(robot.moveable("robot " + k));
        }
        return geometry;
    }

    private void row(List<Geometry> geometries, ToDoubleFunction<Geometry> batch) {
        double[] nanos = new double[geometries.size()];
        int[] repeats = new int[geometries.size()];
        Arrays.fill(nanos, Double.POSITIVE_INFINITY);
        Arrays.fill(repeats, 1);
        double[] spent = new double[geometries.size()];
        for (int round = -2 * rounds; round < rounds; round++) {
            for (int k = 0; k < nanos.length; k++) {
                while (round < 0 && spent[k] < WARM_NANOS && repeats[k] > 1) {
                    spent[k] += repeats[k] * time(geometries.get(k), batch, repeats[k]);
                }
                if (spent[k] > 4 * WARM_NANOS && nanos[k] < Double.POSITIVE_INFINITY) {
                    continue; // it takes long enough to be known well
                }
                double one = time(geometries.get(k), batch, repeats[k]);
                spent[k] += one * repeats[k];
                if (round < 0 && one * repeats[k] < ROUND_NANOS) {
                    repeats[k] = (int) Math.max(1, Math.min(2.0 * repeats[k], ROUND_NANOS / one));
                }
                if (round >= 0 || spent[k] > 2 * WARM_NANOS) {
                    nanos[k] = Math.min(nanos[k], one);
                }
            }
        }
        print(" %10.0f ns", nanos[0] / QUERIES);
        for (int k = 1; k < nanos.length; k++) {
            double ratio = nanos[k] / nanos[0];
            cells++;
            above += ratio > MOST ? 1 : 0;
            print("  %s %.2f%s", LEVELS.get(k), ratio, ratio > MOST ? "*" : " ");
        }
        print("%n");
    }

    private double time(Geometry geometry, ToDoubleFunction<Geometry> batch, int repeats) {
        long start = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        for (int k = 0; k < repeats; k++) {
            sum += batch.applyAsDouble(geometry);
        }
        return (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - start) / (double) repeats;
    }

    private enum Query {
        PROBE {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return geometry -> q.tests(geometry, q.probes);
            }
        },
        OWN_PROBE {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return geometry -> q.tests(geometry, q.bodies);
            }
        },
        FREE_SHORT {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return geometry -> q.simpleMoves(geometry, q.freeShort);
            }
        },
        FREE_LONG {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return geometry -> q.simpleMoves(geometry, q.freeLong);
            }
        },
        REFUSED_LONG {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return geometry -> q.simpleMoves(geometry, q.refused);
            }
        },
        MOVE_REFUSED {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return geometry -> q.moves(geometry, q.refused);
            }
        },
        TURN {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return q::turns;
            }
        },
        RAY {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return geometry -> q.rays(geometry, 0);
            }
        },
        CONE {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return geometry -> q.rays(geometry, Place.CONE_DEGREES);
            }
        },
        SCAN {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return q::scans;
            }
        },
        PROXIMITY {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return q::proximities;
            }
        },
        FREE_POSES {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return q::freePoses;
            }
        },
        FREE_EDGES {
            @Override
            ToDoubleFunction<Geometry> of(Questions q) {
                return q::freeEdges;
            }
        };

        abstract ToDoubleFunction<Geometry> of(Questions questions);
    }

    /** What is asked of each world, which the world at EXACT decides. */
    private static final class Questions {
        final GeometryObject[] probes = new GeometryObject[QUERIES];
        final GeometryObject[] bodies = new GeometryObject[QUERIES];

        /** Displacements along X and Z, two numbers each, of the robots in turn. */
        final double[] freeShort = new double[2 * QUERIES];

        final double[] freeLong = new double[2 * QUERIES];
        final double[] refused = new double[2 * QUERIES];
        private final String[] robots;
        private final Ray[] rays = new Ray[QUERIES];
        private final double[][] poses;
        private final double[][] edges;
        private final double[] beams = new double[90];
        private final long[] free = new long[1];
        private final SplittableRandom random = new SplittableRandom(Form.SEED);
        private final double reach;

        Questions(Geometry geometry) {
            List<GeometryObject> movers = geometry.objects().stream()
                    .filter(GeometryObject::isMoveable)
                    .toList();
            robots = movers.stream().map(GeometryObject::name).toArray(String[]::new);
            reach = 0.48 * Math.min(100, Math.min(geometry.width(), geometry.length()));
            poses = new double[robots.length][];
            edges = new double[robots.length][];
            for (int k = 0; k < QUERIES; k++) {
                GeometryObject robot = movers.get(k % movers.size());
                Point at = anywhere(robot);
                probes[k] = k % 2 == 0
                        ? new CylinderObject(at, 0.3, 0.3)
                        : new BoxObject(at, 0.6, 0.3, 0.4).turned(0, random.nextDouble(-180, 180));
                bodies[k] = robot.movedTo(anywhere(robot));
                double angle = random.nextDouble(2 * Math.PI);
                rays[k] = new Ray(robot.center(), new Point(Math.cos(angle), 0, Math.sin(angle)));
                find(geometry, freeShort, k, SHORT, true);
                find(geometry, freeLong, k, LONG, true);
                find(geometry, refused, k, 100, false);
            }
            int each = QUERIES / robots.length;
            for (int k = 0; k < robots.length; k++) {
                poses[k] = new double[4 * each];
                edges[k] = new double[8 * each];
                for (int pose = 0; pose < each; pose++) {
                    Point at = anywhere(movers.get(k));
                    place(poses[k], 4 * pose, at, 0, 0);
                    place(edges[k], 8 * pose, at, 0, 0);
                    double angle = random.nextDouble(2 * Math.PI);
                    place(edges[k], 8 * pose + 4, at, Math.cos(angle), Math.sin(angle));
                }
            }
        }

        private void place(double[] out, int at, Point p, double dx, double dz) {
            out[at] = p.x() + dx;
            out[at + 1] = p.y();
            out[at + 2] = p.z() + dz;
        }

        private Point anywhere(GeometryObject robot) {
            return new Point(random.nextDouble(-reach, reach), robot.center().y(), random.nextDouble(-reach, reach));
        }

        /** Looks for a displacement that EXACT allows, or refuses; one not above the length given, or none after some tries. */
        private void find(Geometry geometry, double[] out, int k, double length, boolean isFree) {
            String robot = robots[k % robots.length];
            for (int tries = 0; tries < 100; tries++) {
                double angle = random.nextDouble(2 * Math.PI);
                double size = isFree ? length / (1 + tries / 10) : LONG * (1 + tries);
                double dx = size * Math.cos(angle);
                double dz = size * Math.sin(angle);
                boolean allowed = geometry.simpleMove(robot, dx, 0, dz);
                if (allowed) {
                    geometry.simpleMove(robot, -dx, 0, -dz);
                }
                out[2 * k] = dx;
                out[2 * k + 1] = dz;
                if (allowed == isFree) {
                    return;
                }
            }
        }

        double tests(Geometry geometry, GeometryObject[] objects) {
            int hits = 0;
            for (GeometryObject object : objects) {
                hits += geometry.testObject(object) ? 1 : 0;
            }
            return hits;
        }

        double simpleMoves(Geometry geometry, double[] ways) {
            int made = 0;
            for (int k = 0; k < QUERIES; k++) {
                String robot = robots[k % robots.length];
                if (geometry.simpleMove(robot, ways[2 * k], 0, ways[2 * k + 1])) {
                    made += geometry.simpleMove(robot, -ways[2 * k], 0, -ways[2 * k + 1]) ? 2 : 1;
                }
            }
            return made;
        }

        double moves(Geometry geometry, double[] ways) {
            double made = 0;
            for (int k = 0; k < QUERIES; k++) {
                String robot = robots[k % robots.length];
                Move move = new Move(ways[2 * k], 0, ways[2 * k + 1], 0, 0);
                if (geometry.move(robot, move).allowed()) {
                    geometry.simpleMove(robot, -ways[2 * k], 0, -ways[2 * k + 1]);
                } else {
                    made++;
                }
            }
            return made;
        }

        double turns(Geometry geometry) {
            int made = 0;
            for (int k = 0; k < QUERIES; k++) {
                String robot = robots[k % robots.length];
                made += geometry.simpleTurn(robot, 30) ? 1 : 0;
                made += geometry.simpleTurn(robot, -30) ? 1 : 0;
            }
            return made;
        }

        double rays(Geometry geometry, double degrees) {
            double total = 0;
            for (Ray ray : rays) {
                total += Math.min(
                        Place.RANGE, geometry.getRayDistance(ray, 0, Place.RANGE, degrees, geometry.accuracy()));
            }
            return total;
        }

        double scans(Geometry geometry) {
            double total = 0;
            for (int k = 0; k < QUERIES; k++) {
                geometry.scan(robots[k % robots.length], -90, 2, 0, Place.RANGE, beams);
                total += Math.min(Place.RANGE, beams[45]);
            }
            return total;
        }

        double proximities(Geometry geometry) {
            double total = 0;
            for (int k = 0; k < QUERIES; k++) {
                total += Math.min(5, geometry.getProximity(robots[k % robots.length], 5));
            }
            return total;
        }

        double freePoses(Geometry geometry) {
            int total = 0;
            for (int k = 0; k < robots.length; k++) {
                total += geometry.freePoses(robots[k], poses[k], free);
            }
            return total;
        }

        double freeEdges(Geometry geometry) {
            int total = 0;
            for (int k = 0; k < robots.length; k++) {
                total += geometry.freeEdges(robots[k], edges[k], free);
            }
            return total;
        }
    }
}
