package robosim.geometry.narrow.normal;

import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** The edges of each kind of leaf's projection on the ground; their normals are horizontal. */
final class PlanarFaces {
    private PlanarFaces() {}

    static void offer(NearestFace face, LeafKind kind, double[] b, int j) {
        switch (kind) {
            case UPRIGHT_BOX, BOX -> box(face, b, j);
            case UPRIGHT_CYLINDER, SPHERE, UPRIGHT_CAPSULE -> disc(face, face.px - b[j], face.pz - b[j + 2], b[j + 3]);
            case CYLINDER -> oval(face, b, j);
            case CAPSULE -> stadium(face, b, j);
            case TRIANGLE -> triangle(face, b, j);
            case PRISM -> {
                SpatialFaces.slab(face, face.px, b[j], b[j + 1], 1, 0, 0);
                SpatialFaces.slab(face, face.pz, b[j + 2], b[j + 3], 0, 0, 1);
                SpatialFaces.slab(face, face.px + face.pz, b[j + 4], b[j + 5], 1, 0, 1);
                SpatialFaces.slab(face, face.px - face.pz, b[j + 6], b[j + 7], 1, 0, -1);
            }
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        }
    }

    private static void disc(NearestFace face, double qx, double qz, double r) {
        double length = Math.sqrt(qx * qx + qz * qz);
        if (length > 0) {
            face.offer(length - r, qx / length, 0, qz / length);
        }
    }

    // The projection is the sum of three segments: its edges are parallel to them, and along an edge's normal it
    // extends as far as all three together. If all are parallel, it is a segment, whose ends are faces too.
    private static void box(NearestFace face, double[] b, int j) {
        int r = j + Leaf.ROTATION;
        for (int i = 0; i < 3; i++) {
            double h = b[j + Leaf.SIZE + i];
            double ex = h * b[r + i];
            double ez = h * b[r + i + 6];
            offer(face, b, j, -ez, ex);
            if (reach(b, j, -ez, ex) == 0) {
                offer(face, b, j, ex, ez);
            }
        }
    }

    private static void offer(NearestFace face, double[] b, int j, double nx, double nz) {
        double offset = (face.px - b[j]) * nx + (face.pz - b[j + 2]) * nz;
        face.offerSlab(offset, reach(b, j, nx, nz), nx, 0, nz);
    }

    private static double reach(double[] b, int j, double nx, double nz) {
        int r = j + Leaf.ROTATION;
        return b[j + 3] * Math.abs(b[r] * nx + b[r + 6] * nz)
                + b[j + 4] * Math.abs(b[r + 1] * nx + b[r + 7] * nz)
                + b[j + 5] * Math.abs(b[r + 2] * nx + b[r + 8] * nz);
    }

    // A lying or leaning cylinder: two straight sides along the axis and an ellipse at either end, which is a disc of
    // the radius compressed along the axis by |ay|.
    private static void oval(NearestFace face, double[] b, int j) {
        double r = b[j + 3];
        double h = b[j + 4];
        double ax = b[j + 7];
        double ay = Math.abs(b[j + 10]);
        double az = b[j + 13];
        double flat = Math.sqrt(ax * ax + az * az);
        double qx = face.px - b[j];
        double qz = face.pz - b[j + 2];
        if (!(flat > 0)) {
            disc(face, qx, qz, r);
            return;
        }
        double vx = ax / flat;
        double vz = az / flat;
        double along = qx * vx + qz * vz;
        double aside = qz * vx - qx * vz;
        face.offer(aside - r, -vz, 0, vx);
        face.offer(-aside - r, vz, 0, -vx);
        double past = Math.abs(along) - h * flat;
        double sign = along < 0 ? -1 : 1;
        double semi = r * ay;
        double reach = semi * Math.sqrt(Math.max(0, 1 - aside * aside / Math.max(r * r, Double.MIN_NORMAL)));
        // The gradient of (past / ay)^2 + aside^2, times ay^2; a flat end faces along the axis.
        double across = aside * ay * ay;
        double length = Math.sqrt(past * past + across * across);
        double nv = past > 0 && semi > 0 ? sign * past / length : sign;
        double nw = past > 0 && semi > 0 ? across / length : 0;
        face.offer(past - reach, nv * vx - nw * vz, 0, nv * vz + nw * vx);
    }

    // Away from the nearest point on the segment, seen from above.
    private static void stadium(NearestFace face, double[] b, int j) {
        double qx = face.px - b[j];
        double qz = face.pz - b[j + 2];
        double h = b[j + 4];
        double ax = b[j + 7];
        double az = b[j + 13];
        double square = ax * ax + az * az;
        double along = square > 0 ? (qx * ax + qz * az) / square : 0;
        double share = Math.max(-h, Math.min(h, along));
        disc(face, qx - share * ax, qz - share * az, b[j + 3]);
    }

    private static void triangle(NearestFace face, double[] b, int j) {
        double area = (b[j + 3] - b[j]) * (b[j + 8] - b[j + 2]) - (b[j + 5] - b[j + 2]) * (b[j + 6] - b[j]);
        for (int i = 0; i < 3; i++) {
            int from = j + 3 * i;
            int to = j + 3 * ((i + 1) % 3);
            double ex = b[to] - b[from];
            double ez = b[to + 2] - b[from + 2];
            double length = Math.sqrt(ex * ex + ez * ez);
            if (!(length > 0)) {
                continue;
            }
            // Counter-clockwise corners have the inside on their left.
            double nx = (area < 0 ? -ez : ez) / length;
            double nz = (area < 0 ? ex : -ex) / length;
            double above = (face.px - b[from]) * nx + (face.pz - b[from + 2]) * nz;
            face.offer(above, nx, 0, nz);
            if (area == 0) {
                face.offer(-above, -nx, 0, -nz);
                end(face, b, from, -ex / length, -ez / length);
                end(face, b, to, ex / length, ez / length);
            }
        }
    }

    private static void end(NearestFace face, double[] b, int at, double nx, double nz) {
        face.offer((face.px - b[at]) * nx + (face.pz - b[at + 2]) * nz, nx, 0, nz);
    }
}
