package robosim.geometry.engine.objects;

import java.util.Arrays;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * Which leaves of a column stand for which object. While every object has exactly one half-row leaf, that is the leaf
 * of the object's own number and nothing is looked up. Once an object has other leaves, each object's first leaf and
 * number of leaves are stored.
 */
public final class LeafRanges {
    private static final int UPRIGHT = LeafColumn.UPRIGHT;

    private boolean isPlain = true;

    private int[] first = new int[0];
    private int[] count = new int[0];

    /** Number of full-row leaves that no object uses any more. */
    private int unused;

    public int first(int id) {
        return isPlain ? id | UPRIGHT : first[id];
    }

    public int count(int id) {
        return isPlain ? 1 : count[id];
    }

    /**
     * Makes room in a column for the leaves of an object and returns the first one's number.
     *
     * @param upright whether it is a single half-row leaf
     */
    public int claim(int id, int number, LeafColumn column, boolean upright) {
        column.reserveUpright(id);
        if (upright) {
            if (!isPlain) {
                reserve(id);
                count[id] = 1;
                first[id] = id | UPRIGHT;
            }
            return id | UPRIGHT;
        }
        return claimWhole(id, number, column);
    }

    /** Makes room in a column for the leaves of an object as full rows and returns the first one's number. */
    public int claimWhole(int id, int number, LeafColumn column) {
        if (isPlain) {
            lookUp(column);
        }
        reserve(id);
        first[id] = column.append(number);
        count[id] = number;
        return first[id];
    }

    private void reserve(int id) {
        if (id >= first.length) {
            int capacity = id + (id >> 1) + 1;
            first = Arrays.copyOf(first, capacity);
            count = Arrays.copyOf(count, capacity);
        }
    }

    private void lookUp(LeafColumn column) {
        isPlain = false;
        first = new int[column.uprightSize()];
        count = new int[first.length];
        for (int id = 0; id < first.length; id++) {
            first[id] = id | UPRIGHT;
            count[id] = column.isVacant(first[id]) ? 0 : 1;
        }
    }

    /**
     * Gives up the leaves of an object; returns the column, or a smaller one if the old one had become mostly empty.
     */
    public LeafColumn release(int id, LeafColumn column) {
        if (isPlain || (first[id] & UPRIGHT) != 0) {
            column.vacate(id | UPRIGHT);
            if (!isPlain) {
                count[id] = 0;
            }
            return column;
        }
        unused += count[id];
        count[id] = 0;
        if (unused <= 64 || unused <= column.size() / 2) {
            return column;
        }
        LeafColumn tight = column.withUpright(Math.max(0, column.size() - unused));
        for (int each = 0; each < first.length; each++) {
            if (count[each] > 0 && (first[each] & UPRIGHT) == 0) {
                first[each] = tight.appendWhole(column, first[each], count[each]);
            }
        }
        unused = 0;
        return tight;
    }
}
