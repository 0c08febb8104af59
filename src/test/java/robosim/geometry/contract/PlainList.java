package robosim.geometry.contract;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.RayHit;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** A world without any index: every object stands alone in a world of its own, and all of them are asked. */
final class PlainList {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private final double size;
    private final Dimension dimension;
    private final Accuracy accuracy;
    private final List<GeometryObject> objects = new ArrayList<>();
    private final List<Geometry> alone = new ArrayList<>();

    /** The world's border alone. */
    private final Geometry empty;

    PlainList(double size, Dimension dimension, Accuracy accuracy) {
        this.size = size;
        this.dimension = dimension;
        this.accuracy = accuracy;
        empty = world();
    }

    private Geometry world(GeometryObject... those) {
        Geometry world = new Geometry(size, size, size, dimension, accuracy);
        for (GeometryObject each : those) {
            if (!world.addObjectUnchecked(each)) {
                throw new IllegalStateException("object must fit into the world (got: " + each + ")");
            }
        }
        return world;
    }

    List<GeometryObject> objects() {
        return objects;
    }

    void add(GeometryObject object) {
        objects.add(object);
        alone.add(world(object));
    }

    void remove(int k) {
        objects.remove(k);
        alone.remove(k);
    }

    void replace(int k, GeometryObject object) {
        if (!alone.get(k).removeObject(name(k)) || !alone.get(k).addObjectUnchecked(object)) {
            throw new IllegalStateException("object must fit into the world (got: " + object + ")");
        }
        objects.set(k, object);
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
            if (k != but && alone.get(k).testObject(object, at)) {
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
        return least(own, pair -> pair.getSonarDistance(name, mount, min, max, width));
    }

    double[] scan(int own, double first, double step, int count, double min, double max) {
        double[] least = new double[count];
        Arrays.fill(least, INFINITE);
        for (int k = 0; k < objects.size(); k++) {
            if (k != own) {
                double[] one = beside(k, own, pair -> pair.scan(name(own), first, step, count, min, max));
                Arrays.setAll(least, ray -> Math.min(least[ray], one[ray]));
            }
        }
        return least;
    }

    double proximity(int own, double max) {
        String name = name(own);
        return least(own, pair -> pair.getProximity(name, max));
    }

    String name(int k) {
        return String.valueOf(objects.get(k).name());
    }

    private double least(int own, ToDoubleFunction<Geometry> question) {
        double least = INFINITE;
        for (int k = 0; k < objects.size(); k++) {
            if (k != own) {
                least = Math.min(least, beside(k, own, question::applyAsDouble));
            }
        }
        return least;
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

        private int compareTo(Free other) {
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
        return move(own, (world, name) -> Free.of(world.move(name, move), world.getObject(name)));
    }

    /** The least that is free beside each other object alone; of equal ones the first, and any before the border. */
    Free move(int own, Motion motion) {
        Free least = beside(-1, own, pair -> motion.in(pair, name(own)));
        for (int k = 0; k < objects.size(); k++) {
            if (k != own) {
                Free one = beside(k, own, pair -> motion.in(pair, name(own)));
                int order = one.compareTo(least);
                if (order < 0 || (order == 0 && least.obstacle() == null && one.obstacle() != null)) {
                    least = one;
                }
            }
        }
        return least;
    }
}
