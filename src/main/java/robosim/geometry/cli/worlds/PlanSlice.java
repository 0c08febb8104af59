package robosim.geometry.cli.worlds;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.RoundedBox;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.viewer.scene.Footprint;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/**
 * A world as a level plane cuts it, for a plan: of each object that the plane meets its section, of the others nothing. For
 * pictures, in plain doubles; the section of a mesh is the lines in which the plane meets its faces.
 */
final class PlanSlice {
    /** Corners of a round section of what does not stand upright. */
    private static final int RIM = 64;

    private final double height;

    /** How high the upright faces are that stand for lines. */
    private final double thin;

    private PlanSlice(double height, double thin) {
        this.height = height;
        this.thin = thin;
    }

    /** The sections of a world's objects at a height, as a world of the same size. */
    static World of(World world, double height) {
        PlanSlice slice = new PlanSlice(height, world.height() / (1 << 20));
        List<WorldObject> objects = new ArrayList<>();
        for (WorldObject each : world.objects()) {
            GeometryObject section = slice.section(each.object());
            if (section != null) {
                objects.add(new WorldObject(section, each.color(), List.of()));
            }
        }
        return world.withObjects(objects);
    }

    /**
     * The sections of a scene's objects at a height; what happened there, and what blocked recent moves, stays.
     *
     * @param tall the height of the world
     */
    static Scene of(Scene scene, double tall, double height) {
        PlanSlice slice = new PlanSlice(height, tall / (1 << 20));
        List<Scene.Thing> things = new ArrayList<>();
        for (Scene.Thing each : scene.things()) {
            GeometryObject section = slice.section(each.object());
            if (section != null) {
                things.add(new Scene.Thing(section, each.colour()));
            }
        }
        return scene.showing(things);
    }

    /** With the name of the object, moveable if that is, and of its material; null where the plane does not meet it. */
    private @Nullable GeometryObject section(GeometryObject object) {
        Bounds box = object.bounds();
        if (!(box.minY() <= height && height <= box.maxY())) {
            return null;
        }
        GeometryObject section = shape(object);
        if (section == null) {
            return null;
        }
        section = section.withMaterial(object.material());
        String name = object.name();
        return name == null ? section : object.isMoveable() ? section.moveable(name) : section.named(name);
    }

    private @Nullable GeometryObject shape(GeometryObject object) {
        if (object instanceof ObjectGroup group) {
            return group(group);
        }
        if (object instanceof MeshObject mesh) {
            return lines(mesh.triangles(), mesh.pose());
        }
        if (object instanceof GridObject) {
            return object;
        }
        RoundedBox box = object.roundedBox();
        Pose pose = object.pose();
        if (box.ball() > 0) {
            return capsule(box, pose);
        }
        return pose.isUpright() ? object : box.disc() > 0 ? cylinder(box, pose) : box(box, pose);
    }

    private @Nullable GeometryObject group(ObjectGroup group) {
        List<GeometryObject> sections = new ArrayList<>();
        for (GeometryObject part : group.parts()) {
            GeometryObject section = section(part.at(part.pose().within(group.pose())));
            if (section != null) {
                sections.add(section);
            }
        }
        return sections.isEmpty() ? null : new ObjectGroup(sections);
    }

    private @Nullable GeometryObject disc(Point center, double radius) {
        double off = height - center.y();
        return Math.abs(off) > radius
                ? null
                : new CylinderObject(
                        new Point(center.x(), height, center.z()), Math.sqrt((radius - off) * (radius + off)), 0);
    }

    private @Nullable GeometryObject capsule(RoundedBox capsule, Pose pose) {
        double half = capsule.halfHeight();
        if (pose.isUpright() || half == 0) {
            double y = Math.max(-half, Math.min(half, height - pose.center().y()));
            Point c = pose.center();
            return disc(new Point(c.x(), c.y() + y, c.z()), capsule.ball());
        }
        List<double[]> rims = new ArrayList<>();
        for (int k = 0; k <= RIM; k++) {
            double[] at = at(pose, 0, half * (2.0 * k / RIM - 1), 0);
            double off = height - at[1];
            double squared = (capsule.ball() - off) * (capsule.ball() + off);
            for (int corner = 0; squared >= 0 && corner < RIM; corner++) {
                double[] to = direction(corner);
                rims.add(new double[] {at[0] + Math.sqrt(squared) * to[0], at[2] + Math.sqrt(squared) * to[1]});
            }
        }
        return polygon(rims);
    }

    private @Nullable GeometryObject box(RoundedBox box, Pose pose) {
        double[][] corners = new double[8][];
        for (int k = 0; k < 8; k++) {
            corners[k] = at(pose, box.corner(k, 0), box.corner(k, 1), box.corner(k, 2));
        }
        List<double[]> met = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            for (int axis = 1; axis < 8; axis *= 2) {
                if ((k & axis) == 0) {
                    cut(corners[k], corners[k | axis], met);
                }
            }
        }
        return polygon(met);
    }

    private @Nullable GeometryObject cylinder(RoundedBox cylinder, Pose pose) {
        List<double[]> met = new ArrayList<>();
        double half = cylinder.halfHeight();
        for (int k = 0; k < RIM; k++) {
            double[] from = direction(k);
            double[] to = direction(k + 1);
            double r = cylinder.disc();
            double[] low = at(pose, r * from[0], -half, r * from[1]);
            double[] high = at(pose, r * from[0], half, r * from[1]);
            cut(low, high, met);
            cut(low, at(pose, r * to[0], -half, r * to[1]), met);
            cut(high, at(pose, r * to[0], half, r * to[1]), met);
        }
        return polygon(met);
    }

    private static double[] direction(int corner) {
        double angle = 2 * Math.PI * corner / RIM;
        return new double[] {StrictMath.cos(angle), StrictMath.sin(angle)};
    }

    private static double[] at(Pose pose, double x, double y, double z) {
        double[] at = {pose.center().x(), pose.center().y(), pose.center().z()};
        for (int row = 0; row < 3; row++) {
            at[row] += pose.rotation(3 * row) * x + pose.rotation(3 * row + 1) * y + pose.rotation(3 * row + 2) * z;
        }
        return at;
    }

    /** Adds where the plane meets an edge, as X and Z. */
    private void cut(double[] a, double[] b, List<double[]> met) {
        double below = height - a[1];
        double rise = b[1] - a[1];
        if (rise == 0) {
            if (below == 0) {
                met.add(new double[] {a[0], a[2]});
                met.add(new double[] {b[0], b[2]});
            }
        } else if (below / rise >= 0 && below / rise <= 1) {
            double share = below / rise;
            met.add(new double[] {a[0] + share * (b[0] - a[0]), a[2] + share * (b[2] - a[2])});
        }
    }

    /** The flat convex hull of points of the plane. */
    private @Nullable GeometryObject polygon(List<double[]> points) {
        if (points.isEmpty()) {
            return null;
        }
        double[] hull =
                Footprint.hull(points.stream().flatMapToDouble(Arrays::stream).toArray());
        List<Point> corners = new ArrayList<>();
        for (int k = 0; k < hull.length; k += 2) {
            corners.add(new Point(hull[k], height, hull[k + 1]));
        }
        int[][] faces = new int[Math.max(1, corners.size() - 2)][];
        for (int k = 0; k < faces.length; k++) {
            faces[k] = new int[] {0, Math.min(k + 1, corners.size() - 1), Math.min(k + 2, corners.size() - 1)};
        }
        return new MeshObject(corners, faces);
    }

    /** The lines in which the plane meets the faces of a mesh, each as an upright face of hardly any height. */
    private @Nullable GeometryObject lines(TriangleMesh mesh, Pose pose) {
        List<Point> corners = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (int t = 0; t < mesh.size(); t++) {
            double[][] triangle = new double[3][];
            for (int k = 0; k < 3; k++) {
                int v = mesh.vertex(t, k);
                triangle[k] = at(pose, mesh.coordinate(v, 0), mesh.coordinate(v, 1), mesh.coordinate(v, 2));
            }
            List<double[]> met = new ArrayList<>();
            for (int k = 0; k < 3; k++) {
                cut(triangle[k], triangle[(k + 1) % 3], met);
            }
            for (int k = 1; k < met.size(); k++) {
                if (!Arrays.equals(met.get(k - 1), met.get(k))) {
                    int first = corners.size();
                    corners.add(new Point(met.get(k - 1)[0], height, met.get(k - 1)[1]));
                    corners.add(new Point(met.get(k)[0], height, met.get(k)[1]));
                    corners.add(new Point(met.get(k)[0], height + thin, met.get(k)[1]));
                    faces.add(new int[] {first, first + 1, first + 2});
                }
            }
        }
        return faces.isEmpty() ? null : new MeshObject(corners, faces.toArray(int[][]::new));
    }
}
