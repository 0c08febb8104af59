package robosim.geometry.dynamics.planar;

import java.util.Arrays;
import java.util.List;
import robosim.geometry.exact.Orientation;
import robosim.geometry.exact.Radians;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.RoundedBox;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/**
 * Takes objects apart into convex pieces as seen from above. Only a tipped cylinder has a shape that is not kept: a polygon
 * around its rims stands for it, at most 0.5 % larger.
 */
final class PieceOutlines {
    /** Corners of the polygon around the rim of a tipped cylinder. */
    private static final int RIM = 32;

    private final ConvexPieces pieces;
    private int body;
    private int object;

    // The centre that corners are told from, and the body's axes.
    private double centerX;
    private double centerZ;
    private double cos;
    private double sin;

    /** The points of which the next piece is the hull. */
    private double[] points = new double[2 * 64];

    private int[] hull = new int[2 * 64];

    private int count;

    PieceOutlines(ConvexPieces pieces) {
        this.pieces = pieces;
    }

    /** Adds what stands still, in the world's axes. */
    void addStill(int id, GeometryObject placed) {
        add(-1, id, placed, 0, 0, 1, 0);
    }

    /** Adds the pieces of a body, told from its centre in axes that are turned by its heading. */
    void add(int ofBody, int id, GeometryObject placed, double x, double z, double cosine, double sine) {
        body = ofBody;
        object = id;
        centerX = x;
        centerZ = z;
        cos = cosine;
        sin = sine;
        add(placed);
    }

    private void add(GeometryObject placed) {
        if (placed instanceof ObjectGroup group) {
            for (GeometryObject part : group.parts()) {
                add(part.at(part.pose().within(placed.pose())));
            }
        } else if (placed instanceof MeshObject mesh) {
            addFaces(mesh);
        } else if (placed instanceof GridObject grid) {
            addCells(grid);
        } else {
            addSolid(placed.roundedBox(), placed.pose());
        }
    }

    private void addSolid(RoundedBox box, Pose pose) {
        double[] r = pose.rotation();
        Point c = pose.center();
        if (box.disc() == 0) {
            addBox(c, r, box);
        } else if (pose.isUpright()) {
            addDisc(c, box.disc());
        } else {
            addTipped(c, r, box.disc(), box.halfHeight());
        }
    }

    private void addDisc(Point c, double radius) {
        count = 0;
        point(c.x(), c.z());
        addHull(radius);
    }

    private void addBox(Point c, double[] r, RoundedBox box) {
        count = 0;
        for (int corner = 0; corner < 8; corner++) {
            double a = (corner & 1) == 0 ? box.halfWidth() : -box.halfWidth();
            double b = (corner & 2) == 0 ? box.halfLength() : -box.halfLength();
            double up = (corner & 4) == 0 ? box.halfHeight() : -box.halfHeight();
            if (up > 0 || r[1] != 0 || r[7] != 0 || up == 0) {
                point(c.x() + (r[0] * a + r[2] * b) + r[1] * up, c.z() + (r[6] * a + r[8] * b) + r[7] * up);
            }
        }
        addHull(box.ball());
    }

    private void addTipped(Point c, double[] r, double radius, double half) {
        count = 0;
        double around = radius / Radians.cos(StrictMath.PI / RIM);
        for (int k = 0; k < RIM; k++) {
            double a = around * Radians.cos(2 * StrictMath.PI * k / RIM);
            double b = around * Radians.sin(2 * StrictMath.PI * k / RIM);
            double x = r[0] * a + r[2] * b;
            double z = r[6] * a + r[8] * b;
            point(c.x() + x + r[1] * half, c.z() + z + r[7] * half);
            point(c.x() + x - r[1] * half, c.z() + z - r[7] * half);
        }
        addHull(0);
    }

    private void addFaces(MeshObject mesh) {
        double[] r = mesh.rotation();
        Point c = mesh.center();
        List<Point> vertices = mesh.vertices();
        for (int[] face : mesh.faces()) {
            for (int half = 0; half + 2 < face.length; half++) {
                count = 0;
                for (int corner : new int[] {face[0], face[half + 1], face[half + 2]}) {
                    Point v = vertices.get(corner);
                    point(
                            c.x() + r[0] * v.x() + r[1] * v.y() + r[2] * v.z(),
                            c.z() + r[6] * v.x() + r[7] * v.y() + r[8] * v.z());
                }
                addHull(0);
            }
        }
    }

    /** The runs of occupied cells along a row: all cells, as what is clear of them has to be clear of the grid. */
    private void addCells(GridObject grid) {
        for (int row = 0; row < grid.rows(); row++) {
            int from = -1;
            for (int column = 0; column <= grid.columns(); column++) {
                boolean isOccupied = column < grid.columns() && grid.isOccupied(column, row);
                if (isOccupied && from < 0) {
                    from = column;
                } else if (!isOccupied && from >= 0) {
                    addRun(grid.box(from, row), grid.box(column - 1, row));
                    from = -1;
                }
            }
        }
    }

    /** The hull of two cells: of a grid that is turned by quarter turns they face +X, and the run may go any way. */
    private void addRun(BoxObject first, BoxObject last) {
        double[] r = first.rotation();
        double width = first.width() / 2;
        double length = first.length() / 2;
        count = 0;
        for (int corner = 0; corner < 4; corner++) {
            double a = (corner & 1) == 0 ? width : -width;
            double b = (corner & 2) == 0 ? length : -length;
            point(first.center().x() + (r[0] * a + r[2] * b), first.center().z() + (r[6] * a + r[8] * b));
            point(last.center().x() + (r[0] * a + r[2] * b), last.center().z() + (r[6] * a + r[8] * b));
        }
        addHull(0);
    }

    private void point(double x, double z) {
        if (2 * count == points.length) {
            points = Arrays.copyOf(points, 4 * count);
        }
        double fromX = x - centerX;
        double fromZ = z - centerZ;
        points[2 * count] = fromX * cos - fromZ * sin;
        points[2 * count + 1] = fromX * sin + fromZ * cos;
        count++;
    }

    /**
     * The convex hull of the points, counter-clockwise from the leftmost, by Andrew's monotone chains (1979). Sides are decided
     * exactly: of a rim seen from its side all points lie on a line but for rounding.
     */
    private void addHull(double radius) {
        pieces.begin(body, object, radius);
        sort();
        if (hull.length < 2 * count) {
            hull = new int[2 * count];
        }
        int size = 0;
        for (int k = 0; k < count; k++) {
            size = chain(size, 0, k);
        }
        int least = size - 1;
        for (int k = count - 2; k >= 0; k--) {
            size = chain(size, least, k);
        }
        for (int k = 0; k < Math.max(1, size - 1); k++) {
            pieces.corner(points[2 * hull[k]], points[2 * hull[k] + 1]);
        }
    }

    /** Adds a point to a chain that begins at an index of the hull, and drops what then is not outermost. */
    private int chain(int size, int from, int k) {
        int to = size;
        if (to > 0 && isSame(hull[to - 1], k)) {
            return to;
        }
        while (to - from >= 2 && side(hull[to - 2], hull[to - 1], k) <= 0) {
            to--;
        }
        hull[to] = k;
        return to + 1;
    }

    private int side(int a, int b, int c) {
        return Orientation.side(
                points[2 * a], points[2 * a + 1], points[2 * b], points[2 * b + 1], points[2 * c], points[2 * c + 1]);
    }

    /** Sorts the points by their first coordinate, then by the other. */
    private void sort() {
        for (int k = 1; k < count; k++) {
            double px = points[2 * k];
            double pz = points[2 * k + 1];
            int to = k;
            while (to > 0 && (points[2 * to - 2] > px || (points[2 * to - 2] == px && points[2 * to - 1] > pz))) {
                points[2 * to] = points[2 * to - 2];
                points[2 * to + 1] = points[2 * to - 1];
                to--;
            }
            points[2 * to] = px;
            points[2 * to + 1] = pz;
        }
    }

    private boolean isSame(int a, int b) {
        return points[2 * a] == points[2 * b] && points[2 * a + 1] == points[2 * b + 1];
    }
}
