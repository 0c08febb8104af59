package robosim.geometry.narrow.normal;

import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** The faces of each kind of leaf in space. */
final class SpatialFaces {
    private SpatialFaces() {}

    static void offer(NearestFace face, LeafKind kind, double[] b, int j) {
        switch (kind) {
            case UPRIGHT_BOX, BOX -> box(face, b, j);
            case UPRIGHT_CYLINDER -> cylinder(face, b, j, 0, 1, 0);
            case CYLINDER -> cylinder(face, b, j, b[j + 7], b[j + 10], b[j + 13]);
            case UPRIGHT_CAPSULE -> capsule(face, b, j, 0, 1, 0);
            case CAPSULE -> capsule(face, b, j, b[j + 7], b[j + 10], b[j + 13]);
            case SPHERE -> round(face, face.px - b[j], face.py - b[j + 1], face.pz - b[j + 2], b[j + 3]);
            case TRIANGLE -> triangle(face, b, j);
            case PRISM -> prism(face, b, j);
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        }
    }

    private static void box(NearestFace face, double[] b, int j) {
        int r = j + Leaf.ROTATION;
        double qx = face.px - b[j];
        double qy = face.py - b[j + 1];
        double qz = face.pz - b[j + 2];
        for (int i = 0; i < 3; i++) {
            int k = r + (i + 1) % 3;
            int l = r + (i + 2) % 3;
            double nx = b[k + 3] * b[l + 6] - b[k + 6] * b[l + 3];
            double ny = b[k + 6] * b[l] - b[k] * b[l + 6];
            double nz = b[k] * b[l + 3] - b[k + 3] * b[l];
            double det = b[r + i] * nx + b[r + i + 3] * ny + b[r + i + 6] * nz;
            face.offerSlab(qx * nx + qy * ny + qz * nz, b[j + Leaf.SIZE + i] * det, nx, ny, nz);
        }
    }

    private static void cylinder(NearestFace face, double[] b, int j, double ax, double ay, double az) {
        double qx = face.px - b[j];
        double qy = face.py - b[j + 1];
        double qz = face.pz - b[j + 2];
        double aa = ax * ax + ay * ay + az * az;
        double along = qx * ax + qy * ay + qz * az;
        face.offerSlab(along, b[j + 4] * aa, ax, ay, az);
        double share = along / aa;
        round(face, qx - share * ax, qy - share * ay, qz - share * az, b[j + 3]);
    }

    // Away from the nearest point on its segment.
    private static void capsule(NearestFace face, double[] b, int j, double ax, double ay, double az) {
        double qx = face.px - b[j];
        double qy = face.py - b[j + 1];
        double qz = face.pz - b[j + 2];
        double h = b[j + 4];
        double along = (qx * ax + qy * ay + qz * az) / (ax * ax + ay * ay + az * az);
        double share = Math.max(-h, Math.min(h, along));
        round(face, qx - share * ax, qy - share * ay, qz - share * az, b[j + 3]);
    }

    private static void round(NearestFace face, double qx, double qy, double qz, double r) {
        double length = VectorMath.length(qx, qy, qz);
        if (length > 0) {
            face.offer(length - r, qx / length, qy / length, qz / length);
        }
    }

    // A surface: only the side towards the ray. A degenerate one: the direction across the segment.
    private static void triangle(NearestFace face, double[] b, int j) {
        double ex = b[j + 3] - b[j];
        double ey = b[j + 4] - b[j + 1];
        double ez = b[j + 5] - b[j + 2];
        double fx = b[j + 6] - b[j];
        double fy = b[j + 7] - b[j + 1];
        double fz = b[j + 8] - b[j + 2];
        double nx = ey * fz - ez * fy;
        double ny = ez * fx - ex * fz;
        double nz = ex * fy - ey * fx;
        double length = VectorMath.length(nx, ny, nz);
        if (length > 0) {
            double sign = nx * face.ux + ny * face.uy + nz * face.uz > 0 ? -1 / length : 1 / length;
            face.offer(0, nx * sign, ny * sign, nz * sign);
            return;
        }
        boolean isFirst = ex * ex + ey * ey + ez * ez >= fx * fx + fy * fy + fz * fz;
        across(face, isFirst ? ex : fx, isFirst ? ey : fy, isFirst ? ez : fz);
    }

    private static void across(NearestFace face, double ex, double ey, double ez) {
        double ee = ex * ex + ey * ey + ez * ez;
        double share = ee > 0 ? (face.ux * ex + face.uy * ey + face.uz * ez) / ee : 0;
        double nx = share * ex - face.ux;
        double ny = share * ey - face.uy;
        double nz = share * ez - face.uz;
        double length = VectorMath.length(nx, ny, nz);
        if (length > 0) {
            face.offer(0, nx / length, ny / length, nz / length);
        }
    }

    private static void prism(NearestFace face, double[] b, int j) {
        slab(face, face.px, b[j], b[j + 1], 1, 0, 0);
        slab(face, face.pz, b[j + 2], b[j + 3], 0, 0, 1);
        slab(face, face.px + face.pz, b[j + 4], b[j + 5], 1, 0, 1);
        slab(face, face.px - face.pz, b[j + 6], b[j + 7], 1, 0, -1);
        slab(face, face.py, b[j + 8], b[j + 9], 0, 1, 0);
    }

    static void slab(NearestFace face, double at, double low, double high, double nx, double ny, double nz) {
        double length = VectorMath.length(nx, ny, nz);
        face.offer((at - high) / length, nx / length, ny / length, nz / length);
        face.offer((low - at) / length, -nx / length, -ny / length, -nz / length);
    }
}
