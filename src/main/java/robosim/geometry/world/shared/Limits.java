package robosim.geometry.world.shared;

/** Limits on files, each with the size of realistic ones. */
public final class Limits {
    /** Maximum number of problems reported for one file. */
    public static final int MAX_PROBLEMS = 100;

    /** Bytes of one file of any format. A mesh of a million triangles takes about 60 MB as XML, OBJ or binary STL. */
    public static final long MAX_BYTES = 128L << 20;

    /** Objects of one world, members included. The warehouse has about 2,700. */
    public static final int MAX_OBJECTS = 200_000;

    /** Materials of one world file. A hall with a material for each of its 2,700 objects has as many. */
    public static final int MAX_MATERIALS = 100_000;

    /** Elements of one SDFormat file that are read. A world of 3,000 shapes has about 30,000. */
    public static final int MAX_ELEMENTS = 2_000_000;

    /** Models, links, frames and joints of one world, including included files. A world of 3,000 shapes has 6,000. */
    public static final int MAX_FRAMES = 500_000;

    /** Bytes of all files that one SDFormat file includes: models and meshes. */
    public static final long MAX_INCLUDED_BYTES = 4 * MAX_BYTES;

    /** Vertices of all meshes of one SDFormat file; each scale of a mesh counts separately. */
    public static final long MAX_VERTICES = 20_000_000;

    /** Characters of one attribute. The longest useful one, a rotation of 9 exact numbers, has about 220. */
    public static final int MAX_ATTRIBUTE = 1000;

    /** Nesting depth of XML elements. Groups or models at their own limits reach about 60. */
    public static final int MAX_DEPTH = 200;

    /** Bytes of one tag or comment of XML, which its parser keeps in memory. A mesh of 60,000 triangles has 4,000,000. */
    public static final int MAX_MARKUP = 4 << 20;

    /** Nesting depth of collections in a map's settings. Valid ones have depth 2. */
    public static final int MAX_NESTED = 20;

    /** Nesting depth of groups. The deepest realistic case tried is a shelf in a row in a hall: 3. */
    public static final int MAX_GROUPS = 50;

    /** Characters of one statement of an OBJ file. A polygon of 1,000 corners with all its indices has about 20,000. */
    public static final int MAX_STATEMENT = 100_000;

    /** Corners of one polygon of an OBJ file, which is cut into triangles in quadratic time: a few milliseconds. */
    public static final int MAX_CORNERS = 1000;

    /** Faces of one mesh file, after its polygons are cut. A file of 128 MB has 3,000,000, unless it repeats faces. */
    public static final int MAX_FACES = 5_000_000;

    /** Numbers of one COLLADA file. A file of 128 MB has 15,000,000 of 8 digits each. */
    public static final int MAX_NUMBERS = 20_000_000;

    /**
     * Cells of all grids that one world file spells out, since a few characters may claim any number. A hall of 200 x
     * 200 m with cells of 5 cm has 16,000,000, which take 16 MB of memory.
     */
    public static final int MAX_CELLS = 1 << 24;

    /**
     * Pixels of the image of a map, and cells of all maps that one world includes, each of which takes a byte: as many as
     * one grid may have. A town of 800 x 800 m with cells of 5 cm has 256,000,000.
     */
    public static final int MAX_MAP_CELLS = 1 << 28;

    /** Bytes of the image of a map: two for each pixel, and a header. */
    public static final long MAX_IMAGE_BYTES = 2L * MAX_MAP_CELLS + (64 << 10);

    /** Bytes of a map's settings. The longest seen has 200. */
    public static final int MAX_SETTINGS = 64 << 10;

    private Limits() {}
}
