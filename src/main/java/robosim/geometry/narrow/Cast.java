package robosim.geometry.narrow;

import robosim.geometry.exact.BeamAxis;
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
import robosim.geometry.narrow.mesh.InsideCache;
import robosim.geometry.narrow.mesh.MeshRay;
import robosim.geometry.narrow.mesh.PointInMesh;
import robosim.geometry.narrow.normal.Normals;
import robosim.geometry.narrow.ray.PlanarRay;
import robosim.geometry.narrow.ray.RayBox;
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

    /** The beam. In PLANAR its direction is level. */
    public final BeamAxis beam = new BeamAxis();

    /** The same from a start that is scaled up. */
    private final BeamAxis scaled = new BeamAxis();

    /** Whether the start is already too far from the origin for any scaling, see {@link UnderflowScaling}. */
    private boolean isFarFromOrigin;

    /**
     * The triangle of a mesh that gave the last answer, as its position in the order of the tree's leaves, or the cell of a
     * grid; else -1.
     */
    private int triangle;

    private double nearest;
    private final MeshRay.Judge judge = this::judge;
    private final InsideCache inside = new InsideCache();

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
        beam.line(x, y, z, ax, dimension == Dimension.PLANAR ? 0 : ay, az);
        isFarFromOrigin = Math.abs(x) >= UnderflowScaling.SMALL
                || Math.abs(z) >= UnderflowScaling.SMALL
                || (Math.abs(y) >= UnderflowScaling.SMALL && dimension == Dimension.SPATIAL);
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
        if (isSolid && inside.holds(column, leaf, beam.ox, beam.oy, beam.oz, s.leaf)) {
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
        return PointInMesh.holds(column, leaf, beam.ox, beam.oy, beam.oz, s.leaf) ? 0 : crossed;
    }

    private double surface(LeafColumn column, int leaf, double limit) {
        nearest = Double.POSITIVE_INFINITY;
        s.leaf.outer.open(column, leaf);
        if (!beam.isCone && (dimension == Dimension.SPATIAL || MeshRay.castsInPlane(column, leaf))) {
            s.mesh.meshRay.start(dimension, column, leaf, beam);
            s.mesh.meshRay.find(column.mesh(leaf), limit, judge);
            return nearest;
        }
        if (dimension == Dimension.SPATIAL) {
            s.mesh.meshSight.startCone(column, leaf, beam);
        } else {
            s.mesh.meshSight.startSector(column, leaf, beam);
        }
        s.mesh.meshSight.find(column.mesh(leaf), limit, judge);
        return nearest;
    }

    private double grid(LeafColumn column, int leaf, double limit) {
        GridWalk walk = s.leaf.cells(LeafKind.UPRIGHT_BOX);
        if (beam.isCone) {
            walk.startCone(column, leaf, beam);
        } else {
            walk.startLine(column, leaf, dimension == Dimension.PLANAR, beam, limit);
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
        int face = beam.isCone || !isModerate() ? -1 : isFlat ? walk.face() : walk.face(beam.oy, beam.uy());
        if (face >= 0) {
            double distance = isFlat
                    ? RayRectangle.side(beam, s.leaf.triangleA, 0, face == 0)
                    : RayBox.uprightFace(beam, s.leaf.triangleA, 0, face, s.ray);
            // Only a small distance may have been spoiled by what underflowed.
            if (distance > UnderflowScaling.SMALL) {
                return distance;
            }
        }
        return convex(LeafKind.UPRIGHT_BOX, s.leaf.triangleA, 0, limit);
    }

    /** Whether the direction is of a length at which nothing overflows or underflows. */
    private boolean isModerate() {
        double sum = Math.abs(beam.dx) + Math.abs(beam.dy) + Math.abs(beam.dz);
        return sum > 0x1p-90 && sum < 0x1p90;
    }

    private int nextCell(GridWalk walk, double reach) {
        return beam.isCone ? walk.nextAround(reach) : walk.nextOnLine(reach);
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
                ? RayDisc.distance(beam, cx, cz, halfX)
                : RayRectangle.sure(beam, cx, cz, halfX, outlines[at + OrientedRectangle.HALF_Z], cos, sin);
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

    /** The distance of a convex leaf, perhaps of the one that is scaled up. */
    private double convex(LeafKind kind, double[] row, int at, double limit) {
        boolean isUp = !isFarFromOrigin && isTakenUp(0, kind, row, at);
        BeamAxis from = isUp ? scaled : beam;
        double[] numbers = isUp ? s.leaf.scaling.a : row;
        int j = isUp ? 0 : at;
        double most = isUp ? Double.POSITIVE_INFINITY : limit;
        double distance = dimension == Dimension.PLANAR
                ? from.isCone
                        ? PlanarCone.distance(from, kind, numbers, j, most, s.cone)
                        : PlanarRay.distance(from, kind, numbers, j, s.ray)
                : from.isCone
                        ? SpatialCone.distance(from, kind, numbers, j, most, s.cone)
                        : SpatialRay.distance(from, kind, numbers, j, s.ray);
        return isUp ? s.leaf.scaling.down(distance) : distance;
    }

    /** Whether a leaf is scaled up, with the start and another length. */
    private boolean isTakenUp(double more, LeafKind kind, double[] row, int at) {
        UnderflowScaling m = s.leaf.scaling;
        double largest = Math.max(more, VectorMath.largest(beam.ox, height(beam.oy), beam.oz));
        if (!m.take(dimension, largest, kind, row, at)) {
            return false;
        }
        scaled.from(beam, m.up(beam.ox), height(m.up(beam.oy)), m.up(beam.oz));
        return true;
    }

    /** A height where heights count, else 0. */
    private double height(double y) {
        return dimension == Dimension.PLANAR ? 0 : y;
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
        double ahead = normal[0] * beam.dx + normal[1] * beam.dy + normal[2] * beam.dz;
        double square = beam.dx * beam.dx + beam.dy * beam.dy + beam.dz * beam.dz;
        for (double times = 1; ahead > 0 && times < MOST_TILT; times *= 2) {
            double share = times * ahead / square;
            normal[0] -= share * beam.dx;
            normal[1] -= share * beam.dy;
            normal[2] -= share * beam.dz;
            ahead = normal[0] * beam.dx + normal[1] * beam.dy + normal[2] * beam.dz;
        }
    }

    private void faces(LeafColumn column, int leaf, double distance, int piece, double[] out) {
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
                out[0] = -beam.ux();
                out[1] = -beam.uy();
                out[2] = -beam.uz();
                return;
            }
            s.leaf.outer.open(column, leaf);
            s.leaf.outer.corners(piece, s.leaf.triangleA, 0);
            kind = LeafKind.TRIANGLE;
            row = s.leaf.triangleA;
            at = 0;
        }
        if (isFarFromOrigin || !isTakenUp(distance, kind, row, at)) {
            normals.at(beam, distance, kind, row, at, out, dimension);
        } else {
            UnderflowScaling m = s.leaf.scaling;
            normals.at(scaled, m.up(distance), kind, m.a, 0, out, dimension);
        }
    }
}
