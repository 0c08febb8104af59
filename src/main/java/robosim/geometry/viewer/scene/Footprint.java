package robosim.geometry.viewer.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.RoundedBox;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/** A convex piece of an object's projection on the XZ plane, or all cells of a grid; for pictures, in plain doubles. */
public sealed interface Footprint permits Footprint.Disc, Footprint.Polygon, CellArea {
    /** A disc. */
    record Disc(double x, double z, double radius) implements Footprint {}

    /** A convex polygon of x, z, x, z ... with positive area, or a segment or a point. */
    final class Polygon implements Footprint {
        private final double[] corners;

        Polygon(double[] corners) {
            this.corners = corners;
        }

        public double[] corners() {
            return corners;
        }
    }

    /** Corners of the rim of a tipped cylinder, and of the ends of a tipped capsule. */
    int RIM = 64;

    /**
     * How deep a point is within a piece: its distance from the piece's edge; negative outside, where it is only a
     * bound.
     */
    static double depth(Footprint outline, double x, double z) {
        if (outline instanceof Disc disc) {
            return disc.radius() - Math.sqrt((x - disc.x()) * (x - disc.x()) + (z - disc.z()) * (z - disc.z()));
        }
        if (outline instanceof CellArea cells) {
            return cells.depth(x, z);
        }
        double[] corners = ((Polygon) outline).corners();
        double least = corners.length < 6 ? -1 : Double.POSITIVE_INFINITY;
        for (int k = 0; k < corners.length && corners.length >= 6; k += 2) {
            int next = (k + 2) % corners.length;
            double ex = corners[next] - corners[k];
            double ez = corners[next + 1] - corners[k + 1];
            double size = Math.sqrt(ex * ex + ez * ez);
            if (size > 0) {
                least = Math.min(least, (ex * (z - corners[k + 1]) - ez * (x - corners[k])) / size);
            }
        }
        return least;
    }

    /** The pieces of an object at its place. */
    static List<Footprint> of(GeometryObject object) {
        List<Footprint> outlines = new ArrayList<>();
        add(object, outlines);
        return outlines;
    }

    private static void add(GeometryObject object, List<Footprint> outlines) {
        if (object instanceof ObjectGroup group) {
            group.placedMembers().forEach(member -> add(member, outlines));
        } else if (object instanceof MeshObject mesh) {
            mesh(mesh.triangles(), new Frame(mesh.pose()), outlines);
        } else if (object instanceof GridObject grid) {
            outlines.add(new CellArea(grid));
        } else {
            outlines.add(solid(object.roundedBox(), new Frame(object.pose())));
        }
    }

    private static Footprint solid(RoundedBox box, Frame frame) {
        if (box.isRound() && (frame.isUpright() || (box.disc() == 0 && box.halfHeight() == 0))) {
            return new Disc(frame.origin.x(), frame.origin.z(), box.radius());
        }
        double[] corners = new double[16];
        for (int k = 0; k < 8; k++) {
            frame.project(box.corner(k, 0), box.corner(k, 1), box.corner(k, 2), corners, 2 * k);
        }
        return new Polygon(hull(box.isRound() ? rims(box, corners, frame) : corners));
    }

    /** What is around the two ends of a tipped cylinder or capsule. */
    private static double[] rims(RoundedBox box, double[] corners, Frame frame) {
        double[] rims = new double[4 * RIM];
        for (int k = 0; k < RIM; k++) {
            double angle = 2 * Math.PI * k / RIM;
            double x = box.radius() * StrictMath.cos(angle);
            double z = box.radius() * StrictMath.sin(angle);
            for (int end = 0; end < 4; end += 2) {
                if (box.disc() > 0) {
                    frame.project(x, box.corner(end, 1), z, rims, 4 * k + end);
                } else {
                    rims[4 * k + end] = corners[2 * end] + x;
                    rims[4 * k + end + 1] = corners[2 * end + 1] + z;
                }
            }
        }
        return rims;
    }

    private static void mesh(TriangleMesh mesh, Frame frame, List<Footprint> outlines) {
        for (int t = 0; t < mesh.size(); t++) {
            double[] corners = new double[6];
            for (int corner = 0; corner < 3; corner++) {
                int v = mesh.vertex(t, corner);
                frame.project(mesh.coordinate(v, 0), mesh.coordinate(v, 1), mesh.coordinate(v, 2), corners, 2 * corner);
            }
            outlines.add(new Polygon(hull(corners)));
        }
    }

    /** The convex hull of points x, z, x, z ...: Andrew's monotone chain. */
    static double[] hull(double[] points) {
        int count = points.length / 2;
        Integer[] order = new Integer[count];
        Arrays.setAll(order, k -> k);
        Arrays.sort(order, (a, b) -> {
            int byX = Double.compare(points[2 * a], points[2 * b]);
            return byX != 0 ? byX : Double.compare(points[2 * a + 1], points[2 * b + 1]);
        });
        double[] hull = new double[4 * count + 2];
        int size = 0;
        for (int k = 0; k < count; k++) {
            size = append(hull, size, 2, points, order[k]);
        }
        int lower = size + 1;
        for (int k = count - 2; k >= 0; k--) {
            size = append(hull, size, lower, points, order[k]);
        }
        return Arrays.copyOf(hull, 2 * Math.max(1, size - 1));
    }

    /** Puts a point on a chain of which at least {@code keep - 1} points stay. */
    private static int append(double[] hull, int size, int keep, double[] points, int point) {
        double x = points[2 * point];
        double z = points[2 * point + 1];
        int n = size;
        while (n >= keep) {
            double bx = hull[2 * n - 2];
            double bz = hull[2 * n - 1];
            double ax = hull[2 * n - 4];
            double az = hull[2 * n - 3];
            if ((bx - ax) * (z - az) - (bz - az) * (x - ax) > 0) {
                break;
            }
            n--;
        }
        hull[2 * n] = x;
        hull[2 * n + 1] = z;
        return n + 1;
    }

    /** An object's own frame, placed in the world. */
    final class Frame {
        private final double[] rotation;
        private final Point origin;

        Frame(Pose pose) {
            rotation = pose.rotation();
            origin = pose.center();
        }

        boolean isUpright() {
            return rotation[1] == 0 && rotation[7] == 0;
        }

        /** The world's Y of a point of the frame. */
        double height(double x, double y, double z) {
            return rotation[3] * x + rotation[4] * y + rotation[5] * z + origin.y();
        }

        void project(double x, double y, double z, double[] into, int at) {
            into[at] = rotation[0] * x + rotation[1] * y + rotation[2] * z + origin.x();
            into[at + 1] = rotation[6] * x + rotation[7] * y + rotation[8] * z + origin.z();
        }
    }
}
