package robosim.geometry.chart;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Finds room for words beside points: each goes where it covers nothing that was there before, or is left out. */
final class Labels {
    /** A rectangle by its corners. */
    record Place(double left, double top, double right, double bottom) {
        boolean meets(Place other) {
            return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
        }

        boolean isIn(Place other) {
            return left >= other.left && right <= other.right && top >= other.top && bottom <= other.bottom;
        }
    }

    /** Where to begin about a point, in steps of its distance: to the right first, then around. */
    private static final double[][] SIDES = {
        {1, 0, 0}, {0.6, -1, 0}, {0.6, 1, 0}, {-1, 0, 1}, {-0.6, -1, 1}, {-0.6, 1, 1}, {0, -1.2, 0.5}, {0, 1.2, 0.5}
    };

    private final Place bounds;
    private final List<Place> taken = new ArrayList<>();

    Labels(Place bounds) {
        this.bounds = bounds;
    }

    void take(double x, double y, double r) {
        taken.add(new Place(x - r, y - r, x + r, y + r));
    }

    /** Takes small places along a line between two points. */
    void takeLine(double x1, double y1, double x2, double y2) {
        int steps = (int) (Math.sqrt((x2 - x1) * (x2 - x1) + (y2 - y1) * (y2 - y1)) / 6) + 1;
        for (int k = 1; k < steps; k++) {
            take(x1 + (x2 - x1) * k / steps, y1 + (y2 - y1) * k / steps, 1.5);
        }
    }

    /** A free place for a text of a width and a height beside a point, which it takes; null where there is none. */
    @Nullable
    Place find(double x, double y, double width, double height) {
        for (double away : new double[] {9, 15, 23}) {
            for (double[] side : SIDES) {
                double left = x + side[0] * away - side[2] * width;
                double middle = y + side[1] * away * 0.95;
                Place place = new Place(left, middle - height / 2, left + width, middle + height / 2);
                if (place.isIn(bounds) && taken.stream().noneMatch(place::meets)) {
                    taken.add(place);
                    return place;
                }
            }
        }
        return null;
    }
}
