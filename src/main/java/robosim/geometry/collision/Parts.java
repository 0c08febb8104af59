package robosim.geometry.collision;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Attitude;
import robosim.geometry.exact.WorkCounter;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.narrow.leaf.Enclosure;
import robosim.geometry.narrow.leaf.GridWalk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.LocalLeaves;

/**
 * The simple parts of an object at its place; those of a grid are its occupied cells.
 *
 * @param cells of a grid, the number of each part's cell; null for other objects, whose parts are numbered from 0
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record Parts(LeafColumn leaves, int @Nullable [] cells) {
    /** All parts. */
    static Parts of(GeometryObject object) {
        return of(object, null);
    }

    /** The leaves of an object at its place; of a box, cylinder, sphere or capsule in the column given, which refers to nothing. */
    static LeafColumn leaves(GeometryObject object, LeafColumn column) {
        if (!object.kind().isSized()) {
            return LocalLeaves.placed(object);
        }
        LocalLeaves.placed(object, column);
        return column;
    }

    /** What stands for an object at an accuracy, in a dimension; of a grid its occupied cells. */
    static LeafColumn leaves(GeometryObject object, Accuracy accuracy, Dimension dimension, LeafColumn column) {
        if (object.kind() == GeometryObject.Kind.GRID) {
            return of(object).leaves();
        }
        if (accuracy == Accuracy.EXACT) {
            return leaves(object, column);
        }
        Pose pose = object.pose();
        Point center = pose.center();
        double[] rotation = new double[Attitude.STRIDE];
        pose.attitude(rotation, 0);
        LeafColumn enclosure = new LeafColumn(1);
        enclosure.append(1);
        new Enclosure(accuracy, LocalLeaves.of(object))
                .place(dimension, center.x(), center.y(), center.z(), rotation, 0, enclosure, 0);
        return enclosure;
    }

    /** All parts but, of a grid, cells that another object certainly does not touch. */
    static Parts near(GeometryObject object, GeometryObject other) {
        return of(object, other);
    }

    private static Parts of(GeometryObject object, @Nullable GeometryObject near) {
        LeafColumn placed = LocalLeaves.placed(object);
        return object instanceof GridObject ? cells(placed, near) : new Parts(placed, null);
    }

    private static Parts cells(LeafColumn grid, @Nullable GeometryObject near) {
        double[] box = new double[6];
        if (near == null) {
            grid.bounds(0, box);
        } else {
            Bounds b = near.bounds();
            box = new double[] {b.minX(), b.minY(), b.minZ(), b.maxX(), b.maxY(), b.maxZ()};
        }
        // Heights are left to the contact itself, as in the plane they do not count.
        box[1] = Double.NEGATIVE_INFINITY;
        box[4] = Double.POSITIVE_INFINITY;
        GridWalk walk = new GridWalk(new WorkCounter());
        LeafColumn leaves = new LeafColumn(1);
        int[] cells = new int[16];
        walk.startBox(grid, 0, box);
        for (int cell = walk.nextInBox(); cell >= 0; cell = walk.nextInBox()) {
            int part = leaves.appendWhole(walk.piece(cell, grid.kind(0)), 0, 1);
            if (part == cells.length) {
                cells = Arrays.copyOf(cells, 2 * part);
            }
            cells[part] = cell;
        }
        return new Parts(leaves, Arrays.copyOf(cells, leaves.size()));
    }

    /** The convex piece that takes part in a contact of an object; null for a solid mesh as a whole. */
    static @Nullable Leaf piece(GeometryObject object, ContactPart part) {
        LeafColumn leaves = LocalLeaves.placed(object);
        if (object instanceof GridObject) {
            double[] box = new double[6];
            leaves.bounds(0, box);
            GridWalk walk = new GridWalk(new WorkCounter());
            walk.startBox(leaves, 0, box);
            return new Leaf().set(walk.piece(part.part(), leaves.kind(0)), 0);
        }
        if (part.part() < 0 || part.part() >= leaves.size()) {
            throw new IllegalArgumentException(
                    "contact must be one of these objects (got: part " + part.part() + " of " + leaves.size() + ")");
        }
        if (!leaves.kind(part.part()).isMesh()) {
            return new Leaf().set(leaves, part.part());
        }
        return part.isFace() ? triangle(leaves, part) : null;
    }

    private static Leaf triangle(LeafColumn leaves, ContactPart part) {
        TriangleMesh mesh = leaves.mesh(part.part());
        for (int triangle = 0; triangle < mesh.size(); triangle++) {
            if (mesh.face(triangle) == part.face()) {
                Leaf leaf = new Leaf(LeafKind.TRIANGLE);
                for (int k = 0; k < 9; k++) {
                    int vertex = mesh.vertex(triangle + part.half(), k / 3);
                    leaf.row[k] = mesh.placed(vertex, k % 3, leaves.rows(part.part()), leaves.at(part.part()));
                }
                return leaf;
            }
        }
        throw new IllegalArgumentException("contact must be one of these objects (got: face " + part.face() + ")");
    }

    boolean isEmpty() {
        return leaves.size() == 0;
    }

    /** The number by which a part goes. */
    int number(int part) {
        return cells == null ? part : cells[part];
    }
}
