package robosim.geometry.narrow.leaf;

/**
 * The layout of one convex leaf in a flat column of doubles: {@link #STRIDE} numbers from an offset on, and a kind.
 *
 * <table>
 * <caption>What the numbers of each kind mean</caption>
 * <tr><th>kind</th><th>numbers</th></tr>
 * <tr><td>{@link #UPRIGHT_BOX}, {@link #BOX}</td><td>0-2 centre, 3-5 half sizes along the own axes, 6-14 rotation</td></tr>
 * <tr><td>{@link #UPRIGHT_CYLINDER}</td><td>0-2 centre, 3 radius, 4 half height</td></tr>
 * <tr><td>{@link #CYLINDER}</td><td>0-2 centre, 3 radius, 4 half height, 6-14 rotation; its axis is the own Y</td></tr>
 * <tr><td>{@link #SPHERE}</td><td>0-2 centre, 3 radius</td></tr>
 * <tr><td>{@link #TRIANGLE}</td><td>0-8 the three corners</td></tr>
 * <tr><td>{@link #PRISM}</td><td>least and greatest x (0, 1), z (2, 3), x+z (4, 5), x-z (6, 7) and y (8, 9)</td></tr>
 * </table>
 *
 * <p>A rotation is row-major and its columns are the own axes in the world. An upright box has its own Y along the
 * world's, so that [6] = [14] = cos, [8] = sin, [12] = -sin of its heading, and [10] = 1. Zero sizes are legal.
 */
public final class Leaf {
    /** Number of doubles in a row. */
    public static final int STRIDE = 16;

    public static final int UPRIGHT_BOX = 0;
    public static final int UPRIGHT_CYLINDER = 1;
    public static final int SPHERE = 2;
    public static final int BOX = 3;
    public static final int CYLINDER = 4;
    public static final int TRIANGLE = 5;
    public static final int PRISM = 6;

    /** The number of convex kinds; the kinds after them consist of triangles. */
    public static final int KINDS = 7;

    /** A surface of triangles: 0-2 centre, 6-14 rotation; the triangles are stored separately. */
    public static final int MESH = 7;

    /** A closed surface with its inside. */
    public static final int SOLID_MESH = 8;

    /** Where the half sizes, or the radius and half height, begin. */
    public static final int SIZE = 3;

    /** Where the nine numbers of the rotation begin. */
    public static final int ROTATION = 6;

    private Leaf() {}

    /** Whether the kind is a mesh. */
    public static boolean isMesh(int kind) {
        return kind >= MESH;
    }

    /** Whether the kind is a vertical prism: a flat base on an interval of heights. */
    public static boolean isUpright(int kind) {
        return kind == UPRIGHT_BOX || kind == UPRIGHT_CYLINDER || kind == PRISM;
    }

    /** Whether the kind projects to a disc on XZ. */
    public static boolean isDisc(int kind) {
        return kind == UPRIGHT_CYLINDER || kind == SPHERE;
    }
}
