package robosim.geometry.world.check;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.Contact;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.Verdict;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;

/** Contacts of two objects, of a grid by its cells near the other object. */
final class Pieces {
    private Pieces() {}

    /** A contact of two objects; null if there is none. */
    static @Nullable Contact contact(GeometryObject a, GeometryObject b, Dimension dimension) {
        for (GeometryObject partOfA : near(a, b.bounds())) {
            for (GeometryObject partOfB : near(b, partOfA.bounds())) {
                List<Contact> contacts = ContactQuery.contacts(partOfA, partOfB, dimension, 1);
                if (!contacts.isEmpty()) {
                    return contacts.get(0);
                }
            }
        }
        return null;
    }

    static boolean touch(GeometryObject a, GeometryObject b, Dimension dimension) {
        for (GeometryObject partOfA : near(a, b.bounds())) {
            for (GeometryObject partOfB : near(b, partOfA.bounds())) {
                if (ContactQuery.ask(partOfA, partOfB, dimension, Budget.UNLIMITED)
                                .answer()
                        == Verdict.Answer.YES) {
                    return true;
                }
            }
        }
        return false;
    }

    /** The object; or the occupied cells of a grid that may touch what these bounds hold, and a cell more all round. */
    private static List<GeometryObject> near(GeometryObject object, Bounds bounds) {
        if (!(object instanceof GridObject grid)) {
            return List.of(object);
        }
        double[] columns = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        double[] rows = columns.clone();
        for (int corner = 0; corner < 4; corner++) {
            double x = (corner & 1) == 0 ? bounds.minX() : bounds.maxX();
            double z = corner < 2 ? bounds.minZ() : bounds.maxZ();
            extend(columns, along(grid, x, z, 0) + grid.columns() / 2.0);
            extend(rows, along(grid, x, z, 2) + grid.rows() / 2.0);
        }
        List<GeometryObject> cells = new ArrayList<>();
        for (int row = first(rows); row <= last(rows, grid.rows()); row++) {
            for (int column = first(columns); column <= last(columns, grid.columns()); column++) {
                if (grid.isOccupied(column, row)) {
                    cells.add(grid.box(column, row));
                }
            }
        }
        return cells;
    }

    /** A coordinate of a point along the grid's own X (0) or Z (2), in cells from its middle. */
    private static double along(GridObject grid, double x, double z, int axis) {
        Point c = grid.center();
        return (grid.pose().rotation(axis) * (x - c.x()) + grid.pose().rotation(6 + axis) * (z - c.z())) / grid.cell();
    }

    private static void extend(double[] range, double value) {
        range[0] = Math.min(range[0], value);
        range[1] = Math.max(range[1], value);
    }

    private static int first(double[] range) {
        return (int) Math.max(0, Math.floor(range[0]) - 1);
    }

    private static int last(double[] range, int count) {
        return (int) Math.min(count - 1.0, Math.floor(range[1]) + 1);
    }
}
