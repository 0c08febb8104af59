package robosim.geometry.narrow.leaf;

import robosim.geometry.model.GeometryObject;

/**
 * What a leaf is; {@link Leaf} tells what the numbers of each kind mean. Whoever adds a kind answers here what it is like, and
 * the compiler leads to each kernel that has to know it. The order counts where a pair is brought into one order.
 */
public enum LeafKind {
    UPRIGHT_BOX(Layout.CENTRE, Surface.FLAT, Heights.INTERVAL, FromAbove.POLYGON, 6, 15),
    UPRIGHT_CYLINDER(Layout.CENTRE, Surface.ROUND, Heights.INTERVAL, FromAbove.DISC, 5, 5),
    SPHERE(Layout.CENTRE, Surface.ROUND, Heights.LEVELS, FromAbove.DISC, 4, 4),
    BOX(Layout.CENTRE, Surface.FLAT, Heights.TURNED, FromAbove.POLYGON, 6, 15),
    CYLINDER(Layout.CENTRE, Surface.ROUND, Heights.TURNED, FromAbove.OVAL, 5, 15),
    TRIANGLE(Layout.CORNERS, Surface.FLAT, Heights.LEVELS, FromAbove.POLYGON, 9, 9),
    PRISM(Layout.RANGES, Surface.ENCLOSING, Heights.INTERVAL, FromAbove.POLYGON, 10, 10),
    UPRIGHT_CAPSULE(Layout.CENTRE, Surface.ROUND, Heights.ENDS, FromAbove.DISC, 5, 5),
    CAPSULE(Layout.CENTRE, Surface.ROUND, Heights.TURNED, FromAbove.OVAL, 5, 15),

    /** A surface of triangles. */
    MESH(Layout.CENTRE, Surface.TRIANGLES, Heights.TURNED, FromAbove.TRIANGLES, 3, 15),

    /** A closed surface with its inside. */
    SOLID_MESH(Layout.CENTRE, Surface.TRIANGLES, Heights.TURNED, FromAbove.TRIANGLES, 3, 15),

    /** The occupied cells of a grid, upright boxes of one height. */
    GRID(Layout.CENTRE, Surface.CELLS, Heights.INTERVAL, FromAbove.CELLS, 5, 15);

    /** What a row begins with. */
    public enum Layout {
        /** The centre, and then sizes, which stay where it moves. */
        CENTRE,
        /** Three corners. */
        CORNERS,
        /** The least and the greatest of each of five coordinates. */
        RANGES
    }

    /** What the surface is made of. */
    private enum Surface {
        FLAT,
        /** Some of it is curved. */
        ROUND,
        /** Flat, and somewhere outside what it stands for. */
        ENCLOSING,
        TRIANGLES,
        CELLS
    }

    /** A shape with flat sides whose numbers are its own: for kernels of these alone. */
    public enum Polytope {
        BOX,
        TRIANGLE
    }

    /** How the least and the greatest height are told. */
    private enum Heights {
        /** It is a vertical prism: a flat base on an interval of heights, [1] - [4] to [1] + [4] or (as ranges) [8] to [9]. */
        INTERVAL,
        /** Both are sums of two numbers of the row. */
        LEVELS,
        /** Both are sums of three. */
        ENDS,
        /** They depend on a rotation. */
        TURNED
    }

    /** The outline as seen from above. */
    public enum FromAbove {
        POLYGON,
        DISC,
        /** That of a turned cylinder or capsule: two ends that are half ellipses or half discs, and two sides between them. */
        OVAL,
        TRIANGLES,
        CELLS
    }

    private static final LeafKind[] ALL = values();

    private final Layout layout;
    private final Surface surface;
    private final Heights heights;
    private final FromAbove fromAbove;
    private final int lengths;
    private final int numbers;

    LeafKind(Layout layout, Surface surface, Heights heights, FromAbove fromAbove, int lengths, int numbers) {
        this.layout = layout;
        this.surface = surface;
        this.heights = heights;
        this.fromAbove = fromAbove;
        this.lengths = lengths;
        this.numbers = numbers;
    }

    /** That of an object given by sizes, in any attitude. */
    static LeafKind of(GeometryObject.Kind kind) {
        return switch (kind) {
            case BOX -> BOX;
            case CYLINDER -> CYLINDER;
            case SPHERE -> SPHERE;
            case CAPSULE -> CAPSULE;
            case MESH, GROUP, GRID ->
                throw new IllegalArgumentException("object must be given by sizes (got: a " + kind.word() + ")");
        };
    }

    /** The kind of this round shape whose axis is the vertical; this one if it is upright or has no axis. */
    LeafKind upright() {
        return this == CYLINDER ? UPRIGHT_CYLINDER : this == CAPSULE ? UPRIGHT_CAPSULE : this;
    }

    /** The kind with a code. */
    static LeafKind of(byte code) {
        return ALL[code];
    }

    /** The first of several kinds: see {@link LeafColumn#kinds}. */
    public static LeafKind first(int kinds) {
        return ALL[Integer.numberOfTrailingZeros(kinds)];
    }

    /** The kind as a byte, at least 0; of this build only, never stored. */
    @SuppressWarnings("EnumOrdinal")
    byte code() {
        return (byte) ordinal();
    }

    public Layout layout() {
        return layout;
    }

    /** Whether it is made of triangles, which stand beside the row. */
    public boolean isMesh() {
        return surface == Surface.TRIANGLES;
    }

    /** Whether it is the cells of a grid, which stand beside the row. */
    public boolean isGrid() {
        return surface == Surface.CELLS;
    }

    /** Whether it is made of many pieces, each of which is one of its own to a mover: a mesh or a grid. */
    public boolean hasPieces() {
        return isMesh() || isGrid();
    }

    /** Whether it is a {@link Polytope}. */
    public boolean isPolytope() {
        return surface == Surface.FLAT;
    }

    /** Which polytope it is. */
    public Polytope polytope() {
        return switch (this) {
            case UPRIGHT_BOX, BOX -> Polytope.BOX;
            case TRIANGLE -> Polytope.TRIANGLE;
            case UPRIGHT_CYLINDER, SPHERE, CYLINDER, PRISM, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID ->
                throw refused();
        };
    }

    /** Whether it is convex and some of its surface is curved, unless its radius is 0. */
    public boolean isRound() {
        return surface == Surface.ROUND;
    }

    /** Whether it is a vertical prism: a flat base on an interval of heights. */
    public boolean isVerticalPrism() {
        return heights == Heights.INTERVAL;
    }

    /** Whether its least and its greatest height are sums of two numbers of the row. */
    public boolean hasLevels() {
        return heights == Heights.INTERVAL || heights == Heights.LEVELS;
    }

    /** Whether it has any attitude, which the nine numbers of its rotation tell. */
    public boolean isTurned() {
        return heights == Heights.TURNED;
    }

    public FromAbove fromAbove() {
        return fromAbove;
    }

    /** Whether it is a disc as seen from above, whatever its attitude. */
    public boolean isDisc() {
        return fromAbove == FromAbove.DISC;
    }

    /** Whether it only stands for something inside it and is rounded outward, so that nothing about it need be exact. */
    public boolean isEnclosure() {
        return surface == Surface.ENCLOSING;
    }

    /** Whether it is a box, upright or turned. */
    public boolean isBox() {
        return this == UPRIGHT_BOX || this == BOX;
    }

    /** Whether it is a cylinder, upright or turned. */
    public boolean isCylinder() {
        return this == UPRIGHT_CYLINDER || this == CYLINDER;
    }

    /** Whether it is a capsule, upright or turned. */
    public boolean isCapsule() {
        return this == UPRIGHT_CAPSULE || this == CAPSULE;
    }

    /** The number of lengths at the beginning of a row; the rest is a rotation or unused. */
    public int lengths() {
        return lengths;
    }

    /** How many numbers of a row mean something, those between them included. */
    public int numbers() {
        return numbers;
    }

    /** What a kernel throws that is not for this kind. */
    public IllegalArgumentException refused() {
        return new IllegalArgumentException("no kernel for this kind of leaf (got: " + this + ")");
    }
}
