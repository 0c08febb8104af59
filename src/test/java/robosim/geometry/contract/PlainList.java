package robosim.geometry.contract;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.RayHit;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Ray;

/** A world without any index: every object stands alone in a world of its own, and all of them are asked. */
final class PlainList {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private final double size;
    private final Dimension dimension;
    private final Accuracy accuracy;
    private final List<GeometryObject> objects = new ArrayList<>();
    private final List<Geometry> alone = new ArrayList<>();

    PlainList(double size, Dimension dimension, Accuracy accuracy) {
        this.size = size;
        this.dimension = dimension;
        this.accuracy = accuracy;
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
        objects.set(k, object);
        alone.set(k, world(object));
    }

    boolean test(GeometryObject object, Accuracy at) {
        return alone.stream().anyMatch(world -> world.testObject(object, at));
    }

    double ray(Ray ray, double min, double max, double width, Accuracy at) {
        return alone.stream()
                .mapToDouble(world -> world.getRayDistance(ray, min, max, width, at))
                .min()
                .orElse(INFINITE);
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
        double least = INFINITE;
        for (int k = 0; k < objects.size(); k++) {
            if (k != own) {
                Geometry pair = world(objects.get(own), objects.get(k));
                String name = String.valueOf(objects.get(own).name());
                least = Math.min(least, pair.getSonarDistance(name, mount, min, max, width));
            }
        }
        return least;
    }

    double proximity(int own, double max) {
        double least = INFINITE;
        for (int k = 0; k < objects.size(); k++) {
            if (k != own) {
                Geometry pair = world(objects.get(own), objects.get(k));
                least = Math.min(
                        least, pair.getProximity(String.valueOf(objects.get(own).name()), max));
            }
        }
        return least;
    }

    /** What of a move is free beside each other object, and what blocks it first. */
    record Free(
            boolean allowed,
            double fraction,
            double turnFraction,
            @Nullable GeometryObject obstacle) {}

    Free move(int own, Move move) {
        Free least = new Free(true, 1, 1, null);
        for (int k = 0; k < objects.size(); k++) {
            if (k != own) {
                Geometry pair = world(objects.get(own), objects.get(k));
                MoveResult result = pair.move(String.valueOf(objects.get(own).name()), move);
                least = lesser(least, result);
            }
        }
        return least;
    }

    private static Free lesser(Free least, MoveResult result) {
        if (result.allowed()) {
            return least;
        }
        boolean isLess = least.allowed()
                || result.fraction() < least.fraction()
                || (result.fraction() == least.fraction() && result.turnFraction() < least.turnFraction());
        return isLess ? new Free(false, result.fraction(), result.turnFraction(), result.obstacle()) : least;
    }
}
