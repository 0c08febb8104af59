package robosim.geometry.contract;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.RayHit;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/**
 * A world without any index: every object stands alone in a world of its own, and all of them are asked but those that no
 * sphere about them lets come near, which is {@link #WIDE} times as large as the object.
 */
final class PlainList {
    private static final double INFINITE = Double.POSITIVE_INFINITY;
    private static final Point STILL = new Point();

    /** No level's enclosure, nor what one sweeps in a turn, reaches farther from an object's centre than its sphere so often. */
    private static final double WIDE = 3;

    private final double size;
    private final Dimension dimension;
    private final Accuracy accuracy;
    private final List<GeometryObject> objects = new ArrayList<>();
    private final List<Geometry> alone = new ArrayList<>();
    private final List<Geometry> unused = new ArrayList<>();

    /** The world's border alone. */
    private int equals;

    private final Geometry empty;

    PlainList(double size, Dimension dimension, Accuracy accuracy) {
        this.size = size;
        this.dimension = dimension;
        this.accuracy = accuracy;
        empty = world();
    }

    private Geometry world() {
        return new Geometry(size, size, size, dimension, accuracy);
    }

    List<GeometryObject> objects() {
        return objects;
    }

    void add(GeometryObject object) {
        Geometry world = unused.isEmpty() ? world() : unused.remove(unused.size() - 1);
        if (!world.addObjectUnchecked(object)) {
            throw new IllegalStateException("object must fit into the world (got: " + object + ")");
        }
        objects.add(object);
        alone.add(world);
    }

    void remove(int k) {
        alone.get(k).removeObject(name(k));
        objects.remove(k);
        unused.add(alone.remove(k));
    }

    void clear() {
        while (!objects.isEmpty()) {
            remove(objects.size() - 1);
        }
    }

    void replace(int k, GeometryObject object) {
        if (!alone.get(k).removeObject(name(k)) || !alone.get(k).addObjectUnchecked(object)) {
            throw new IllegalStateException("object must fit into the world (got: " + object + ")");
        }
        objects.set(k, object);
    }

    /** Puts the objects into another order. */
    void shuffle(SplittableRandom random) {
        for (int k = objects.size() - 1; k > 0; k--) {
            int other = random.nextInt(k + 1);
            Collections.swap(objects, k, other);
            Collections.swap(alone, k, other);
        }
    }

    /** Whether an object is within the border. */
    boolean fits(GeometryObject object) {
        boolean fits = empty.addObjectUnchecked(object);
        return fits && empty.removeObject(String.valueOf(object.name()));
    }

    boolean test(GeometryObject object, Accuracy at) {
        return !touched(object, at, -1).isEmpty();
    }

    /** The objects, but for one, that an object touches. */
    BitSet touched(GeometryObject object, Accuracy at, int but) {
        BitSet touched = new BitSet();
        for (int k = 0; k < objects.size(); k++) {
            if (k != but && isNear(object, objects.get(k), 0) && alone.get(k).testObject(object, at)) {
                touched.set(k);
            }
        }
        return touched;
    }

    double ray(Ray ray, double min, double max, double width, Accuracy at) {
        double least = INFINITE;
        for (Geometry world : alone) {
            least = Math.min(least, world.getRayDistance(ray, min, max, width, at));
        }
        return least;
    }

    /** The distance to the nearest but one. */
    double ray(Ray ray, double min, double max, double width, int but) {
        double least = INFINITE;
        for (int k = 0; k < alone.size(); k++) {
            if (k != but) {
                least = Math.min(least, alone.get(k).getRayDistance(ray, min, max, width));
            }
        }
        return least;
    }

    @Nullable
    RayHit cast(Ray ray, double max) {
        RayHit first = null;
        for (Geometry world : alone) {
            RayHit hit = world.castRay(ray, max);
            if (hit != null && (first == null || hit.distance() < first.distance())) {
                first = hit;
            }
        }
        return first;
    }

    double sonar(int own, Ray mount, double min, double max, double width) {
        String name = name(own);
        Point from = mount.start();
        double far = max + 2 * length(from.x(), from.y(), from.z());
        double least = INFINITE;
        for (int k = 0; k < objects.size(); k++) {
            if (k != own && isNear(objects.get(own), objects.get(k), far)) {
                least = Math.min(least, beside(k, own, pair -> pair.getSonarDistance(name, mount, min, max, width)));
            }
        }
        return least;
    }

    double[] scan(int own, double first, double step, int count, double min, double max) {
        double[] least = new double[count];
        Arrays.fill(least, INFINITE);
        for (int k = 0; k < objects.size(); k++) {
            if (k != own && isNear(objects.get(own), objects.get(k), max)) {
                double[] one = beside(k, own, pair -> pair.scan(name(own), first, step, count, min, max));
                Arrays.setAll(least, ray -> Math.min(least[ray], one[ray]));
            }
        }
        return least;
    }

    double proximity(int own, double max) {
        String name = name(own);
        double least = INFINITE;
        for (int k = 0; k < objects.size(); k++) {
            if (k != own && isNear(objects.get(own), objects.get(k), Math.min(least, max))) {
                least = Math.min(least, beside(k, own, pair -> pair.getProximity(name, max)));
            }
        }
        return least;
    }

    /** Whether two may be within a distance of each other; true in doubt. */
    boolean isNear(GeometryObject a, GeometryObject b, double distance) {
        return isNear(a, STILL, b, distance);
    }

    /** The same anywhere on a way of the first. */
    private boolean isNear(GeometryObject a, Point way, GeometryObject b, double distance) {
        Point p = a.center();
        Point q = b.center();
        boolean flat = dimension == Dimension.PLANAR;
        double dx = q.x() - p.x();
        double dy = flat ? 0 : q.y() - p.y();
        double dz = q.z() - p.z();
        double wy = flat ? 0 : way.y();
        double square = way.x() * way.x() + wy * wy + way.z() * way.z();
        double along = square == 0 ? 0 : (dx * way.x() + dy * wy + dz * way.z()) / square;
        double share = Math.max(0, Math.min(1, along));
        dx -= share * way.x();
        dy -= share * wy;
        dz -= share * way.z();
        double gap = Math.sqrt(dx * dx + dy * dy + dz * dz);
        return gap <= 1.001 * distance + WIDE * (reach(a) + reach(b)) + 1e-9;
    }

    /** How far an object reaches from its centre at most. */
    private static double reach(GeometryObject object) {
        return switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                yield 0.51 * length(box.width(), box.height(), box.length());
            }
            case CYLINDER -> {
                CylinderObject cylinder = (CylinderObject) object;
                yield 1.01 * length(cylinder.radius(), cylinder.height() / 2, 0);
            }
            case SPHERE -> ((SphereObject) object).radius();
            case CAPSULE -> 1.01 * (((CapsuleObject) object).radius() + ((CapsuleObject) object).segment() / 2);
            case MESH -> {
                double most = 0;
                for (Point v : ((MeshObject) object).vertices()) {
                    most = Math.max(most, 1.01 * length(v.x(), v.y(), v.z()));
                }
                yield most;
            }
            case GRID -> throw new IllegalArgumentException("no grids here (got: " + object + ")");
            case GROUP -> {
                double most = 0;
                for (GeometryObject member : ((ObjectGroup) object).members()) {
                    Point c = member.center();
                    most = Math.max(most, 1.01 * length(c.x(), c.y(), c.z()) + reach(member));
                }
                yield most;
            }
        };
    }

    private static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }

    String name(int k) {
        return String.valueOf(objects.get(k).name());
    }

    /** What is answered where an object has one other beside it; with -1 none. */
    private <T> T beside(int k, int own, Function<Geometry, T> question) {
        Geometry pair = k < 0 ? empty : alone.get(k);
        if (!pair.addObjectUnchecked(objects.get(own))) {
            throw new IllegalStateException("object must fit into the world (got: " + objects.get(own) + ")");
        }
        T answer = question.apply(pair);
        pair.removeObject(name(own));
        return answer;
    }

    /** What of a move is free, what blocks it first and where, and where the object stands then. */
    record Free(
            boolean allowed,
            double fraction,
            double turnFraction,
            @Nullable GeometryObject obstacle,
            @Nullable Point contact,
            @Nullable Point normal,
            GeometryObject end) {
        static Free of(MoveResult result, GeometryObject end) {
            return new Free(
                    result.allowed(),
                    result.fraction(),
                    result.turnFraction(),
                    result.obstacle(),
                    result.contact(),
                    result.normal(),
                    end);
        }

        /** Where only the verdict is told. */
        static Free of(boolean allowed, GeometryObject end) {
            return new Free(allowed, allowed ? 1 : 0, allowed ? 1 : 0, null, null, null, end);
        }

        /** The same with another contact. */
        Free withContactOf(Free other) {
            return new Free(allowed, fraction, turnFraction, obstacle, other.contact, other.normal, end);
        }

        int compareTo(Free other) {
            int order = Boolean.compare(allowed, other.allowed);
            order = order != 0 ? order : Double.compare(fraction, other.fraction);
            return order != 0 ? order : Double.compare(turnFraction, other.turnFraction);
        }
    }

    /** A motion of an object in a world. */
    interface Motion {
        Free in(Geometry world, String name);
    }

    Free move(int own, Move move) {
        return move(own, way(own, move), 0, (world, name) -> Free.of(world.move(name, move), world.getObject(name)));
    }

    /** How many objects blocked the last {@link #move} at the least fraction. */
    int equals() {
        return equals;
    }

    /**
     * The least that is free beside each other object alone; of equal ones the first, and any before the border.
     *
     * @param way       where the object goes along the world's axes
     * @param clearance how far it stays away from things
     */
    Free move(int own, Point way, double clearance, Motion motion) {
        equals = 0;
        Free least = beside(-1, own, pair -> motion.in(pair, name(own)));
        for (int k = 0; k < objects.size(); k++) {
            if (k != own && isNear(objects.get(own), way, objects.get(k), clearance)) {
                Free one = beside(k, own, pair -> motion.in(pair, name(own)));
                int order = one.compareTo(least);
                equals = order < 0 ? 1 : order == 0 && one.obstacle() != null ? equals + 1 : equals;
                if (order < 0 || (order == 0 && least.obstacle() == null && one.obstacle() != null)) {
                    least = one;
                }
            }
        }
        return least;
    }

    /**
     * The same where each other object has some beside it, always the same ones: what an object stands on may let it pass
     * others.
     */
    Free moveBeside(BitSet ground, int own, Point way, double clearance, Motion motion) {
        Free least = null;
        for (int k = 0; k < objects.size(); k++) {
            if (k == own || !isNear(objects.get(own), way, objects.get(k), clearance)) {
                continue;
            }
            Geometry few = world();
            for (int j = 0; j < objects.size(); j++) {
                if ((j == k || j == own || ground.get(j)) && !few.addObjectUnchecked(objects.get(j))) {
                    throw new IllegalStateException("object must fit into the world (got: " + objects.get(j) + ")");
                }
            }
            Free one = motion.in(few, name(own));
            int order = least == null ? -1 : one.compareTo(least);
            if (order < 0 || (order == 0 && least != null && place(one) < place(least))) {
                least = one;
            }
        }
        return least == null ? move(own, way, clearance, motion) : least;
    }

    /** The place in the list of what blocks, with the border last. */
    private int place(Free free) {
        GeometryObject blocks = free.obstacle();
        for (int k = 0; blocks != null && k < objects.size(); k++) {
            if (name(k).equals(blocks.name())) {
                return k;
            }
        }
        return Integer.MAX_VALUE;
    }

    /** Where an object is after a way on which nothing blocks. */
    GeometryObject after(GeometryObject object, Point way) {
        empty.addObjectUnchecked(object);
        String name = String.valueOf(object.name());
        empty.moveGlobal(name, new Move(way.x(), way.y(), way.z(), 0, 0));
        GeometryObject there = empty.getObject(name);
        empty.removeObject(name);
        return there;
    }

    /** Where a move along an object's own axes leads along the world's. */
    Point way(int own, Move move) {
        double[] r = objects.get(own).rotation();
        return new Point(
                r[0] * move.x() + r[1] * move.y() + r[2] * move.z(),
                r[3] * move.x() + r[4] * move.y() + r[5] * move.z(),
                r[6] * move.x() + r[7] * move.y() + r[8] * move.z());
    }

    /** The same beside one other object. */
    Free beside(@Nullable String other, int own, Motion motion) {
        for (int k = 0; k < objects.size(); k++) {
            if (name(k).equals(other)) {
                return beside(k, own, pair -> motion.in(pair, name(own)));
            }
        }
        return beside(-1, own, pair -> motion.in(pair, name(own)));
    }
}
