package robosim.geometry.narrow.leaf;

/**
 * The normals of a leaf's flat sides and the directions of its straight edges, from which candidates for the direction
 * of least penetration are made: unit vectors, one for each opposite pair. A cylinder has its caps' normal and its
 * side's direction; a sphere has neither. A side or edge without extent has none.
 */
public final class FeatureDirections {
    private static final int MOST = 5;
    private static final double DIAGONAL = Math.sqrt(0.5);

    public int faces;
    public final double[] faceX = new double[MOST];
    public final double[] faceY = new double[MOST];
    public final double[] faceZ = new double[MOST];

    public int edges;
    public final double[] edgeX = new double[MOST];
    public final double[] edgeY = new double[MOST];
    public final double[] edgeZ = new double[MOST];

    public void spatial(Leaf leaf) {
        faces = 0;
        edges = 0;
        switch (leaf.kind) {
            case UPRIGHT_BOX, BOX -> box(leaf.row, leaf.at + Leaf.ROTATION);
            case UPRIGHT_CYLINDER -> axis(0, 1, 0);
            case CYLINDER -> axis(leaf.get(7), leaf.get(10), leaf.get(13));
            case TRIANGLE -> triangle(leaf.row, leaf.at);
            case PRISM -> {
                axis(0, 1, 0);
                for (int k = 0; k < 4; k++) {
                    double x = k == 0 ? 1 : k == 1 ? 0 : DIAGONAL;
                    double z = k == 0 ? 0 : k == 3 ? -x : k == 1 ? 1 : x;
                    face(x, 0, z);
                    edge(-z, 0, x);
                }
            }
            case UPRIGHT_CAPSULE -> edge(0, 1, 0);
            case CAPSULE -> edge(leaf.get(7), leaf.get(10), leaf.get(13));
            case SPHERE -> {} // has no flat sides or edges
            case MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        }
    }

    /** Loads the normals of a projection's straight sides; no edges. */
    public void planar(Leaf leaf) {
        faces = 0;
        edges = 0;
        switch (leaf.kind) {
            case UPRIGHT_BOX, BOX -> {
                for (int k = leaf.at + Leaf.ROTATION; k < leaf.at + Leaf.ROTATION + 3; k++) {
                    face(leaf.row[k + 6], 0, -leaf.row[k]);
                }
            }
            case CYLINDER, CAPSULE -> face(leaf.get(13), 0, -leaf.get(7));
            case TRIANGLE -> {
                for (int k = 0; k < 3; k++) {
                    int p = leaf.at + 3 * k;
                    int q = leaf.at + 3 * ((k + 1) % 3);
                    face(leaf.row[q + 2] - leaf.row[p + 2], 0, leaf.row[p] - leaf.row[q]);
                }
            }
            case PRISM -> {
                face(1, 0, 0);
                face(0, 0, 1);
                face(1, 0, 1);
                face(1, 0, -1);
            }
            case UPRIGHT_CYLINDER, SPHERE, UPRIGHT_CAPSULE -> {} // a disc
            case MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        }
    }

    private void box(double[] row, int r) {
        for (int k = 0; k < 3; k++) {
            int p = r + (k + 1) % 3;
            int q = r + (k + 2) % 3;
            edge(row[r + k], row[r + k + 3], row[r + k + 6]);
            face(
                    row[p + 3] * row[q + 6] - row[p + 6] * row[q + 3],
                    row[p + 6] * row[q] - row[p] * row[q + 6],
                    row[p] * row[q + 3] - row[p + 3] * row[q]);
        }
    }

    private void axis(double x, double y, double z) {
        face(x, y, z);
        edge(x, y, z);
    }

    private void triangle(double[] row, int at) {
        double px = row[at + 3] - row[at];
        double py = row[at + 4] - row[at + 1];
        double pz = row[at + 5] - row[at + 2];
        double qx = row[at + 6] - row[at];
        double qy = row[at + 7] - row[at + 1];
        double qz = row[at + 8] - row[at + 2];
        edge(px, py, pz);
        edge(qx, qy, qz);
        edge(row[at + 6] - row[at + 3], row[at + 7] - row[at + 4], row[at + 8] - row[at + 5]);
        face(py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx);
    }

    private void face(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        if (length > 0) {
            faceX[faces] = x / length;
            faceY[faces] = y / length;
            faceZ[faces] = z / length;
            faces++;
        }
    }

    private void edge(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        if (length > 0) {
            edgeX[edges] = x / length;
            edgeY[edges] = y / length;
            edgeZ[edges] = z / length;
            edges++;
        }
    }
}
