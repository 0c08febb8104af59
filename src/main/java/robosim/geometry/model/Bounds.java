package robosim.geometry.model;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Rotations;
import robosim.geometry.exact.UpwardRounding;
import robosim.geometry.index.cells.PlacedCells;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.GeometryObject.RoundedBox;

/**
 * A box along the world's axes that holds an object, by its least and greatest coordinates in world units. Rounded
 * outward: nothing of the object lies outside, and where no number needs rounding, as of upright objects at quarter turns,
 * the box is exact. No object is refused for what it reaches, so these may be beyond what a {@link Point} takes.
 */
public record Bounds(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
    /** Where in a frame its rotation begins, behind a centre and three sizes: as {@link TriangleMesh#placed} reads it. */
    private static final int ROTATION = 6;

    static Bounds of(GeometryObject object) {
        double[] all = new double[6];
        Arrays.fill(all, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(all, 3, 6, Double.NEGATIVE_INFINITY);
        double[] own = new double[ROTATION + Rotations.SIZE];
        Rotations.identity(own, ROTATION);
        add(object, own, frame(object), all);
        return new Bounds(all[0], all[1], all[2], all[3], all[4], all[5]);
    }

    private static double[] frame(GeometryObject object) {
        double[] frame = new double[ROTATION + Rotations.SIZE];
        frame[0] = object.center().x();
        frame[1] = object.center().y();
        frame[2] = object.center().z();
        object.pose().rotation(frame, ROTATION);
        return frame;
    }

    /** A frame within another one. */
    private static double[] within(double[] outer, double[] inner) {
        double[] placed = new double[ROTATION + Rotations.SIZE];
        Rotations.multiply(outer, ROTATION, inner, ROTATION, placed, ROTATION);
        for (int axis = 0; axis < 3; axis++) {
            int row = ROTATION + 3 * axis;
            placed[axis] = outer[row] * inner[0] + outer[row + 1] * inner[1] + outer[row + 2] * inner[2] + outer[axis];
        }
        return placed;
    }

    /**
     * Adds the shape of an object. Members are placed in the group first and then with it, the numbers that a world has of
     * them too.
     *
     * @param own   where it stands within the outermost object
     * @param outer where that one stands
     */
    private static void add(GeometryObject object, double[] own, double[] outer, double[] all) {
        if (object instanceof ObjectGroup group) {
            for (GeometryObject member : group.members()) {
                add(member, within(own, frame(member)), outer, all);
            }
            return;
        }
        if (object instanceof GridObject grid) {
            add(grid, all);
            return;
        }
        double[] place = within(outer, own);
        if (object instanceof MeshObject mesh) {
            add(mesh.triangles(), place, all);
            return;
        }
        RoundedBox box = object.roundedBox();
        for (int axis = 0; axis < 3; axis++) {
            double half = half(box, place, axis);
            all[axis] = Math.min(all[axis], 0 - UpwardRounding.sum(-place[axis], half));
            all[3 + axis] = Math.max(all[3 + axis], UpwardRounding.sum(place[axis], half));
        }
    }

    private static double half(RoundedBox box, double[] place, int axis) {
        if (box.disc() > 0) {
            return cylinder(box, place, axis);
        }
        double[] halves = {box.halfWidth(), box.halfHeight(), box.halfLength()};
        return UpwardRounding.sum(UpwardRounding.ofBox(halves, 0, place, ROTATION + 3 * axis), box.ball());
    }

    /** Adds the occupied cells of a grid, which is a member of no group. */
    private static void add(GridObject grid, double[] all) {
        PlacedCells cells = grid.placed();
        double y = grid.center().y();
        double half = grid.height() / 2;
        double[] box = {
            cells.bound(0),
            0 - UpwardRounding.sum(-y, half),
            cells.bound(1),
            cells.bound(2),
            UpwardRounding.sum(y, half),
            cells.bound(3)
        };
        for (int axis = 0; axis < 3; axis++) {
            all[axis] = Math.min(all[axis], box[axis]);
            all[3 + axis] = Math.max(all[3 + axis], box[3 + axis]);
        }
    }

    private static double cylinder(RoundedBox box, double[] place, int axis) {
        double half = box.halfHeight();
        double[] own = {place[ROTATION + 1], place[ROTATION + 4], place[ROTATION + 7]};
        double along = own[axis];
        double p = own[(axis + 1) % 3];
        double q = own[(axis + 2) % 3];
        if (along == 0) {
            return box.disc();
        }
        if (p == 0 && q == 0 && Math.abs(along) == 1) {
            return half;
        }
        double length = Math.sqrt(own[0] * own[0] + own[1] * own[1] + own[2] * own[2]);
        return UpwardRounding.ofCylinder(box.disc(), half, along, p, q, length);
    }

    private static void add(TriangleMesh mesh, double[] place, double[] all) {
        for (int t = 0; t < mesh.size(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                for (int axis = 0; axis < 3; axis++) {
                    double at = mesh.placed(mesh.vertex(t, corner), axis, place, 0);
                    all[axis] = Math.min(all[axis], at);
                    all[3 + axis] = Math.max(all[3 + axis], at);
                }
            }
        }
    }

    /** How far any of the objects is from the origin along X, Y and Z, on either side; 0 where there is none. */
    public static double[] reach(Collection<? extends GeometryObject> objects) {
        double[] reach = new double[3];
        for (GeometryObject object : Checks.present("objects", objects)) {
            Bounds b = object.bounds();
            reach[0] = Math.max(reach[0], Math.max(-b.minX, b.maxX));
            reach[1] = Math.max(reach[1], Math.max(-b.minY, b.maxY));
            reach[2] = Math.max(reach[2], Math.max(-b.minZ, b.maxZ));
        }
        return reach;
    }

    /** The least bounds that hold both. */
    public Bounds and(Bounds other) {
        Checks.present("other", other);
        return new Bounds(
                Math.min(minX, other.minX),
                Math.min(minY, other.minY),
                Math.min(minZ, other.minZ),
                Math.max(maxX, other.maxX),
                Math.max(maxY, other.maxY),
                Math.max(maxZ, other.maxZ));
    }

    /** The eight corners. */
    public List<Point> corners() {
        List<Point> corners = new ArrayList<>();
        for (int corner = 0; corner < 8; corner++) {
            corners.add(new Point(
                    (corner & 1) == 0 ? minX : maxX, (corner & 2) == 0 ? minY : maxY, (corner & 4) == 0 ? minZ : maxZ));
        }
        return corners;
    }

    /** Extent along X in world units. */
    public double width() {
        return maxX - minX;
    }

    /** Extent along Y. */
    public double height() {
        return maxY - minY;
    }

    /** Extent along Z. */
    public double length() {
        return maxZ - minZ;
    }

    /** Halfway along X. */
    public double middleX() {
        return (minX + maxX) / 2;
    }

    /** Halfway along Y. */
    public double middleY() {
        return (minY + maxY) / 2;
    }

    /** Halfway along Z. */
    public double middleZ() {
        return (minZ + maxZ) / 2;
    }

    /** The largest of the three extents. */
    public double size() {
        return Math.max(width(), Math.max(height(), length()));
    }
}
