package robosim.geometry.world.shared;

/** How much a file may ask of its reader, with the size of the real thing. */
public final class Limits {
    /** Most problems of one file that are told; who has as many begins with the first. */
    public static final int MAX_PROBLEMS = 100;

    /** Bytes of one file of any format. A mesh of a million triangles takes some 60 MB as XML, OBJ or binary STL. */
    public static final long MAX_BYTES = 128L << 20;

    /** Boxes, cylinders, spheres, meshes and groups of one world, members too. The warehouse has some 2,700. */
    public static final int MAX_OBJECTS = 200_000;

    /** Elements of one file of SDFormat that matter. A world of 3,000 shapes has some 30,000. */
    public static final int MAX_ELEMENTS = 2_000_000;

    /** Models, links, frames and joints of one world with what it includes. A world of 3,000 shapes has 6,000. */
    public static final int MAX_FRAMES = 500_000;

    /** Bytes of all files that one file of SDFormat brings in: models and meshes. */
    public static final long MAX_INCLUDED_BYTES = 4 * MAX_BYTES;

    /** Vertices of all meshes of one file of SDFormat; each scale of a mesh counts anew. */
    public static final long MAX_VERTICES = 20_000_000;

    /** Characters of one attribute. The longest that has a use, a rotation with 9 exact numbers, has some 220. */
    public static final int MAX_ATTRIBUTE = 1000;

    /** Elements of XML within each other. Groups at their limit, or models at theirs with what is in them, have some 60. */
    public static final int MAX_DEPTH = 200;

    /** Bytes of one tag or comment of XML, which its parser keeps in memory. A mesh of 60,000 triangles has 4,000,000. */
    public static final int MAX_MARKUP = 4 << 20;

    /** Collections of a map's settings within each other. There is one, with one in it. */
    public static final int MAX_NESTED = 20;

    /** Groups within groups. The deepest tried in earnest is a shelf in a row in a hall: 3. */
    public static final int MAX_GROUPS = 50;

    /** Characters of one statement of an OBJ file. A polygon of 1,000 corners with all its indices has some 20,000. */
    public static final int MAX_STATEMENT = 100_000;

    /** Corners of one polygon of an OBJ file, which is cut into triangles in quadratic time: some milliseconds. */
    public static final int MAX_CORNERS = 1000;

    /** Faces of one mesh file, once its polygons are cut. One of 128 MB that is no list of the same faces has 3,000,000. */
    public static final int MAX_FACES = 5_000_000;

    /** Cells of one map. A hall of 200 x 200 m in cells of 5 cm has 16,000,000. */
    public static final int MAX_CELLS = 1 << 24;

    /** Bytes of a map's settings. The longest seen has 200. */
    public static final int MAX_SETTINGS = 64 << 10;

    private Limits() {}
}
