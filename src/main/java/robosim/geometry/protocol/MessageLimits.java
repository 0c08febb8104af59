package robosim.geometry.protocol;

import robosim.geometry.check.Checks;
import robosim.geometry.model.GridObject;

/** Limits on what a peer may send: each with its reason and the size of realistic data. */
public final class MessageLimits {
    private MessageLimits() {}

    /**
     * Maximum size of a message in bytes, so that no sender can fill the memory. A mesh of a million triangles takes 34
     * MB, a world of 100,000 boxes 18 MB, a grid of 4,000 x 4,000 cells 2 MB, a bundle of 1,000 sonar requests 33 kB.
     */
    public static final int MAX_MESSAGE_BYTES = 64 << 20;

    /**
     * Maximum nesting depth, so that no sender can exhaust the stack. A world takes 6 levels and each group around an
     * object 2 more: groups may be nested 28 deep, while a rack of shelves of boards is 3.
     */
    public static final int MAX_DEPTH = 64;

    /**
     * Maximum number of objects, arrays and references in one message and all earlier ones since the sender last reset
     * the stream, because an object stream keeps them all until then. A sender must therefore reset its stream,
     * preferably after each message. A mesh of a million triangles has a million arrays, a world of 100,000 boxes
     * 500,000 objects.
     */
    public static final int MAX_REFERENCES = 4_000_000;

    /**
     * Maximum length of an array of numbers. A mesh of a million vertices has 3,000,000 coordinates, a grid of 5,600 x
     * 5,600 cells 3,920,000 bytes of eight.
     */
    public static final int MAX_ARRAY_LENGTH = 4_000_000;

    /**
     * Maximum number of objects, requests or answers in one list, and of faces of one mesh. A swarm of 10,000 robots
     * has, with 16 sonars each, 160,000 requests.
     */
    public static final int MAX_LIST_LENGTH = 1_100_000;

    /**
     * Maximum number of parts of the objects in one message: an object counts once in each list that contains it, a
     * group as its members, a mesh as its triangles and a grid as its occupied cells and its bytes of eight cells,
     * because a few bytes can refer to the same object in many places. A mesh of a million triangles in a group has 3
     * million, a grid of 4,000 x 4,000 cells of which a tenth is occupied 3.6 million.
     */
    public static final long MAX_PARTS = 16_000_000;

    /**
     * Maximum number of pixels of all pictures of one message, counted at each that it has. Sixteen of 1024 x 1024 have as
     * many, of 3 bytes each; one picture is limited by {@link #MAX_ARRAY_LENGTH}, which is 1154 x 1154.
     */
    public static final int MAX_PIXELS = 1 << 24;

    /** The parts of a grid: a world looks at its occupied cells, and passes over the free ones many times as fast. */
    public static long parts(GridObject grid) {
        return Checks.present("grid", grid).cells().occupied() + (long) grid.columns() * grid.rows() / Byte.SIZE;
    }

    /**
     * Maximum number of beams in one bundle, because a few bytes can describe millions. A depth image of 1280 x 720 has
     * 921,600; a lidar of 128 layers has 262,144 in a turn.
     */
    public static final int MAX_BEAMS = 1 << 20;

    /**
     * Maximum number of pixels that one bundle may ask for. A picture of 1280 x 720 has 921,600, of 3 bytes each.
     */
    public static final int MAX_PICTURE_PIXELS = 1 << 20;

    /**
     * Maximum number of rays for the pictures that one bundle may ask for, counted as pixels times samples times the
     * sources of light and one times the mirrors and one, because a few bytes can describe hours of work. A picture of 1280 x 720
     * by one sun with three mirrors and four samples a pixel takes 29 million.
     */
    public static final int MAX_PICTURE_RAYS = 1 << 25;

    /**
     * Maximum number of poses and edges in one bundle. A planner asks for some thousands at once; the edges of a roadmap of
     * 10,000 poses are about 100,000.
     */
    public static final int MAX_POSES = 1 << 18;

    /**
     * Maximum length of a string in bytes of modified UTF-8: the limit of the short form in a Java stream. A name has
     * about 10 letters.
     */
    public static final int MAX_TEXT_BYTES = 65_535;

    /**
     * Maximum size in bytes of the hello with which a JSON peer begins, small since the peer is not admitted yet. A
     * secret has about 50.
     */
    public static final int MAX_HELLO_BYTES = 8192;
}
