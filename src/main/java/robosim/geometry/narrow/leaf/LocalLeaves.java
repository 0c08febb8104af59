package robosim.geometry.narrow.leaf;

import robosim.geometry.exact.Rotations;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.RoundedBox;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;

/**
 * The leaves of an object in its own frame, made once. A placement computes the leaves in the world from them, always
 * afresh and in the same order, so that the stored numbers of a placed object do not depend on how it got there.
 */
public final class LocalLeaves {
    private final LeafColumn own;

    private LocalLeaves(LeafColumn own) {
        this.own = own;
    }

    /** The leaves of an object, in the order of a group's members, depth first. */
    public static LocalLeaves of(GeometryObject object) {
        LocalLeaves leaves = new LocalLeaves(new LeafColumn(1));
        double[] frame = new double[Leaf.STRIDE];
        Rotations.identity(frame, Leaf.ROTATION);
        leaves.add(object, frame);
        return leaves;
    }

    /** Makes these, the leaf of an object given by sizes, that of another one; returns whether they change. */
    boolean set(GeometryObject object) {
        double[] row = own.rows();
        LeafKind before = own.kind(0);
        double a = row[Leaf.SIZE];
        double b = row[Leaf.SIZE + 1];
        double c = row[Leaf.SIZE + 2];
        LeafKind kind = size(object, row, 0);
        own.setKind(0, kind);
        return kind != before || a != row[Leaf.SIZE] || b != row[Leaf.SIZE + 1] || c != row[Leaf.SIZE + 2];
    }

    /** The leaves of an object at its place, in a new column. */
    public static LeafColumn placed(GeometryObject object) {
        LeafColumn leaves = new LeafColumn(1);
        placed(object, leaves);
        return leaves;
    }

    /** Sets a column to the leaves of an object at its place. */
    public static void placed(GeometryObject object, LeafColumn leaves) {
        leaves.clear();
        if (object.kind().isSized()) {
            placeSimple(object, leaves);
        } else if (object instanceof GridObject grid) {
            placeGrid(grid, leaves);
        } else {
            LocalLeaves own = of(object);
            leaves.append(own.size());
            double[] rotation = object.rotation();
            Point c = object.center();
            own.place(c.x(), c.y(), c.z(), rotation, 0, leaves, 0);
        }
    }

    /** Places a single leaf, which has the object's centre and rotation to the bit. */
    private static void placeSimple(GeometryObject object, LeafColumn leaves) {
        int leaf = leaves.append(1);
        double[] row = leaves.rows();
        Point c = object.center();
        row[0] = c.x();
        row[1] = c.y();
        row[2] = c.z();
        LeafKind kind = size(object, row, 0);
        kind = object.pose().isUpright() ? kind.upright() : kind;
        if (kind.isTurned()) {
            object.pose().rotation(row, Leaf.ROTATION);
            kind = UprightDetection.kind(kind, row, 0);
        }
        leaves.setKind(leaf, kind);
    }

    private static void placeGrid(GridObject grid, LeafColumn leaves) {
        int leaf = leaves.append(1);
        double[] row = leaves.rows();
        Point c = grid.center();
        row[0] = c.x();
        row[1] = c.y();
        row[2] = c.z();
        row[4] = grid.height() / 2;
        grid.pose().rotation(row, Leaf.ROTATION);
        leaves.setKind(leaf, LeafKind.GRID);
        leaves.setCells(leaf, grid.placed());
    }

    /** Writes the sizes of a box, cylinder, sphere or capsule and answers its kind. */
    private static LeafKind size(GeometryObject object, double[] row, int at) {
        RoundedBox box = object.roundedBox();
        LeafKind kind = LeafKind.of(object.kind());
        row[at + 3] = kind.isRound() ? box.radius() : box.halfWidth();
        row[at + 4] = box.halfHeight();
        row[at + 5] = box.halfLength();
        return kind;
    }

    /** The number of leaves. */
    public int size() {
        return own.size();
    }

    /** Whether any leaf is a mesh. */
    public boolean hasMesh() {
        for (int leaf = 0; leaf < own.size(); leaf++) {
            if (own.kind(leaf).isMesh()) {
                return true;
            }
        }
        return false;
    }

    /** The leaves in the own frame. */
    LeafColumn own() {
        return own;
    }

    /** The shape of an object, placed by the frame: a centre and a rotation, laid out as a leaf's. */
    private void add(GeometryObject object, double[] frame) {
        if (object instanceof ObjectGroup group) {
            for (GeometryObject member : group.members()) {
                add(member, within(frame, member));
            }
        } else if (object instanceof MeshObject mesh) {
            row(mesh.isSolid() ? LeafKind.SOLID_MESH : LeafKind.MESH, frame);
            own.setMesh(own.size() - 1, mesh.triangles());
        } else if (object instanceof GridObject) {
            throw new IllegalArgumentException("a grid has no leaves of its own (got: " + object + ")");
        } else {
            int at = row(LeafKind.BOX, frame);
            own.setKind(own.size() - 1, size(object, own.rows(), at));
        }
    }

    /** The frame of a member: its pose within the frame of its group. */
    private static double[] within(double[] frame, GeometryObject member) {
        double[] placed = new double[Leaf.STRIDE];
        Rotations.multiply(frame, Leaf.ROTATION, member.rotation(), 0, placed, Leaf.ROTATION);
        Point c = member.center();
        for (int axis = 0; axis < 3; axis++) {
            int row = Leaf.ROTATION + 3 * axis;
            placed[axis] = frame[row] * c.x() + frame[row + 1] * c.y() + frame[row + 2] * c.z() + frame[axis];
        }
        return placed;
    }

    private int row(LeafKind kind, double[] frame) {
        int leaf = own.append(1);
        System.arraycopy(frame, 0, own.rows(), leaf * Leaf.STRIDE, Leaf.STRIDE);
        own.setKind(leaf, kind);
        return leaf * Leaf.STRIDE;
    }

    /**
     * Writes the leaves in the world.
     *
     * @param rotation the object's attitude: nine numbers from {@code at} on
     * @param first    the index of the first leaf in the column, which must have room
     */
    public void place(double cx, double cy, double cz, double[] rotation, int at, LeafColumn column, int first) {
        double[] from = own.rows();
        double[] to = column.rows();
        for (int k = 0; k < own.size(); k++) {
            int i = k * Leaf.STRIDE;
            int j = (first + k) * Leaf.STRIDE;
            to[j] = rotation[at] * from[i] + rotation[at + 1] * from[i + 1] + rotation[at + 2] * from[i + 2] + cx;
            to[j + 1] =
                    rotation[at + 3] * from[i] + rotation[at + 4] * from[i + 1] + rotation[at + 5] * from[i + 2] + cy;
            to[j + 2] =
                    rotation[at + 6] * from[i] + rotation[at + 7] * from[i + 1] + rotation[at + 8] * from[i + 2] + cz;
            to[j + 3] = from[i + 3];
            to[j + 4] = from[i + 4];
            to[j + 5] = from[i + 5];
            Rotations.multiply(rotation, at, from, i + Leaf.ROTATION, to, j + Leaf.ROTATION);
            column.setKind(first + k, UprightDetection.kind(own.kind(k), to, j));
            if (own.kind(k).isMesh()) {
                column.setMesh(first + k, own.mesh(k));
            }
        }
    }
}
