package robosim.geometry.engine.broadphase;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.objects.Form;
import robosim.geometry.engine.objects.LeafRanges;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Attitude;
import robosim.geometry.index.Growth;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.QuadTree;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.OwnLeaves;

/**
 * A world as it is seen at one accuracy: every object's leaves in one column, their bounds, and the quadtree of the
 * static ones. A world has the level it was made for; another one is made when it is first asked.
 */
public final class AccuracyView {
    public final Accuracy accuracy;
    public final Dimension dimension;
    public final QuadTree tree;
    public final QuadCursor cursor;
    public final StaticSpaceIndex spaceIndex;

    /** More than any place or size in the plane. */
    public final double extent;

    /** Whether heights do not count, and objects are as they are. */
    final boolean isFlat;

    /** What ids of other objects have beside their number here: 0, or {@link ObjectTable#SHARED} in a view of what is shared. */
    public final int mark;

    /** The static objects that are shared with other worlds, as they are seen at this accuracy; null where there are none. */
    private @Nullable AccuracyView shared;

    private LeafColumn leaves;
    private final LeafRanges spans;

    /** Up to so many moveable objects are as quickly asked one by one; where there are more, the quadtree has them too. */
    private static final int FEW_MOVERS = 16;

    private int movers;
    private boolean hasMoversInTree;

    /** The longest sum of three sides of bounds that were taken in. */
    private double longest;

    /** How to place what moves; null where nobody has asked. */
    private @Nullable Form[] forms = new Form[0];

    /** What is known of each object beforehand. */
    private byte[] shapes;

    /** It moves, and convex leaves that go with it as they are stand for it. */
    private static final byte CONVEX = 1;

    /** And there is one, about its centre. */
    private static final byte SINGLE = 2;

    /** It is a disc as seen from above. */
    private static final byte DISC = 4;

    /** It moves. */
    private static final byte MOVER = 8;

    private final ObjectTable bodies;
    private final LeafColumn incoming = new LeafColumn(1);
    private final double[] part = new double[6];
    private final double[] box = new double[6];
    private final double[] attitude = new double[Attitude.STRIDE];

    AccuracyView(
            ObjectTable bodies,
            Accuracy accuracy,
            Dimension dimension,
            double width,
            double length,
            @Nullable AccuracyView shared) {
        this.bodies = bodies;
        this.shared = shared;
        mark = 0;
        leaves = new LeafColumn(1);
        leaves.reserveUpright(0);
        spans = new LeafRanges();
        shapes = new byte[Growth.FIRST];
        this.accuracy = accuracy;
        this.dimension = dimension;
        tree = new QuadTree(-width / 2, -length / 2, width / 2, length / 2, this::trim);
        cursor = tree.cursor();
        spaceIndex = new StaticSpaceIndex(dimension == Dimension.SPATIAL);
        extent = width + length;
        isFlat = dimension == Dimension.PLANAR && accuracy == Accuracy.EXACT;
    }

    private AccuracyView(AccuracyView of) {
        bodies = of.bodies;
        accuracy = of.accuracy;
        dimension = of.dimension;
        extent = of.extent;
        isFlat = of.isFlat;
        mark = ObjectTable.SHARED;
        tree = of.tree.view();
        cursor = tree.cursor();
        spaceIndex = of.spaceIndex.view();
        leaves = of.leaves.view();
        spans = of.spans;
        shapes = of.shapes;
        longest = of.longest;
    }

    /** Makes ready what is made when first asked: from now on nothing may change here, and many may ask its views. */
    void freeze() {
        tree.freeze();
        trim();
    }

    /** The same static objects as in a frozen level, for one more thread to ask. */
    AccuracyView view() {
        return new AccuracyView(this);
    }

    /** The level of the static objects that are shared; null where there are none. */
    @Nullable
    public AccuracyView shared() {
        return shared;
    }

    void unshare() {
        shared = null;
    }

    /** The level in which an object is, this one or that of what is shared; there it has its {@link ObjectTable#bare} id. */
    public AccuracyView of(int id) {
        AccuracyView other = shared;
        return id < ObjectTable.SHARED || other == null ? this : other;
    }

    /** Writes the leaves of an object at a place into a column that has room. */
    public void place(
            Form form, double cx, double cy, double cz, double[] rotation, int at, LeafColumn column, int firstLeaf) {
        form.place(dimension, cx, cy, cz, rotation, at, column, firstLeaf);
    }

    /** The same with all that heights reach to, even where an object is upright and they do not matter. */
    public void placeTipped(
            Form form, double cx, double cy, double cz, double[] rotation, int at, LeafColumn column, int firstLeaf) {
        form.place(Dimension.SPATIAL, cx, cy, cz, rotation, at, column, firstLeaf);
    }

    /** Makes a column hold what stands here for an object that is not, or not yet, in the world. */
    void placed(GeometryObject object, LeafColumn column) {
        if (accuracy == Accuracy.EXACT) {
            OwnLeaves.placed(object, column);
            return;
        }
        Form form = new Form(object, accuracy);
        column.clear();
        column.append(form.size());
        placeForm(form, object, column, 0);
    }

    private void placeForm(Form form, GeometryObject object, LeafColumn column, int firstLeaf) {
        object.pose().attitude(attitude, 0);
        Point c = object.center();
        place(form, c.x(), c.y(), c.z(), attitude, 0, column, firstLeaf);
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
        if (column.size() == 1 && accuracy == Accuracy.EXACT) {
            column.roughBounds(0, out);
        } else {
            boundsOf(column, 0, column.size(), out);
        }
    }

    /** Takes an object in that has been placed, with the bounds of what stands for it. */
    void add(int id, GeometryObject object, LeafColumn placed, double[] box) {
        reserve(id);
        int leaf = spans.claim(id, placed.size(), leaves, !object.isMoveable() && placed.fitsUpright());
        leaves.copy(placed, leaf);
        tree.keep(id, box);
        longest = Math.max(longest, Distance.sides(box));
        leaves.outline(id, box[0], box[2], box[3], box[5]);
        shapes[id] = placed.size() == 1 && leaves.kind(leaf).isDisc() ? DISC : 0;
        if (object.isMoveable()) {
            shapes[id] = (byte) (shapes[id] | MOVER | shape(id, object));
            movers++;
            countMovers(id);
        } else {
            spaceIndex.add(id, tree);
        }
    }

    private byte shape(int id, GeometryObject object) {
        if (accuracy != Accuracy.EXACT) {
            return 0;
        }
        return switch (object.kind()) {
            case BOX, CYLINDER, SPHERE -> CONVEX | SINGLE;
            case MESH -> 0;
            case GROUP -> form(id).own.hasMesh() ? 0 : CONVEX;
        };
    }

    /** Takes all moveable objects into the quadtree when there are no longer few. */
    private void countMovers(int last) {
        if (hasMoversInTree) {
            list(last);
        } else if (movers > FEW_MOVERS) {
            hasMoversInTree = true;
            for (int k = 0; k < bodies.moverCount(); k++) {
                int id = bodies.mover(k);
                if (id < shapes.length
                        && (shapes[id] & MOVER) != 0) { // not all are here yet where a level is being made
                    list(id);
                }
            }
        }
    }

    private void list(int id) {
        double[] b = bounds();
        int at = 6 * id;
        leaves.outline(id, b[at], b[at + 2], b[at + 3], b[at + 5]);
        tree.list(id);
    }

    /** How many moveable objects are not in the quadtree: all or none. */
    public int moversBesideTree() {
        return hasMoversInTree ? 0 : movers;
    }

    /** Gives up room that there is for more objects. */
    private void trim() {
        int limit = bodies.limit();
        if (Growth.isWasteful(limit, shapes.length)) {
            shapes = Arrays.copyOf(shapes, limit);
        }
        leaves.trim();
    }

    private void reserve(int id) {
        if (id >= shapes.length) {
            shapes = Arrays.copyOf(shapes, Growth.of(id));
        }
    }

    void remove(int id) {
        if (!bodies.isMoveable(id)) {
            spaceIndex.remove(id, tree);
        } else {
            movers--;
            tree.remove(id);
        }
        if (id < forms.length) {
            forms[id] = null;
        }
        shapes[id] = 0;
        leaves = spans.release(id, leaves);
    }

    /** Puts a moveable object where its place now says. */
    void move(int id, double[] places, int at) {
        place(form(id), places[at], places[at + 1], places[at + 2], places, at + 3, leaves, first(id));
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
            boundsOf(leaves, first(id), count(id), box);
            shapes[id] = (byte) (shapes[id] & ~DISC);
        } else {
            if (accuracy == Accuracy.EXACT) {
                leaves.roughBounds(first(id), box);
            } else {
                leaves.bounds(first(id), box);
            }
            shapes[id] = (byte) (leaves.kind(first(id)).isDisc() ? shapes[id] | DISC : shapes[id] & ~DISC);
        }
        if (hasMoversInTree) {
            leaves.outline(id, box[0], box[2], box[3], box[5]);
            tree.move(id, box);
        } else {
            tree.keep(id, box);
        }
    }

    /** Whether what stands for a moveable object here is made of convex leaves that go with it as they are. */
    public boolean keepsShape(int id) {
        return (shapes[id] & CONVEX) != 0;
    }

    /** Whether an object is a disc as seen from above, where it is now. */
    public boolean isDisc(int id) {
        return (shapes[id] & DISC) != 0;
    }

    /** The outward bounds of some leaves, six numbers. */
    public void boundsOf(LeafColumn column, int from, int number, double[] out) {
        if (number == 1) {
            column.bounds(from, out);
            return;
        }
        for (int k = 0; k < 3; k++) {
            out[k] = Double.POSITIVE_INFINITY;
            out[3 + k] = Double.NEGATIVE_INFINITY;
        }
        for (int leaf = from; leaf < from + number; leaf++) {
            column.bounds(leaf, part);
            for (int k = 0; k < 3; k++) {
                out[k] = Math.min(out[k], part[k]);
                out[3 + k] = Math.max(out[3 + k], part[3 + k]);
            }
        }
    }

    /** How to place a moveable object; made when it is first needed, as most only go straight on. */
    public Form form(int id) {
        Form form = id < forms.length ? forms[id] : null;
        if (form == null) {
            if (id >= forms.length) {
                forms = Arrays.copyOf(forms, shapes.length);
            }
            form = new Form(bodies.value(id), accuracy);
            forms[id] = form;
        }
        return form;
    }

    public LeafColumn leaves() {
        return leaves;
    }

    public int first(int id) {
        return spans.first(id);
    }

    public int count(int id) {
        return spans.count(id);
    }

    /** No object is wider to any side, however it turns: twice, as what stands for it may be wider than it is. */
    public double widest() {
        return 2 * longest;
    }

    /** The bounds of all objects: object id's six numbers begin at 6 id. */
    public double[] bounds() {
        return tree.boxes();
    }

    /** Whether an object's bounds meet a box of six numbers; heights count in SPATIAL only. */
    public boolean meets(int id, double[] box) {
        double[] bounds = tree.boxes();
        int b = 6 * id;
        return bounds[b] <= box[3]
                && box[0] <= bounds[b + 3]
                && bounds[b + 2] <= box[5]
                && box[2] <= bounds[b + 5]
                && (dimension == Dimension.PLANAR || (bounds[b + 1] <= box[4] && box[1] <= bounds[b + 4]));
    }
}
