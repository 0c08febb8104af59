package robosim.geometry.narrow.sat;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * The corners, edge directions and face normals of a leaf as stored, without rounding. A sphere has its centre as
 * corner, a cylinder its axis as edge and its caps as faces. In the plane all heights are 0, and edge normals are face
 * normals.
 */
public final class ExactFeatures {
    public final List<ExactVector> corners = new ArrayList<>();
    final List<ExactVector> edges = new ArrayList<>();
    final List<ExactVector> faces = new ArrayList<>();

    /** Whether it is round about the hull of its corners; otherwise it is that hull. */
    public final boolean isRound;

    private final boolean flat;

    public ExactFeatures(boolean inPlane, Leaf leaf) {
        flat = inPlane;
        isRound = leaf.kind.isRound() && leaf.get(Leaf.SIZE) > 0;
        switch (leaf.kind) {
            case UPRIGHT_BOX, BOX -> box(leaf.row, leaf.at);
            case SPHERE -> corners.add(level(ExactVector.of(leaf.row, leaf.at, 1)));
            case UPRIGHT_CAPSULE, CAPSULE -> capsule(leaf);
            case UPRIGHT_CYLINDER, CYLINDER -> cylinder(leaf);
            case TRIANGLE -> triangle(leaf.row, leaf.at);
            case PRISM, MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        }
        if (flat) {
            for (ExactVector edge : edges) {
                faces.add(new ExactVector(edge.z().negate(), Dyadic.ZERO, edge.x()));
            }
            faces.addAll(edges); // the ends of a segment
            edges.clear();
        }
    }

    private boolean isProper = true;

    /**
     * Whether it has an interior or is a triangle with an area. Between two such leaves, the normals give all planes.
     */
    public boolean isProper() {
        return isProper;
    }

    /** The directions of straight edges; none in the plane. */
    public List<ExactVector> edges() {
        return edges;
    }

    /** The normals of flat sides; in the plane also the directions of edges. */
    public List<ExactVector> faces() {
        return faces;
    }

    private ExactVector level(ExactVector v) {
        return flat ? new ExactVector(v.x(), Dyadic.ZERO, v.z()) : v;
    }

    private void capsule(Leaf leaf) {
        ExactVector axis = level(ExactExtent.axis(leaf));
        ExactVector centre = level(ExactVector.of(leaf.row, leaf.at, 1));
        ExactVector arm = axis.times(Dyadic.of(leaf.get(4)));
        if (!axis.isZero()) {
            edges.add(axis);
        }
        corners.add(centre.plus(arm));
        corners.add(centre.minus(arm));
    }

    private void box(double[] row, int at) {
        ExactVector[] arms = new ExactVector[3];
        for (int k = 0; k < 3; k++) {
            ExactVector column = level(ExactVector.of(row, at + Leaf.ROTATION + k, 3));
            arms[k] = column.times(Dyadic.of(row[at + Leaf.SIZE + k]));
            edges.add(column);
        }
        if (!flat) {
            for (int k = 0; k < 3; k++) {
                faces.add(edges.get((k + 1) % 3).cross(edges.get((k + 2) % 3)));
            }
        }
        isProper = flat ? isAcross(arms) : !(arms[0].isZero() || arms[1].isZero() || arms[2].isZero());
        corners.add(level(ExactVector.of(row, at, 1)));
        for (ExactVector arm : arms) {
            if (!arm.isZero()) {
                both(arm);
            }
        }
    }

    private static boolean isAcross(ExactVector[] arms) {
        return !arms[0].cross(arms[1]).isZero()
                || !arms[1].cross(arms[2]).isZero()
                || !arms[2].cross(arms[0]).isZero();
    }

    /** Replaces each corner by two, moved by plus and minus the vector. */
    private void both(ExactVector arm) {
        List<ExactVector> before = List.copyOf(corners);
        corners.clear();
        for (ExactVector corner : before) {
            corners.add(corner.plus(arm));
            corners.add(corner.minus(arm));
        }
    }

    private void cylinder(Leaf leaf) {
        ExactVector axis = ExactExtent.axis(leaf);
        corners.add(level(ExactVector.of(leaf.row, leaf.at, 1)));
        ExactVector along = level(axis);
        if (along.isZero()) {
            return;
        }
        both(along.times(Dyadic.of(leaf.get(4))));
        edges.add(along);
        if (!flat) {
            faces.add(axis);
        }
    }

    private void triangle(double[] row, int at) {
        for (int k = 0; k < 9; k += 3) {
            corners.add(level(ExactVector.of(row, at + k, 1)));
        }
        for (int k = 0; k < 3; k++) {
            edges.add(corners.get((k + 1) % 3).minus(corners.get(k)));
        }
        ExactVector normal = edges.get(0).cross(edges.get(1));
        isProper = !normal.isZero();
        if (flat) {
            return;
        }
        faces.add(normal);
        for (int k = 0; k < 3; k++) {
            faces.add(edges.get(k).cross(normal)); // for objects in its plane
        }
    }

    /** Directions that include the normal of a separating plane, if the two touch and not by a rim against an edge. */
    List<ExactVector> normalsWith(ExactFeatures other) {
        List<ExactVector> normals = new ArrayList<>(faces);
        normals.addAll(other.faces);
        for (ExactVector one : edges) {
            for (ExactVector two : other.edges) {
                normals.add(one.cross(two));
            }
        }
        if (isRound) {
            addTangents(other, normals);
        }
        if (other.isRound) {
            other.addTangents(this, normals);
        }
        normals.removeIf(ExactVector::isZero);
        return normals;
    }

    /**
     * For two leaves that touch and do not overlap: the directions from b to a of separating planes, each once. Either
     * these are all such directions, or all others lie between them; none where a rim touches anything but a corner.
     */
    public static List<ExactVector> parting(boolean flat, Leaf a, Leaf b) {
        List<ExactVector> parting = new ArrayList<>();
        ExactFeatures mine = new ExactFeatures(flat, a);
        for (ExactVector normal : mine.normalsWith(new ExactFeatures(flat, b))) {
            for (int side = 1; side >= -1; side -= 2) {
                ExactVector n = side > 0 ? normal : normal.times(Dyadic.ONE.negate());
                if (ExactExtent.of(n, b).gapTo(ExactExtent.of(n, a)) >= 0
                        && parting.stream().noneMatch(one -> isParallel(one, n))) {
                    parting.add(n);
                }
            }
        }
        return parting;
    }

    private static boolean isParallel(ExactVector a, ExactVector b) {
        return a.cross(b).isZero() && a.dot(b).signum() > 0;
    }

    /** From the corners and edges of another leaf towards the centre of this one or perpendicular to its axis. */
    private void addTangents(ExactFeatures other, List<ExactVector> normals) {
        for (ExactVector corner : other.corners) {
            ExactVector offset = corners.get(0).minus(corner);
            if (!edges.isEmpty()) {
                ExactVector radial = across(offset, edges.get(0));
                normals.add(radial);
                // A corner on the rim: perpendicular to the rim's tangent there and an edge.
                ExactVector tangent = edges.get(0).cross(radial);
                for (ExactVector edge : other.edges) {
                    normals.add(tangent.cross(edge));
                }
                continue;
            }
            normals.add(offset);
            for (ExactVector edge : other.edges) {
                normals.add(across(offset, edge));
            }
        }
    }

    /** The part of v perpendicular to another vector, times that vector's square. */
    private static ExactVector across(ExactVector v, ExactVector along) {
        return v.times(along.square()).minus(along.times(v.dot(along)));
    }
}
