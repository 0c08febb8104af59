package robosim.geometry.protocol;

/** How much a peer may ask: each limit with its reason and the size of the real thing. */
public final class Limits {
    private Limits() {}

    /**
     * Most bytes of one message, so that no sender fills the memory. A mesh of a million triangles takes 34 MB, a world of
     * 100,000 boxes 18 MB, a bundle of 1,000 sonar requests 33 kB.
     */
    public static final int MAX_MESSAGE_BYTES = 64 << 20;

    /**
     * Deepest nesting, so that no sender exhausts the stack. A world takes 6 levels and each group around an object 2 more:
     * groups may be nested 28 deep, where a rack of shelves of boards is 3.
     */
    public static final int MAX_DEPTH = 64;

    /**
     * Most objects, arrays and references in one message and all before it since its sender last reset the stream, because
     * an object stream keeps them all until then: a sender must reset its stream, best after each message. A mesh of a
     * million triangles has a million arrays, a world of 100,000 boxes 500,000 objects.
     */
    public static final int MAX_REFERENCES = 4_000_000;

    /** Longest array of numbers. A mesh of a million vertices has 3,000,000 coordinates. */
    public static final int MAX_ARRAY_LENGTH = 4_000_000;

    /**
     * Most objects, requests or answers in one list, and faces of one mesh. A swarm of 10,000 robots has, with 16
     * sonars each, 160,000 requests.
     */
    public static final int MAX_LIST_LENGTH = 1_100_000;

    /**
     * Most parts of the objects in one message: an object counts once in each list that it is in, a group as its members
     * and a mesh as its triangles, because a few bytes can name the same member in many places. A mesh of a million
     * triangles in a group has 3 million.
     */
    public static final long MAX_PARTS = 16_000_000;

    /**
     * Longest text in bytes of modified UTF-8: what the short form of a Java stream can hold. A name is of some 10 letters.
     */
    public static final int MAX_TEXT_BYTES = 65_535;

    /** Most bytes of the hello with which a peer that speaks JSON begins: nobody has admitted it yet. A secret has some 50. */
    public static final int MAX_HELLO_BYTES = 8192;
}
