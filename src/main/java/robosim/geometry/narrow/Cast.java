package robosim.geometry.narrow;

import robosim.geometry.exact.VectorMath;
import robosim.geometry.index.tiles.OrientedRectangle;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.cone.PlanarCone;
import robosim.geometry.narrow.cone.SpatialCone;
import robosim.geometry.narrow.leaf.GridWalk;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.UnderflowScaling;
import robosim.geometry.narrow.leaf.UprightRows;
import robosim.geometry.narrow.mesh.KnownInside;
import robosim.geometry.narrow.mesh.MeshRay;
import robosim.geometry.narrow.mesh.PointInMesh;
import robosim.geometry.narrow.normal.Normals;
import robosim.geometry.narrow.ray.PlanarRay;
import robosim.geometry.narrow.ray.RayDisc;
import robosim.geometry.narrow.ray.RayRectangle;
import robosim.geometry.narrow.ray.SpatialRay;

/**
 * Casts a line or a cone against one placed leaf, meshes and grids included: the only switch over leaf kinds for beams. An
 * instance holds the beam and belongs to one owner of queries.
 */
public final class Cast {
    /** How often a normal is tilted at most, as a power of two. */
    private static final double MOST_TILT = 0x1p20;

    private final Scratch s;
    private final Normals normals = new Normals();

    private Dimension dimension = Dimension.SPATIAL;
    private double ox;
    private double oy;
    private double oz;
    private double dx;
    private double dy;
    private double dz;
    private double ux;
    private double uy;
    private double uz;
    private boolean hasUnit;
    private double halfCos;
    private double halfSin;
    private boolean cone;

    /** Whether the start is already too far from the origin for any scaling, see {@link UnderflowScaling}. */
    private boolean isFarFromOrigin;

    /**
     * The triangle of a mesh that gave the last answer, as its position in the order of the tree's leaves, or the cell of a
     * grid; else -1.
     */
    private int triangle;

    private double nearest;
    private final MeshRay.Judge judge = this::judge;
    private final KnownInside inside = new KnownInside();

    /** A distance that is as good as the nearest, as only whether there is one is asked; below 0 if it is not. */
    private double enough = Double.NEGATIVE_INFINITY;

    public Cast(Scratch scratch) {
        s = scratch;
    }

    /**
     * Sets a line. In PLANAR its projection is used, which must not be a point.
     *
     * @param x  start
     * @param ax direction, of any length except zero. Hits are decided for these numbers, not for the unit vector
     */
    public void line(Dimension inDimension, double x, double y, double z, double ax, double ay, double az) {
        dimension = inDimension;
        ox = x;
        oy = y;
        oz = z;
        double level = dimension == Dimension.PLANAR ? 0 : ay;
        double sum = Math.abs(ax) + Math.abs(level) + Math.abs(az);
        // Scaling by a power of two near the greatest prevents overflow; if none is possible, the numbers stay, so that
        // a coordinate near zero keeps its bits.
        double scale = sum >= 0x1p-98 && sum <= 0x1p100 ? 1 : scale(VectorMath.largest(ax, level, az));
        dx = ax * scale;
        dy = level * scale;
        dz = az * scale;
        hasUnit = false;
        cone = false;
        isFarFromOrigin = Math.abs(x) >= UnderflowScaling.SMALL
                || Math.abs(z) >= UnderflowScaling.SMALL
                || (Math.abs(y) >= UnderflowScaling.SMALL && dimension == Dimension.SPATIAL);
    }

    private static double scale(double greatest) {
        return greatest >= 0x1p-100 && greatest <= 0x1p100 ? 1 : Math.scalb(1.0, -Math.getExponent(greatest));
    }

    /** A coordinate (0 to 2) of the line's direction; in PLANAR of its projection. */
    public double way(int axis) {
        return axis == 0 ? dx : axis == 1 ? dy : dz;
    }

    /** The length of {@link #way}. */
    public double length() {
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    /** The reciprocal of the {@link #length}, or slightly more. */
    public double inverseLength() {
        double square = dx * dx + dy * dy + dz * dz;
        return Math.abs(square - 1) < 0x1p-40 ? 1 + 0x1p-40 : 1 / Math.sqrt(square);
    }

    /** A coordinate (0 to 2) of the line's unit direction; in PLANAR that of its projection. */
    public double unit(int axis) {
        takeUnit();
        return axis == 0 ? ux : axis == 1 ? uy : uz;
    }

    /** Computes the unit direction, which the plane does without. */
    private void takeUnit() {
        if (!hasUnit) {
            double length = length();
            ux = dx / length;
            uy = dy / length;
            uz = dz / length;
            hasUnit = true;
        }
    }

    /** Makes the line the axis of a cone with a half angle of 0 to 90 degrees, both exclusive. */
    public void widen(double cosine, double sine) {
        halfCos = cosine;
        halfSin = sine;
        cone = true;
        takeUnit();
    }

    /** Is told that from now on any distance up to one is as good as the nearest; below 0 if none is. */
    public void contentWith(double distance) {
        enough = distance;
    }

    /** Distance from the start to the leaf; +Infinity if it is missed, and possibly if it is beyond the limit. */
    public double distance(LeafColumn column, int leaf, double limit) {
        triangle = -1;
        LeafKind kind = column.kind(leaf);
        if (!kind.hasPieces()) {
            return convex(kind, column.rows(leaf), column.at(leaf), limit);
        }
        if (kind.isGrid()) {
            return grid(column, leaf, limit);
        }
        boolean isSolid = PointInMesh.counts(dimension, column, leaf);
        if (isSolid && enough >= 0) {
            return anyOfSolid(column, leaf, limit);
        }
        if (isSolid && inside.holds(column, leaf, ox, oy, oz, s.leaf)) {
            return 0;
        }
        return surface(column, leaf, limit);
    }

    /** Looks on past the limit: a line that crosses the surface nowhere begins outside, and few begin near it elsewhere. */
    private double anyOfSolid(LeafColumn column, int leaf, double limit) {
        double crossed = surface(column, leaf, Double.POSITIVE_INFINITY);
        if (crossed <= limit || crossed == Double.POSITIVE_INFINITY) {
            return crossed;
        }
        return PointInMesh.holds(column, leaf, ox, oy, oz, s.leaf) ? 0 : crossed;
    }

    private double surface(LeafColumn column, int leaf, double limit) {
        nearest = Double.POSITIVE_INFINITY;
        s.leaf.outer.open(column, leaf);
        if (dimension == Dimension.SPATIAL && !cone) {
            startMeshRay(column, leaf);
            s.mesh.meshRay.find(column.mesh(leaf), limit, judge);
            return nearest;
        }
        takeUnit();
        if (dimension == Dimension.SPATIAL) {
            s.mesh.meshSight.startCone(column, leaf, ox, oy, oz, ux, uy, uz, halfCos);
        } else if (cone) {
            s.mesh.meshSight.startSector(column, leaf, ox, oz, ux, uz, halfCos);
        } else {
            s.mesh.meshSight.startLine(column, leaf, ox, oz, ux, uz);
        }
        s.mesh.meshSight.find(column.mesh(leaf), limit, judge);
        return nearest;
    }

    private double grid(LeafColumn column, int leaf, double limit) {
        takeUnit();
        GridWalk walk = s.leaf.cells(LeafKind.UPRIGHT_BOX);
        if (cone) {
            walk.startCone(column, leaf, ox, oz, ux, uz, halfSin);
        } else {
            walk.startLine(column, leaf, dimension == Dimension.PLANAR, ox, oy, oz, ux, uy, uz, limit);
        }
        double best = Double.POSITIVE_INFINITY;
        for (int cell = nextCell(walk, limit); cell >= 0; cell = nextCell(walk, Math.min(limit, best))) {
            walk.corners(cell, s.leaf.triangleA, 0);
            double distance = cell(walk, best);
            if (distance < best || (distance == best && cell < triangle)) {
                best = distance;
                triangle = cell;
            }
        }
        return best;
    }

    /** The distance of the cell whose row was written, the same to the bit however it is found. */
    private double cell(GridWalk walk, double limit) {
        boolean isFlat = dimension == Dimension.PLANAR;
        int face = cone || !isModerate() ? -1 : isFlat ? walk.face() : walk.face(oy, uy);
        if (face >= 0) {
            double distance = isFlat
                    ? RayRectangle.side(ox, oz, dx, dz, s.leaf.triangleA, 0, face == 0)
                    : SpatialRay.uprightFace(ox, oy, oz, dx, dy, dz, s.leaf.triangleA, 0, face, s.ray);
            // Only a small distance may have been spoiled by what underflowed.
            if (distance > UnderflowScaling.SMALL) {
                return distance;
            }
        }
        return convex(LeafKind.UPRIGHT_BOX, s.leaf.triangleA, 0, limit);
    }

    /** Whether the direction is of a length at which nothing overflows or underflows. */
    private boolean isModerate() {
        double sum = Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
        return sum > 0x1p-90 && sum < 0x1p90;
    }

    private int nextCell(GridWalk walk, double reach) {
        return cone ? walk.nextAround(reach) : walk.nextOnLine(reach);
    }

    /** Starts the search of a mesh; a direction that is of unit length but for some roundings is taken as it is. */
    private void startMeshRay(LeafColumn column, int leaf) {
        if (Math.abs(dx * dx + dy * dy + dz * dz - 1) <= 0x1p-50) {
            s.mesh.meshRay.start(column, leaf, ox, oy, oz, dx, dy, dz);
        } else {
            takeUnit();
            s.mesh.meshRay.start(column, leaf, ox, oy, oz, ux, uy, uz);
        }
    }

    /**
     * Distance in PLANAR from the start of a line to an upright object, given by its number; +Infinity if it is missed;
     * NaN if it is not such an object or doubles cannot decide.
     */
    public double upright(double[] outlines, int id) {
        int at = OrientedRectangle.at(id);
        if (!UprightRows.isHere(outlines, at)) {
            return Double.NaN;
        }
        double cx = outlines[at + OrientedRectangle.X];
        double cz = outlines[at + OrientedRectangle.Z];
        double halfX = outlines[at + OrientedRectangle.HALF_X];
        double cos = outlines[at + OrientedRectangle.COS];
        double sin = outlines[at + OrientedRectangle.SIN];
        double distance = UprightRows.isRound(outlines, at)
                ? RayDisc.distance(ox, oz, dx, dz, cx, cz, halfX)
                : RayRectangle.sure(ox, oz, dx, dz, cx, cz, halfX, outlines[at + OrientedRectangle.HALF_Z], cos, sin);
        // Only a small distance may have been spoiled by what underflowed.
        return distance > UnderflowScaling.SMALL || isFarFromOrigin ? distance : Double.NaN;
    }

    private double judge(int place) {
        s.work.take();
        s.leaf.outer.corners(place, s.leaf.triangleA, 0);
        double distance = convex(LeafKind.TRIANGLE, s.leaf.triangleA, 0, nearest);
        if (distance < nearest || (distance == nearest && isLower(place))) {
            nearest = distance;
            triangle = place;
        }
        boolean isEnough = nearest <= enough && triangle >= 0; // both may be infinite
        return isEnough ? Double.NEGATIVE_INFINITY : nearest; // that ends the search
    }

    private boolean isLower(int place) {
        return triangle >= 0 && s.leaf.outer.triangle(place) < s.leaf.outer.triangle(triangle);
    }

    private double convex(LeafKind kind, double[] row, int at, double limit) {
        return isFarFromOrigin || !isTakenUp(0, kind, row, at)
                ? convex(ox, oy, oz, kind, row, at, limit)
                : scaled(kind);
    }

    /** The distance of the leaf that is scaled up. */
    private double scaled(LeafKind kind) {
        UnderflowScaling m = s.leaf.scaling;
        return m.down(convex(m.up(ox), height(m.up(oy)), m.up(oz), kind, m.a, 0, Double.POSITIVE_INFINITY));
    }

    /** Whether a leaf is scaled up, with the start and another length. */
    private boolean isTakenUp(double more, LeafKind kind, double[] row, int at) {
        double largest = Math.max(more, VectorMath.largest(ox, height(oy), oz));
        return s.leaf.scaling.take(dimension, largest, kind, row, at);
    }

    /** A height where heights count, else 0. */
    private double height(double y) {
        return dimension == Dimension.PLANAR ? 0 : y;
    }

    private double convex(double x, double y, double z, LeafKind kind, double[] row, int at, double limit) {
        if (dimension == Dimension.PLANAR) {
            return cone
                    ? PlanarCone.distance(x, z, dx, dz, halfCos, halfSin, kind, row, at, limit, s.cone)
                    : PlanarRay.distance(x, z, dx, dz, kind, row, at, s.ray);
        }
        return cone
                ? SpatialCone.distance(x, y, z, dx, dy, dz, halfCos, halfSin, kind, row, at, limit, s.cone)
                : SpatialRay.distance(x, y, z, dx, dy, dz, kind, row, at, s.ray);
    }

    /** Where what gave the last answer is found again: the position of a mesh's triangle, a grid's cell; -1 for none. */
    public int piece() {
        return triangle;
    }

    /**
     * The triangle or cell of a leaf that the line meets; -1 if it is no mesh or grid, or the line starts inside a solid mesh.
     *
     * @param piece as {@link #piece} told it
     */
    public int face(LeafColumn column, int leaf, int piece) {
        LeafKind kind = column.kind(leaf);
        if (!kind.hasPieces() || piece < 0) {
            return -1;
        }
        if (kind.isGrid()) {
            return piece;
        }
        s.leaf.outer.open(column, leaf);
        return s.leaf.outer.triangle(piece);
    }

    /**
     * Writes the unit normal, three numbers, of the leaf where the line hits it at a distance.
     *
     * @param piece as {@link #piece} told it
     */
    public void normal(LeafColumn column, int leaf, double distance, int piece, double[] out) {
        faces(column, leaf, distance, piece, out);
        if (distance > 0) {
            face(out);
        }
    }

    /**
     * Turns a normal that points ahead by rounding: its product with the direction, as doubles compute it, is not above 0. Each
     * time it is tilted by more, as the least may be less than a rounding of the normal.
     */
    private void face(double[] normal) {
        double ahead = normal[0] * dx + normal[1] * dy + normal[2] * dz;
        double square = dx * dx + dy * dy + dz * dz;
        for (double times = 1; ahead > 0 && times < MOST_TILT; times *= 2) {
            double share = times * ahead / square;
            normal[0] -= share * dx;
            normal[1] -= share * dy;
            normal[2] -= share * dz;
            ahead = normal[0] * dx + normal[1] * dy + normal[2] * dz;
        }
    }

    private void faces(LeafColumn column, int leaf, double distance, int piece, double[] out) {
        takeUnit();
        double px = ox + distance * ux;
        double py = oy + distance * uy;
        double pz = oz + distance * uz;
        LeafKind kind = column.kind(leaf);
        double[] row = column.rows(leaf);
        int at = column.at(leaf);
        if (kind.isGrid()) {
            distance(column, leaf, Double.POSITIVE_INFINITY);
            s.leaf.cells(LeafKind.UPRIGHT_BOX).corners(triangle, s.leaf.triangleA, 0);
            kind = LeafKind.UPRIGHT_BOX;
            row = s.leaf.triangleA;
            at = 0;
        } else if (kind.isMesh()) {
            if (piece < 0) { // inside a solid mesh
                out[0] = -ux;
                out[1] = -uy;
                out[2] = -uz;
                return;
            }
            s.leaf.outer.open(column, leaf);
            s.leaf.outer.corners(piece, s.leaf.triangleA, 0);
            kind = LeafKind.TRIANGLE;
            row = s.leaf.triangleA;
            at = 0;
        }
        if (isFarFromOrigin || !isTakenUp(distance, kind, row, at)) {
            normals.at(px, py, pz, distance, ux, uy, uz, kind, row, at, out, dimension);
            return;
        }
        UnderflowScaling m = s.leaf.scaling;
        double far = m.up(distance);
        px = m.up(ox) + far * ux;
        py = height(m.up(oy)) + far * uy;
        pz = m.up(oz) + far * uz;
        normals.at(px, py, pz, far, ux, uy, uz, kind, m.a, 0, out, dimension);
    }
}
