package robosim.geometry;

import java.util.Arrays;
import robosim.geometry.narrow.LeafColumn;

/**
 * Which leaves of a column stand for which object. As long as each object has one, that is the leaf of the object's own
 * number, and nothing has to be looked up; from the first one on that has more, a place and a number for each.
 */
final class Spans {
    private boolean isPlain = true;
    private int[] first = new int[0];
    private int[] count = new int[0];

    /** Leaves that no object uses any more. */
    private int unused;

    int first(int id) {
        return isPlain ? id : first[id];
    }

    int count(int id) {
        return isPlain ? 1 : count[id];
    }

    /** Makes room in a column for the leaves of an object and answers the first one's index. */
    int claim(int id, int number, LeafColumn column) {
        if (isPlain && number == 1) {
            int size = column.size();
            if (id >= size) {
                column.append(id + 1 - size);
                for (int gap = size; gap < id; gap++) {
                    column.vacate(gap);
                }
            }
            return id;
        }
        if (isPlain) {
            lookUp(column);
        }
        if (id >= first.length) {
            int capacity = id + (id >> 1) + 1;
            first = Arrays.copyOf(first, capacity);
            count = Arrays.copyOf(count, capacity);
        }
        first[id] = column.append(number);
        count[id] = number;
        return first[id];
    }

    private void lookUp(LeafColumn column) {
        isPlain = false;
        first = new int[column.size()];
        count = new int[column.size()];
        for (int id = 0; id < first.length; id++) {
            first[id] = id;
            count[id] = column.isVacant(id) ? 0 : 1;
            unused += 1 - count[id];
        }
    }

    /** Gives up the leaves of an object; answers the column, or a smaller one where the old one had become mostly empty. */
    LeafColumn release(int id, LeafColumn column) {
        if (isPlain) {
            column.vacate(id);
            return column;
        }
        unused += count[id];
        count[id] = 0;
        if (unused <= 64 || unused <= column.size() / 2) {
            return column;
        }
        LeafColumn tight = new LeafColumn(column.size() - unused);
        for (int each = 0; each < first.length; each++) {
            if (count[each] > 0) {
                first[each] = tight.appendCopy(column, first[each], count[each]);
            }
        }
        unused = 0;
        return tight;
    }
}
