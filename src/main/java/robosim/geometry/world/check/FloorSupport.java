package robosim.geometry.world.check;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** What robots stand on, where heights count, or that they stand on nothing. */
final class FloorSupport {
    /** The least upward part of the normal of a contact with what carries a robot: it is not steeper than 45 degrees. */
    private static final double CARRIES = Math.sqrt(0.5);

    /** How deep a robot may be in what carries it, as a part of its height: rounding, and models whose wheels are. */
    private static final double SUNK = 1.0 / 64;

    /** How far above its floor a robot is tested, as a part of its height. */
    private static final double RAISED = 1.0 / 1024;

    private FloorSupport() {}

    /** Whether a robot just stands on something static, which hinders it in nothing. */
    static boolean isStanding(Overlap overlap) {
        return overlap.isStart()
                && !overlap.second().object().isMoveable()
                && overlap.normal().y() >= CARRIES
                && overlap.depth() <= SUNK * height(overlap.first().object());
    }

    private static double height(GeometryObject object) {
        Bounds bounds = object.bounds();
        return bounds.maxY() - bounds.minY();
    }

    /** A world in which each robot that stands on something is slightly above it. */
    static World raised(World world, List<Overlap> overlaps) {
        IdentityHashMap<WorldObject, Double> up = new IdentityHashMap<>();
        for (Overlap each : overlaps) {
            if (isStanding(each)) {
                double raise = each.depth() + RAISED * height(each.first().object());
                if (each.first().object().bounds().maxY() + raise <= world.height() / 2) {
                    up.merge(each.first(), raise, Math::max);
                }
            }
        }
        if (up.isEmpty()) {
            return world;
        }
        List<WorldObject> objects = new ArrayList<>(world.objects().size());
        for (WorldObject each : world.objects()) {
            Double raise = up.get(each);
            objects.add(raise == null ? each : raised(each, raise));
        }
        return world.withObjects(objects);
    }

    private static WorldObject raised(WorldObject robot, double raise) {
        GeometryObject object = robot.object();
        Point center = object.center();
        return new WorldObject(
                object.movedTo(new Point(center.x(), center.y() + raise, center.z())),
                robot.color(),
                robot.sonars(),
                robot.body(),
                robot.attached());
    }

    /** The falls of robots below which there is nothing but the lower border. */
    static List<WorldCheck.Fall> falls(World world) {
        List<WorldCheck.Fall> falls = new ArrayList<>();
        if (world.dimension() == Dimension.PLANAR) {
            return falls;
        }
        Geometry geometry = world.toGeometry(refused -> {});
        for (WorldObject each : world.objects()) {
            String name = each.object().name();
            if (each.object().isMoveable() && name != null && geometry.hasObject(name)) {
                double most = world.height();
                MoveResult down = geometry.moveGlobal(name, new Move(0, -most, 0, 0, 0));
                double drop = down.fraction() * most;
                if (down.obstacle() == null && drop > height(each.object())) {
                    falls.add(new WorldCheck.Fall(each, drop));
                }
            }
        }
        return falls;
    }
}
