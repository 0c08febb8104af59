package robosim.geometry.engine.broadphase;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.objects.Forms;
import robosim.geometry.engine.objects.LeafRanges;
import robosim.geometry.engine.objects.ObjectLeaves;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.index.ArrayGrowth;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.QuadTree;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LocalLeaves;

/**
 * The objects of a world that are its own, or those that it shares with others, as they are seen at one accuracy: their
 * leaves in one column, their bounds, and the trees over them.
 *
 * <p>Objects go by the ids of their world.
 */
public final class LeafTable {
    final Accuracy accuracy;
    final Dimension dimension;
    final QuadTree tree;
    final QuadCursor cursor;

    /** Where objects are looked for in a world with heights; null in one without, where the quadtree has them. */
    final @Nullable SpaceIndex space;

    /** More than any place or size in the plane. */
    final double extent;

    /** Whether heights do not count, and objects are as they are. */
    final boolean isFlat;

    /** What ids in the world have beside the number of an object in the columns and trees here: see {@link ObjectTable#SHARED}. */
    final int mark;

    private LeafColumn leaves;
    private final LeafRanges spans;

    /**
     * In a world without heights so few moveable objects are tried one by one just as fast, and more of them are in the
     * quadtree, where a move takes longer; with heights all of them are in a hierarchy.
     */
    private static final int FEW_MOVERS = 16;

    /** The same for grids. */
    private static final int FEW_GRIDS = 4;

    private int movers;

    /**
     * Grids that are in no tree: a few, as one mostly lies over all of a world and finds for itself what is near. More of them are in
     * the tree of static objects.
     */
    private int[] grids = new int[0];

    private int gridCount;
    private boolean hasMoversInTree;
    private boolean hasGridsInTree;

    /** The longest sum of three sides of bounds that were taken in. */
    private double longest;

    /** How to place a moveable object; null until it is first needed. */
    private @Nullable ObjectLeaves[] forms = new ObjectLeaves[0];

    /** The forms of objects that need not be here; null until one is needed, and at EXACT. */
    private @Nullable Forms made;

    /** The forms at EXACT by what they are of: all that are alike have one. Forgotten when a moveable object goes. */
    private final Map<Shape, ObjectLeaves> shared = new HashMap<>();

    /**
     * What the leaves of an object depend on, wherever it stands: the sizes of a primitive, or the very triangles or members,
     * which all its placements share.
     */
    private record Shape(GeometryObject.Kind kind, boolean isSolid, Object of) {
        static Shape of(GeometryObject object) {
            if (object instanceof MeshObject mesh) {
                return new Shape(mesh.kind(), mesh.isSolid(), mesh.triangles());
            }
            return new Shape(
                    object.kind(), true, object instanceof ObjectGroup group ? group.members() : object.roundedBox());
        }

        @Override
        @SuppressWarnings("ReferenceEquality") // equal triangles and members take long to compare
        public boolean equals(@Nullable Object other) {
            return other instanceof Shape that
                    && kind == that.kind
                    && isSolid == that.isSolid
                    && (of == that.of || (kind.isSized() && of.equals(that.of)));
        }

        @Override
        public int hashCode() {
            return kind.isSized() ? of.hashCode() : System.identityHashCode(of);
        }
    }

    /** What is known of each object beforehand: a sum of the bits below. */
    private byte[] shapes;

    /** It is moveable, and its leaves are convex and keep their shape as it moves. */
    private static final byte CONVEX = 1;

    /** There is one such leaf, about the object's centre. */
    private static final byte SINGLE = 2;

    /** It is a disc as seen from above. */
    private static final byte DISC = 4;

    /** It is moveable. */
    private static final byte MOVER = 8;

    /** It is a grid. */
    private static final byte GRID = 16;

    private final ObjectTable objects;
    private final LeafColumn incoming = new LeafColumn(1);
    private final double[] box = new double[6];

    LeafTable(ObjectTable objects, Accuracy accuracy, Dimension dimension, double width, double length) {
        this.objects = objects;
        mark = 0;
        leaves = new LeafColumn(1);
        if (dimension == Dimension.PLANAR) {
            leaves.reserveUpright(0);
        }
        spans = new LeafRanges();
        shapes = new byte[ArrayGrowth.FIRST];
        this.accuracy = accuracy;
        this.dimension = dimension;
        tree = new QuadTree(-width / 2, -length / 2, width / 2, length / 2, this::trim);
        cursor = tree.cursor();
        space = dimension == Dimension.SPATIAL ? new SpaceIndex(this::trim) : null;
        extent = width + length;
        isFlat = dimension == Dimension.PLANAR && accuracy == Accuracy.EXACT;
    }

    private LeafTable(LeafTable of) {
        objects = of.objects;
        accuracy = of.accuracy;
        dimension = of.dimension;
        extent = of.extent;
        isFlat = of.isFlat;
        mark = ObjectTable.SHARED;
        tree = of.tree.view();
        cursor = tree.cursor();
        space = of.space == null ? null : of.space.view();
        leaves = of.leaves.view();
        spans = of.spans;
        shapes = of.shapes;
        longest = of.longest;
        grids = of.grids;
        gridCount = of.gridCount;
    }

    /** Builds now what is otherwise built on demand. From now on nothing may change here, and many threads may ask views of it. */
    void freeze() {
        if (space == null) {
            tree.freeze();
        } else {
            space.freeze();
        }
        trim();
    }

    /** The same objects, of which none comes or goes any more, for one more thread to ask. */
    LeafTable view() {
        return new LeafTable(this);
    }

    /** Makes a column hold what stands here for an object that is not, or not yet, in the world. */
    void placed(GeometryObject object, LeafColumn column) {
        if (accuracy == Accuracy.EXACT || object.kind() == GeometryObject.Kind.GRID) {
            LocalLeaves.placed(object, column);
            return;
        }
        made().place(dimension, object, column);
    }

    private Forms made() {
        Forms known = made;
        if (known == null) {
            known = new Forms(accuracy);
            made = known;
        }
        return known;
    }

    /** Takes an object in under an id that it has elsewhere; in a world of moveable and static ones. */
    void add(int id, GeometryObject object) {
        placed(object, incoming);
        outline(incoming, box);
        add(id, object, incoming, box);
    }

    /**
     * Bounds of what stands for an object, which is all that a column holds; where they only pass over what cannot meet,
     * quick ones.
     */
    void outline(LeafColumn column, double[] out) {
        if (column.size() == 1 && hasRoughBounds()) {
            column.roughBounds(0, out);
        } else {
            column.bounds(0, column.size(), out);
        }
    }

    /** Whether bounds only pass over what cannot meet; those of boxes along the axes and octagons are turned, too. */
    private boolean hasRoughBounds() {
        return accuracy != Accuracy.AABB && accuracy != Accuracy.DOP;
    }

    /** Takes an object in that has been placed, with the bounds of what stands for it. */
    void add(int id, GeometryObject object, LeafColumn placed, double[] box) {
        reserve(id);
        int leaf = claim(id, object, placed);
        leaves.copy(placed, leaf);
        tree.keep(id, box);
        if (space == null) {
            leaves.outline(id, box[0], box[2], box[3], box[5]);
        }
        if (object.kind() == GeometryObject.Kind.GRID) {
            takeGrid(id);
            return;
        }
        longest = Math.max(longest, Distance.sides(box));
        shapes[id] = placed.size() == 1 && leaves.kind(leaf).isDisc() ? DISC : 0;
        if (object.isMoveable()) {
            shapes[id] = (byte) (shapes[id] | MOVER | shape(id, object));
            movers++;
            countMovers(id);
        } else if (space == null) {
            tree.list(id);
        } else {
            space.still.add(id, tree.boxes());
        }
    }

    private void takeGrid(int id) {
        shapes[id] = GRID;
        if (hasGridsInTree) {
            listStill(id);
            return;
        }
        if (gridCount == FEW_GRIDS) {
            hasGridsInTree = true;
            for (int k = 0; k < gridCount; k++) {
                listStill(grids[k]);
            }
            gridCount = 0;
            listStill(id);
            return;
        }
        if (gridCount == grids.length) {
            grids = Arrays.copyOf(grids, gridCount + 1);
        }
        grids[gridCount++] = id;
    }

    /** Adds a static object to the tree; what is in it may be found by its size. */
    private void listStill(int id) {
        System.arraycopy(tree.boxes(), 6 * id, box, 0, 6);
        longest = Math.max(longest, Distance.sides(box));
        if (space == null) {
            tree.list(id);
        } else {
            space.still.add(id, tree.boxes());
        }
    }

    private void giveUpGrid(int id) {
        int at = 0;
        while (grids[at] != id) {
            at++;
        }
        System.arraycopy(grids, at + 1, grids, at, gridCount - at - 1);
        gridCount--;
    }

    /** Where an object's leaves are to stand: in the plane, an upright static one has half a row. */
    private int claim(int id, GeometryObject object, LeafColumn placed) {
        return space == null
                ? spans.claim(id, placed.size(), leaves, !object.isMoveable() && placed.fitsUpright())
                : spans.claimWhole(id, placed.size(), leaves);
    }

    private byte shape(int id, GeometryObject object) {
        if (accuracy != Accuracy.EXACT) {
            return object.kind().isSized() && accuracy != Accuracy.DOP ? SINGLE : 0;
        }
        if (object.kind().isSized()) {
            return CONVEX | SINGLE;
        }
        return object instanceof ObjectGroup && !form(id).own.hasMesh() ? CONVEX : 0;
    }

    /** Adds all moveable objects to a tree once there are more than are tried one by one. */
    private void countMovers(int last) {
        if (hasMoversInTree) {
            list(last);
        } else if (space != null || movers > FEW_MOVERS) {
            hasMoversInTree = true;
            for (int k = 0; k < objects.moverCount(); k++) {
                int id = objects.mover(k);
                if (id < shapes.length
                        && (shapes[id] & MOVER) != 0) { // not all are here yet while a view is being made
                    list(id);
                }
            }
        }
    }

    private void list(int id) {
        double[] b = bounds();
        if (space == null) {
            int at = 6 * id;
            leaves.outline(id, b[at], b[at + 2], b[at + 3], b[at + 5]);
            tree.list(id);
        } else {
            space.moving.add(id, b);
        }
    }

    /** How many moveable objects are in no tree: all of them or none. */
    int moversBesideTree() {
        return hasMoversInTree ? 0 : movers;
    }

    /** Whether every object is in a tree. */
    boolean hasAllInTrees() {
        return gridCount == 0 && moversBesideTree() == 0;
    }

    /** Whether no object is in a tree. */
    boolean hasEmptyTrees() {
        return space == null ? tree.size() == 0 : space.still.size() + space.moving.size() == 0;
    }

    /** How many grids are in no tree. */
    int gridCount() {
        return gridCount;
    }

    /** One of the grids. */
    int grid(int k) {
        return grids[k] | mark;
    }

    /** Gives up room that there is for more objects. */
    private void trim() {
        int limit = objects.limit();
        if (ArrayGrowth.isWasteful(limit, shapes.length)) {
            shapes = Arrays.copyOf(shapes, limit);
        }
        tree.trim();
        leaves.trim();
    }

    private void reserve(int id) {
        if (id >= shapes.length) {
            shapes = Arrays.copyOf(shapes, ArrayGrowth.of(id));
        }
    }

    void remove(int id) {
        if (shapes[id] == GRID && !hasGridsInTree) {
            giveUpGrid(id);
        } else if (!objects.isMoveable(id)) {
            if (space == null) {
                tree.remove(id);
            } else {
                space.still.remove(id);
            }
        } else {
            movers--;
            shared.clear();
            if (space == null) {
                tree.remove(id);
            } else if (hasMoversInTree) {
                space.moving.remove(id);
            }
        }
        if (id < forms.length) {
            forms[id] = null;
        }
        shapes[id] = 0;
        leaves = spans.release(id, leaves);
    }

    /** Puts a moveable object where its place now says. */
    void move(int id, double[] places, int at) {
        form(id).place(dimension, places[at], places[at + 1], places[at + 2], places, at + 3, leaves, first(id));
        measure(id);
    }

    /** Puts a moveable object where its place now says, with the attitude that it had. */
    void shift(int id, double[] places, int at) {
        if ((shapes[id] & SINGLE) == 0) {
            move(id, places, at);
            return;
        }
        // Its own centre is the origin, and no coordinate is -0.0: placed, it has the centre to the bit.
        double[] rows = leaves.rows();
        int row = first(id) * Leaf.STRIDE;
        rows[row] = places[at];
        rows[row + 1] = places[at + 1];
        rows[row + 2] = places[at + 2];
        measure(id);
    }

    private void measure(int id) {
        if (count(id) != 1) {
            leaves.bounds(first(id), count(id), box);
            shapes[id] = (byte) (shapes[id] & ~DISC);
        } else {
            if (hasRoughBounds()) {
                leaves.roughBounds(first(id), box);
            } else {
                leaves.bounds(first(id), box);
            }
            shapes[id] = (byte) (leaves.kind(first(id)).isDisc() ? shapes[id] | DISC : shapes[id] & ~DISC);
        }
        if (hasMoversInTree && space == null) {
            leaves.outline(id, box[0], box[2], box[3], box[5]);
            tree.move(id, box);
            return;
        }
        tree.keep(id, box);
        if (hasMoversInTree && space != null) {
            space.moving.move(id, tree.boxes());
        }
    }

    /** Whether the leaves of a moveable object are convex and keep their shape as it moves. */
    boolean keepsShape(int id) {
        return (shapes[id] & CONVEX) != 0;
    }

    /** Whether there is one such leaf, about the object's centre. */
    boolean isSingle(int id) {
        return (shapes[id] & SINGLE) != 0;
    }

    /** Whether an object is a disc as seen from above, where it is now. */
    public boolean isDisc(int id) {
        return (shapes[ObjectTable.local(id)] & DISC) != 0;
    }

    /** How to place a moveable object; made when it is first needed, as most only go straight on. */
    ObjectLeaves form(int id) {
        ObjectLeaves form = id < forms.length ? forms[id] : null;
        if (form == null) {
            if (id >= forms.length) {
                forms = Arrays.copyOf(forms, shapes.length);
            }
            GeometryObject object = objects.value(id);
            form = accuracy == Accuracy.EXACT
                    ? shared.computeIfAbsent(Shape.of(object), shape -> new ObjectLeaves(object, accuracy))
                    : made().of(object);
            forms[id] = form;
        }
        return form;
    }

    /** The leaves of all objects. */
    public LeafColumn leaves() {
        return leaves;
    }

    /** The first of an object's leaves. */
    public int first(int id) {
        return spans.first(ObjectTable.local(id));
    }

    /** How many leaves stand for an object. */
    public int count(int id) {
        return spans.count(ObjectTable.local(id));
    }

    /** Whether one leaf of half a row stands for an object: {@link #uprightLeaf}. */
    public boolean isUpright(int id) {
        return space == null && leaves.isUprightObject(ObjectTable.local(id));
    }

    /** The one leaf of an object that {@link #isUpright}. */
    public int uprightLeaf(int id) {
        return ObjectTable.local(id) | LeafColumn.UPRIGHT;
    }

    /** No object is wider to any side, however it turns: twice, as what stands for it may be wider than it is. */
    double widest() {
        return 2 * longest;
    }

    /** The bounds of all objects; an object's six numbers begin at {@link #boundsAt}. */
    public double[] bounds() {
        return tree.boxes();
    }

    /** Where an object's bounds begin. */
    public int boundsAt(int id) {
        return 6 * ObjectTable.local(id);
    }

    /** Whether an object's bounds meet a box of six numbers; heights count in SPATIAL only. */
    public boolean overlaps(int id, double[] box) {
        double[] bounds = tree.boxes();
        int b = boundsAt(id);
        return bounds[b] <= box[3]
                && box[0] <= bounds[b + 3]
                && bounds[b + 2] <= box[5]
                && box[2] <= bounds[b + 5]
                && (dimension == Dimension.PLANAR || (bounds[b + 1] <= box[4] && box[1] <= bounds[b + 4]));
    }
}
