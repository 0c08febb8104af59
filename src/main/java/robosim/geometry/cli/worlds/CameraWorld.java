package robosim.geometry.cli.worlds;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.check.Text;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.Lighting;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.shared.Floor;
import robosim.geometry.world.shared.Placement;

/** A world as a camera sees it: with heights, whatever its dimension is, and on a floor. */
final class CameraWorld {
    /** A light and warm grey, on which shadows show. */
    private static final Color LIGHT = Color.parse("#d8d4cb");

    /** How much darker every other tile is: enough to tell sizes and distances, too little to draw attention. */
    private static final double DARKER = 0.96;

    /** About so many tiles lie along the world. */
    private static final int TILES = 24;

    /** The floor reaches beyond what stands on it by this share. */
    private static final double RIM = 0.04;

    /** How far a wide ground reaches, in sizes of the world: its edge is within a pixel of the horizon. */
    private static final double HORIZON = 400;

    private final World world;
    private final Geometry geometry;
    private final Bounds content;
    private final List<GeometryObject> shown;
    private final Map<GeometryObject, Integer> numbers = new HashMap<>();

    /** What lies under the lowest object. */
    enum Ground {
        NONE,
        /** Slightly larger than what stands on it. */
        FLOOR,
        /** As far as one can see. */
        WIDE
    }

    CameraWorld(World world, Ground ground) {
        this.world = world;
        // A floor that fills the world has no part in its picture, where other things stand on it.
        List<GeometryObject> standing = world.objects().stream()
                .map(WorldObject::object)
                .filter(object -> !Floor.isFloor(object, world.width(), world.length()))
                .<GeometryObject>mapMulti(CameraWorld::see)
                .toList();
        shown = standing.isEmpty()
                ? world.objects().stream()
                        .map(WorldObject::object)
                        .<GeometryObject>mapMulti(CameraWorld::see)
                        .toList()
                : standing;
        List<Bounds> boxes = shown.stream().map(GeometryObject::bounds).toList();
        content = boxes.isEmpty()
                ? empty(world)
                : boxes.stream().reduce(Bounds::and).orElseThrow();
        double most = 2 * Math.max(largest(content), Math.max(world.width(), Math.max(world.height(), world.length())));
        double side = 4 * most * (ground == Ground.WIDE ? HORIZON : 1);
        geometry = new Geometry(side, side, side, Dimension.SPATIAL, world.accuracy());
        boolean isLaid = ground == Ground.NONE;
        for (WorldObject object : world.objects()) {
            GeometryObject seen = object.object().seen();
            if (ground == Ground.WIDE && seen instanceof BoxObject box && isGround(box)) {
                seen = wide(box, HORIZON * most, tile());
                isLaid = true;
            }
            if (seen != null) {
                geometry.addObjectUnchecked(seen);
                numbers.put(seen, numbers.size() + 1);
            }
        }
        world.scenery().forEach(geometry::addObjectUnchecked);
        if (!isLaid) {
            geometry.addObjectUnchecked(laid(ground, most));
        }
    }

    /** The side of a tile: 1, 2 or 5 times a power of ten. */
    private double tile() {
        double least = Math.max(content.maxX() - content.minX(), content.maxZ() - content.minZ()) / TILES;
        double ten = 1e-6;
        while (10 * ten <= least) {
            ten *= 10;
        }
        return least <= ten ? ten : least <= 2 * ten ? 2 * ten : least <= 5 * ten ? 5 * ten : 10 * ten;
    }

    /** Whether a box is what an infinite plane became, or the lowest floor and without a look of its own, and is no ceiling. */
    private boolean isGround(BoxObject box) {
        boolean isPlane = box.height() == Floor.THICKNESS;
        return Floor.isFloor(box, world.width(), world.length())
                && (isPlane || box.material().isDefault())
                && box.material().texture() == null
                && box.bounds().maxY()
                        <= (isPlane ? content.maxY() : middle(content).y());
    }

    /** A floor that reaches as far as one can see, in tiles of its own colour, of which one begins at the origin. */
    private static BoxObject wide(BoxObject floor, double reach, double tile) {
        double side = 4 * tile * Math.ceil(reach / (2 * tile));
        Material own = floor.material().isDefault() ? Material.of(LIGHT).withSpecular(0) : floor.material();
        Color color = own.color();
        Color darker = new Color(DARKER * color.red(), DARKER * color.green(), DARKER * color.blue());
        return Floor.filling(floor, side, side).withMaterial(own.withTexture(new Texture.Checker(color, darker, tile)));
    }

    /** What all stands on. */
    private BoxObject laid(Ground ground, double most) {
        double width = content.maxX() - content.minX();
        double length = content.maxZ() - content.minZ();
        double rim = RIM * Math.max(width, length);
        double thick = Math.max(rim, (content.maxY() - content.minY()) / 20) / 2;
        Point middle = middle(content);
        Point center = new Point(middle.x(), content.minY() - thick / 2, middle.z());
        BoxObject floor = new BoxObject(center, width + 2 * rim, thick, length + 2 * rim);
        return ground == Ground.WIDE ? wide(floor, HORIZON * most, tile()) : floor;
    }

    private static void see(GeometryObject object, Consumer<GeometryObject> seen) {
        GeometryObject look = object.seen();
        if (look != null) {
            seen.accept(look);
        }
    }

    private static Bounds empty(World world) {
        double x = world.width() / 2;
        double z = world.length() / 2;
        double y = -world.height() / 2;
        return new Bounds(-x, y, -z, x, y, z);
    }

    private static double largest(Bounds box) {
        double low = Math.max(Math.abs(box.minX()), Math.max(Math.abs(box.minY()), Math.abs(box.minZ())));
        return Math.max(low, Math.max(Math.abs(box.maxX()), Math.max(Math.abs(box.maxY()), Math.abs(box.maxZ()))));
    }

    static Point middle(Bounds box) {
        return new Point(
                box.minX() / 2 + box.maxX() / 2, box.minY() / 2 + box.maxY() / 2, box.minZ() / 2 + box.maxZ() / 2);
    }

    /** The box that holds all objects. */
    Bounds content() {
        return content;
    }

    /** Points that all objects lie between, as seen from anywhere; few, except for a mesh that is alone. */
    List<Point> outline() {
        if (shown.isEmpty()) {
            return content.corners();
        }
        List<Point> points = new ArrayList<>();
        for (GeometryObject object : shown) {
            if (shown.size() == 1 && object instanceof MeshObject mesh) {
                double[] place = new double[Pose.PLACE];
                mesh.pose().place(place, 0);
                TriangleMesh surface = mesh.triangles();
                for (int k = 0; k < surface.vertices(); k++) {
                    points.add(new Point(
                            surface.placed(k, 0, place, 0),
                            surface.placed(k, 1, place, 0),
                            surface.placed(k, 2, place, 0)));
                }
            } else {
                points.addAll(object.bounds().corners());
            }
        }
        return points;
    }

    /** The scale of what hides the sky: a part of the world, so that rooms are not dark. */
    double skyReach() {
        double x = content.maxX() - content.minX();
        double z = content.maxZ() - content.minZ();
        double most = Math.max(x, z) / 8;
        return most > 0 ? most : 1;
    }

    /** The light of the world. */
    Lighting light() {
        return world.light();
    }

    /** The object of a name; null if there is none. */
    @Nullable
    GeometryObject find(String name) {
        return geometry.hasObject(name) ? geometry.getObject(name) : null;
    }

    /** The names of all that can carry a camera. */
    List<String> carriers() {
        return world.objects().stream()
                .map(WorldObject::object)
                .filter(GeometryObject::isMoveable)
                .map(object -> String.valueOf(object.name()))
                .toList();
    }

    /** What a name may be, in words. */
    String choice(String given) {
        List<String> all = carriers();
        return all.isEmpty() ? "which has none: add one with the command add" : Text.choice(given, all);
    }

    /** The number of an object in the world, from 1; 0 for the floor, which is none. */
    int number(GeometryObject object) {
        return numbers.getOrDefault(object, 0);
    }

    /** How high above its own origin an object of a name reaches. */
    double top(String name) {
        GeometryObject object = geometry.getObject(name);
        return object.bounds().maxY() - object.center().y();
    }

    Pose pose(ColorCamera camera) {
        String carrier = camera.carrier();
        if (carrier == null) {
            return camera.pose();
        }
        Pose robot = geometry.getObject(carrier).pose();
        Placement on = Placement.turned(robot.center(), robot.rotation());
        Pose mount = camera.pose();
        return on.then(Placement.turned(mount.center(), mount.rotation())).pose();
    }

    /** How far the middle of the world is from a camera. */
    double depth(ColorCamera camera) {
        Point eye = pose(camera).center();
        Point middle = middle(content);
        return VectorMath.length(eye.x() - middle.x(), eye.y() - middle.y(), eye.z() - middle.z());
    }

    Snapshot snapshot() {
        return geometry.snapshot();
    }
}
