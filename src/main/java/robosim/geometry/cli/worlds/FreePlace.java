package robosim.geometry.cli.worlds;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/**
 * A place near another one at which a robot may stand. Tried are the places of a square grid about the one asked for, the nearest
 * first: a fine grid, and then one that is ten times as coarse, so that the numbers are short and the search is bounded.
 */
final class FreePlace {
    /** How many steps of the grid the farthest place is away. */
    private static final int REACH = 30;

    private static final int GRIDS = 2;

    /** An offset in steps of the grid. */
    private record Offset(int x, int z) {
        int square() {
            return x * x + z * z;
        }
    }

    private final Geometry geometry;
    private final GeometryObject robot;

    /** The closed surfaces in which the place asked for is not: where one of them has room for a robot, it could not leave. */
    private final List<GeometryObject> closed = new ArrayList<>();

    /** Begins a search for a robot that is a little larger than the real one, so that this can move. */
    FreePlace(Geometry geometry, GeometryObject robot) {
        this.geometry = geometry;
        this.robot = robot;
        SphereObject middle = new SphereObject(robot.center(), 0);
        for (GeometryObject object : geometry.objects()) {
            if (object instanceof MeshObject mesh && !mesh.isSolid()) {
                GeometryObject solid = solid(mesh);
                if (solid != null && !CollisionDetection.intersects(solid, middle)) {
                    closed.add(solid);
                }
            }
        }
    }

    private static @Nullable GeometryObject solid(MeshObject mesh) {
        try {
            return mesh.solid();
        } catch (IllegalArgumentException e) {
            return null; // it is open
        }
    }

    /**
     * The nearest place tried that is free, as X,Z for a command line; null if none is.
     *
     * @param x    as it was asked for
     * @param size of the robot, on the floor
     */
    @Nullable
    String find(String x, String z, double size) {
        int digits = size > 0 ? -(int) Math.floor(Math.log10(size / 2)) : 0;
        BigDecimal step = BigDecimal.ONE.movePointLeft(digits);
        BigDecimal fromX = new BigDecimal(x).setScale(digits, RoundingMode.HALF_EVEN);
        BigDecimal fromZ = new BigDecimal(z).setScale(digits, RoundingMode.HALF_EVEN);
        List<Offset> offsets = offsets();
        for (int grid = 0; grid < GRIDS; grid++) {
            for (Offset offset : offsets) {
                BigDecimal atX = moved(fromX, offset.x, step);
                BigDecimal atZ = moved(fromZ, offset.z, step);
                if (isFree(new Point(atX.doubleValue(), robot.center().y(), atZ.doubleValue()))) {
                    return text(atX) + "," + text(atZ);
                }
            }
            step = step.movePointRight(1);
        }
        return null;
    }

    private static List<Offset> offsets() {
        List<Offset> offsets = new ArrayList<>();
        for (int i = -REACH; i <= REACH; i++) {
            for (int j = -REACH; j <= REACH; j++) {
                Offset offset = new Offset(i, j);
                if (offset.square() <= REACH * REACH) {
                    offsets.add(offset);
                }
            }
        }
        offsets.sort(Comparator.comparingInt(Offset::square));
        return offsets;
    }

    private static BigDecimal moved(BigDecimal from, int steps, BigDecimal step) {
        return from.add(step.multiply(BigDecimal.valueOf(steps)));
    }

    private static String text(BigDecimal number) {
        return number.signum() == 0 ? "0" : number.stripTrailingZeros().toPlainString();
    }

    private boolean isFree(Point place) {
        GeometryObject there = robot.movedTo(place);
        return geometry.search().fits(there)
                && !geometry.testObject(there)
                && closed.stream().noneMatch(each -> CollisionDetection.intersects(each, there));
    }
}
