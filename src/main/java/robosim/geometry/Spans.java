package robosim.geometry;

import java.util.Arrays;
import robosim.geometry.narrow.LeafColumn;

/**
 * Which leaves of a column stand for which object. As long as each object has one, and all are of one sort, that is the
 * leaf of the object's own number, and nothing has to be looked up; from the first one on that has more, or another sort, a
 * place and a number for each.
 */
final class Spans {
    private static final int UPRIGHT = LeafColumn.UPRIGHT;

    private boolean isPlain = true;

    /** Where nothing has to be looked up, what all leaves' numbers have beside the object's. */
    private int sort;

    private int[] first = new int[0];
    private int[] count = new int[0];

    /** Leaves that no object uses any more. */
    private int unused;

    int first(int id) {
        return isPlain ? id | sort : first[id];
    }

    int count(int id) {
        return isPlain ? 1 : count[id];
    }

    /**
     * Makes room in a column for the leaves of an object and answers the first one's number.
     *
     * @param upright whether it is one leaf of half a row
     */
    int claim(int id, int number, LeafColumn column, boolean upright) {
        int wanted = upright ? UPRIGHT : 0;
        if (isPlain && size(column) == 0) {
            sort = wanted;
        }
        if (isPlain && number == 1 && sort == wanted) {
            for (int next = size(column); next <= id; next++) {
                column.vacate(append(column, upright));
            }
            return id | sort;
        }
        if (isPlain) {
            lookUp(column);
        }
        if (id >= first.length) {
            int capacity = id + (id >> 1) + 1;
            first = Arrays.copyOf(first, capacity);
            count = Arrays.copyOf(count, capacity);
        }
        first[id] = upright ? column.appendUpright() : column.append(number);
        count[id] = number;
        return first[id];
    }

    private static int append(LeafColumn column, boolean upright) {
        return upright ? column.appendUpright() : column.append(1);
    }

    private static int size(LeafColumn column) {
        return column.size() + column.uprightSize();
    }

    private void lookUp(LeafColumn column) {
        isPlain = false;
        first = new int[size(column)];
        count = new int[first.length];
        for (int id = 0; id < first.length; id++) {
            first[id] = id | sort;
            count[id] = column.isVacant(first[id]) ? 0 : 1;
            unused += 1 - count[id];
        }
    }

    /** Gives up the leaves of an object; answers the column, or a smaller one where the old one had become mostly empty. */
    LeafColumn release(int id, LeafColumn column) {
        if (isPlain) {
            column.vacate(id | sort);
            return column;
        }
        unused += count[id];
        count[id] = 0;
        if (unused <= 64 || unused <= size(column) / 2) {
            return column;
        }
        LeafColumn tight = new LeafColumn(Math.max(0, column.size() - unused));
        for (int each = 0; each < first.length; each++) {
            if (count[each] > 0) {
                first[each] = tight.appendCopy(column, first[each], count[each]);
            }
        }
        unused = 0;
        return tight;
    }
}
