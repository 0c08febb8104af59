package robosim.geometry.index.hierarchy;

/**
 * When a {@link Hierarchy} is built anew: when enough objects have come or gone since it was last built, and enough queries have
 * been asked since to pay for it.
 */
final class RebuildPolicy {
    /** So few changes are not worth a rebuild. */
    static final int FEW = 32;

    /** So few objects hang well enough in any order. */
    private static final int SMALL = 16;

    /** An object that comes or goes counts for as much as this many that merely leave the bounds of their node. */
    private static final int CAME = 16;

    /**
     * What an object that comes or goes takes from the queries that have been asked: as long as they alternate, nothing is
     * built anew.
     */
    private static final int CHANGE = 16;

    /** Changes since the last build: {@link #CAME} for each object that came or went, 1 for each that left its node. */
    private int changes;

    /** Queries since then, less what the changes took. */
    private int asked;

    void cameOrWent() {
        changes += CAME;
        asked = Math.max(0, asked - CHANGE);
    }

    /** Counts an object that has moved so far that it is hung from another node. */
    void hungElsewhere() {
        changes += CAME;
    }

    /** Counts an object that has moved a little beyond the bounds of its node. */
    void leftItsNode() {
        changes++;
    }

    boolean hasChanges() {
        return changes != 0;
    }

    /** Counts a query; whether the hierarchy is to be built anew before it. */
    boolean isDueAtQuery(int size) {
        if (changes == 0) {
            return false;
        }
        asked++;
        return size > SMALL && changes > FEW && changes >= 4L * size && 16L * asked >= size;
    }

    void reset() {
        changes = 0;
        asked = 0;
    }
}
