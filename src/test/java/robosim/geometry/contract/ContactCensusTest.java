package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/**
 * The contacts of blocked moves and turns of all pairs of shapes: the normal opposes the motion, its plane parts the two where
 * the mover stops, the contact point is on both, and upright shapes have the same normal in the plane and in space. Every
 * shape here is convex, so that the greatest coordinate along the normal, from the shapes' own formulas, decides.
 */
class ContactCensusTest {
    /** World units; objects are about 1 large. */
    private static final double NEAR = 1e-9;

    /** A turn may stop short of contact by 2^-30 of the mover's radius. */
    private static final double NEAR_OF_TURNS = 1e-8;

    private enum Shape {
        BOX,
        TURNED_BOX,
        CYLINDER,
        TURNED_CYLINDER,
        SPHERE,
        CAPSULE,
        TURNED_CAPSULE,
        MESH,
        SOLID_MESH,
        GROUP,
        GRID;

        boolean isUpright() {
            return switch (this) {
                case TURNED_BOX, TURNED_CYLINDER, TURNED_CAPSULE -> false;
                case BOX, CYLINDER, SPHERE, CAPSULE, MESH, SOLID_MESH, GROUP, GRID -> true;
            };
        }
    }

    /** How the two stand to each other. */
    private enum Regime {
        /** Any attitudes. */
        GENERIC,
        /** The same attitude, so that faces are parallel. */
        PARALLEL,
        /** The same attitude, equal sizes, and a diagonal motion: edges meet, or corners. */
        EDGES,
        /** The mover is turned by 45 degrees: a corner or an edge goes ahead. */
        CORNER,
        /** The mover passes along a side and hits what is exactly as far aside: only edges touch. */
        FLUSH
    }

    /** A grid cannot move. */
    private static final Set<Shape> MOVERS = EnumSet.complementOf(EnumSet.of(Shape.GRID));

    private final SplittableRandom random = new SplittableRandom(20261126);
    private final Map<Regime, Integer> blocked = new EnumMap<>(Regime.class);

    private double half;

    @Test
    void contactsOfMoves() {
        int same = 0;
        int rounds = Effort.cases(4, 2);
        for (int round = 0; round < rounds; round++) {
            for (Shape first : MOVERS) {
                for (Shape second : Shape.values()) {
                    for (Regime regime : Regime.values()) {
                        same += move(first, second, regime) ? 1 : 0;
                    }
                }
            }
        }
        int each = rounds * MOVERS.size() * Shape.values().length * 2;
        for (Regime regime : Regime.values()) {
            assertThat(blocked.getOrDefault(regime, 0)).as("" + regime).isGreaterThan(each / 3);
        }
        assertThat(same).isGreaterThan(each / 2);
    }

    @Test
    void contactsOfTurns() {
        int rounds = Effort.cases(4, 2);
        for (int round = 0; round < rounds; round++) {
            for (Shape first : MOVERS) {
                for (Shape second : Shape.values()) {
                    for (Dimension dimension : Dimension.values()) {
                        turn(first, second, dimension);
                    }
                }
            }
        }
        assertThat(blocked.getOrDefault(Regime.GENERIC, 0)).isGreaterThan(rounds * 40);
    }

    /** Answers whether the normals in the plane and in space could be compared. */
    private boolean move(Shape first, Shape second, Regime regime) {
        half = random.nextInt(2, 9) / 8.0;
        boolean any = regime == Regime.GENERIC;
        double tilt = any ? random.nextDouble(-180, 180) : 90 * random.nextInt(4) + 45 * random.nextInt(2);
        double heading = any || random.nextBoolean() ? random.nextDouble(-180, 180) : 90 * random.nextInt(4);
        GeometryObject obstacle = shape(second, tilt, heading);
        if (regime != Regime.EDGES && regime != Regime.FLUSH) {
            half = random.nextInt(2, 9) / 8.0;
        }
        double ahead = regime == Regime.CORNER ? heading + 45 : any ? random.nextDouble(-180, 180) : heading;
        GeometryObject mover = shape(first, any ? random.nextDouble(-180, 180) : tilt, ahead);
        double aside = switch (regime) {
            case GENERIC, PARALLEL, CORNER -> random.nextDouble(-1, 1);
            case EDGES -> 4;
            case FLUSH -> random.nextBoolean() ? half : 2 * half;
        };
        double rise =
                first.isUpright() && second.isUpright() && random.nextInt(4) > 0 ? 0 : random.nextInt(-2, 3) / 8.0;
        Point to = regime == Regime.EDGES ? new Point(-8, 0, -8) : new Point(-8, 0, any ? random.nextDouble(-1, 1) : 0);
        Point start = along(heading, new Point(4, 0, aside));
        GeometryObject placed =
                mover.movedTo(new Point(start.x(), rise, start.z())).moveable("mover");
        Point way = along(heading, to);
        Point[] normals = new Point[2];
        double[] fractions = new double[2];
        for (Dimension dimension : Dimension.values()) {
            Geometry world = world(dimension, obstacle, placed);
            MoveResult result = world.moveToContact("mover", local(placed, way), 0);
            if (!result.allowed() && result.fraction() > 0) {
                blocked.merge(regime, 1, Integer::sum);
                check(regime + " " + dimension, world, obstacle, result, way, NEAR);
                normals[dimension.ordinal()] = result.normal();
                fractions[dimension.ordinal()] = result.fraction();
            }
        }
        Point flat = normals[Dimension.PLANAR.ordinal()];
        Point spatial = normals[Dimension.SPATIAL.ordinal()];
        boolean isSame = flat != null
                && spatial != null
                && first.isUpright()
                && second.isUpright()
                && Math.abs(fractions[0] - fractions[1]) < 1e-12;
        if (isSame) {
            assertThat(distance(flat, spatial))
                    .as("%s, %s by %s: %s and %s", obstacle, placed, way, flat, spatial)
                    .isLessThan(1e-6);
        }
        return isSame;
    }

    private void turn(Shape first, Shape second, Dimension dimension) {
        half = random.nextInt(2, 5) / 8.0;
        double gap = half;
        GeometryObject still = shape(second, random.nextDouble(-180, 180), random.nextDouble(-180, 180));
        half = random.nextInt(5, 9) / 8.0;
        gap += half * random.nextDouble(1, 1.4);
        GeometryObject obstacle = still.movedTo(new Point(gap, random.nextInt(-1, 2) / 8.0, 0));
        GeometryObject mover = shape(
                        first, random.nextInt(4) * 30, random.nextInt(-2, 2) * 90 + random.nextDouble(-20, 20))
                .moveable("mover");
        Geometry world = world(dimension, obstacle, mover);
        if (world.getProximity("mover", 10) == 0) {
            return;
        }
        double degrees = random.nextBoolean() ? 170 : -170;
        MoveResult result = world.moveToContact("mover", new Move(0, 0, 0, 0, degrees), 0);
        if (!result.allowed() && result.turnFraction() > 0) {
            blocked.merge(Regime.GENERIC, 1, Integer::sum);
            double[] r = mover.rotation();
            Point p = result.contact();
            double sign = Math.signum(degrees);
            Point way = new Point(
                    sign * (r[4] * p.z() - r[7] * p.y()),
                    sign * (r[7] * p.x() - r[1] * p.z()),
                    sign * (r[1] * p.y() - r[4] * p.x()));
            check("turn " + dimension, world, obstacle, result, way, NEAR_OF_TURNS);
        }
    }

    private static void check(
            String what, Geometry world, GeometryObject obstacle, MoveResult result, Point way, double near) {
        GeometryObject mover = world.getObject("mover");
        Point n = result.normal();
        boolean isFlat = what.endsWith("PLANAR");
        double ahead = n.x() * way.x() + (isFlat ? 0 : n.y() * way.y()) + n.z() * way.z();
        String pair = "%s: %s at the stop, %s, going %s: %s".formatted(what, mover, obstacle, way, result);
        boolean isTipped = what.equals("turn PLANAR") && Math.abs(mover.rotation()[4]) != 1; // heights are not known
        // What passes along a round side exactly as far aside as it reaches touches it in passing.
        assertThat(isTipped ? -1 : ahead)
                .as(pair)
                .isLessThanOrEqualTo(what.startsWith("FLUSH") ? 0 : -Double.MIN_VALUE);
        assertThat(distance(n, new Point())).as(pair).isBetween(1 - 1e-12, 1 + 1e-12);
        assertThat(isFlat && n.y() != 0).as(pair).isFalse();
        Point back = new Point(-n.x(), -n.y(), -n.z());
        assertThat(-reach(mover, back)).as(pair).isGreaterThan(reach(obstacle, n) - near);
        assertThat(off(world, obstacle, result.contact())).as(pair).isLessThan(near);
        assertThat(off(world, mover, result.contact())).as(pair).isLessThan(near);
    }

    private static Geometry world(Dimension dimension, GeometryObject obstacle, GeometryObject mover) {
        Geometry world = new Geometry(40, 40, 40, dimension, Accuracy.EXACT);
        world.addObjectUnchecked(obstacle);
        world.addObjectUnchecked(mover);
        return world;
    }

    /** How far a point is from an object. */
    private static double off(Geometry of, GeometryObject object, Point point) {
        Geometry world = new Geometry(40, 40, 40, of.dimension(), Accuracy.EXACT);
        world.addObjectUnchecked(object.named("it"));
        world.addObjectUnchecked(new SphereObject(point, 0).moveable("point"));
        return world.getProximity("point", 1);
    }

    /** The greatest coordinate of a shape along a direction. */
    private static double reach(GeometryObject object, Point n) {
        double[] r = object.rotation();
        Point own = new Point(
                r[0] * n.x() + r[3] * n.y() + r[6] * n.z(),
                r[1] * n.x() + r[4] * n.y() + r[7] * n.z(),
                r[2] * n.x() + r[5] * n.y() + r[8] * n.z());
        Point c = object.center();
        return n.x() * c.x() + n.y() * c.y() + n.z() * c.z() + own(object, own);
    }

    private static double own(GeometryObject object, Point n) {
        double across = Math.hypot(n.x(), n.z());
        double length = Math.hypot(across, n.y());
        double up = Math.abs(n.y());
        return switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                yield (box.width() * Math.abs(n.x()) + box.height() * up + box.length() * Math.abs(n.z())) / 2;
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                yield cylinder.radius() * across + cylinder.height() / 2 * up;
            }
            case SPHERE -> ((SphereObject) object).radius() * length;
            case CAPSULE -> ((CapsuleObject) object).radius() * length + ((CapsuleObject) object).segment() / 2 * up;
            case MESH ->
                ((MeshObject) object)
                        .vertices().stream()
                                .mapToDouble(v -> n.x() * v.x() + n.y() * v.y() + n.z() * v.z())
                                .max()
                                .orElseThrow();
            case GROUP ->
                ((ObjectGroup) object)
                        .members().stream().mapToDouble(m -> reach(m, n)).max().orElseThrow();
            case GRID -> {
                GridObject grid = (GridObject) object;
                yield (grid.columns() * Math.abs(n.x()) + grid.rows() * Math.abs(n.z())) * grid.cell() / 2
                        + grid.height() / 2 * up;
            }
        };
    }

    private GeometryObject shape(Shape shape, double tilt, double heading) {
        Point o = new Point();
        return switch (shape) {
            case BOX -> new BoxObject(o, 2 * half, 2, 2 * half).turned(0, heading);
            case TURNED_BOX -> new BoxObject(o, 2 * half, 1, 2 * half).turned(tilt, heading);
            case CYLINDER -> new CylinderObject(o, half, 2).turned(0, heading);
            case TURNED_CYLINDER -> new CylinderObject(o, half, 1.5).turned(tilt, heading);
            case SPHERE -> new SphereObject(o, half);
            case CAPSULE -> new CapsuleObject(o, half, 2 - half).turned(0, heading);
            case TURNED_CAPSULE -> new CapsuleObject(o, half / 2, 1).turned(tilt, heading);
            case MESH ->
                RandomObjects.meshOf(new BoxObject(o, 2 * half, 2, 2 * half)).turned(0, heading);
            case SOLID_MESH ->
                RandomObjects.meshOf(new BoxObject(o, 2 * half, 2, 2 * half))
                        .solid()
                        .turned(0, heading);
            case GROUP ->
                new ObjectGroup(List.of(
                                new BoxObject(new Point(0, 0, -half / 2), 2 * half, 2, half),
                                new BoxObject(new Point(half / 2, 0, half / 2), half, 2, half),
                                new BoxObject(new Point(-half / 2, 0, half / 2), half, 2, half)))
                        .turned(0, heading);
            case GRID -> {
                BitSet cells = new BitSet();
                cells.set(0, 16);
                yield new GridObject(o, half / 2, 2, 4, 4, cells).turned(0, heading);
            }
        };
    }

    private static Point along(double heading, Point p) {
        double cos = Math.cos(Math.toRadians(heading));
        double sin = Math.sin(Math.toRadians(heading));
        boolean isQuarter = heading % 90 == 0;
        double c = isQuarter ? Math.rint(cos) : cos;
        double s = isQuarter ? Math.rint(sin) : sin;
        return new Point(c * p.x() + s * p.z(), p.y(), c * p.z() - s * p.x());
    }

    /** A displacement along the world's axes as a move along the object's own. */
    private static Move local(GeometryObject object, Point way) {
        double[] r = object.rotation();
        return new Move(
                r[0] * way.x() + r[3] * way.y() + r[6] * way.z(),
                r[1] * way.x() + r[4] * way.y() + r[7] * way.z(),
                r[2] * way.x() + r[5] * way.y() + r[8] * way.z(),
                0,
                0);
    }

    private static double distance(Point p, Point q) {
        double x = p.x() - q.x();
        double y = p.y() - q.y();
        double z = p.z() - q.z();
        return Math.sqrt(x * x + y * y + z * z);
    }
}
