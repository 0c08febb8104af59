package robosim.geometry.render;

import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.RoundedBox;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;

/** Where a point of a surface lies in the plane of its texture, as {@link robosim.geometry.material.Texture} defines it. */
final class TexturePoint {
    // The point and the unit normal in the object's own frame.
    double qx;
    double qy;
    double qz;
    double nx;
    double ny;
    double nz;

    // The place in the texture's plane.
    double s;
    double t;

    /** Finds the place of the point on an object. */
    void place(GeometryObject object) {
        if (object instanceof GridObject grid) {
            box(grid.columns() * grid.cell() / 2, grid.height() / 2, grid.rows() * grid.cell() / 2);
        } else if (object instanceof MeshObject) {
            box(0, 0, 0);
        } else {
            solid(object.roundedBox());
        }
    }

    private void solid(RoundedBox box) {
        boolean isCap = Math.abs(ny) > Math.abs(nx) && Math.abs(ny) > Math.abs(nz);
        double half = box.halfHeight();
        double r = box.radius();
        if (box.ball() == 0 && (box.disc() == 0 || isCap)) {
            box(box.halfWidth() + r, half, box.halfLength() + r);
            return;
        }
        s = around() * r;
        if (box.disc() > 0) {
            t = qy + half;
        } else if (qy < -half) {
            t = rise(qy + half) * r;
        } else if (qy > half) {
            t = rise(qy - half) * r + 2 * half;
        } else {
            t = Math.PI / 2 * r + half + qy;
        }
    }

    /** Radians counter-clockwise about the own Y, from the own X, from 0 on. */
    private double around() {
        double angle = StrictMath.atan2(-qz, qx);
        return angle < 0 ? angle + 2 * Math.PI : angle;
    }

    /** Radians along the meridian from the lower pole. */
    private double rise(double height) {
        return StrictMath.atan2(height, Math.sqrt(qx * qx + qz * qz)) + Math.PI / 2;
    }

    /** On the side of a box that the normal's largest component names. */
    private void box(double hx, double hy, double hz) {
        double ax = Math.abs(nx);
        double ay = Math.abs(ny);
        double az = Math.abs(nz);
        if (ay >= ax && ay >= az) {
            s = qx + hx;
            t = ny > 0 ? hz - qz : qz + hz;
        } else if (ax >= az) {
            s = nx > 0 ? hz - qz : qz + hz;
            t = qy + hy;
        } else {
            s = nz > 0 ? qx + hx : hx - qx;
            t = qy + hy;
        }
    }

    /**
     * Finds the place by the texture coordinates of a triangle's corners.
     *
     * @return false if the mesh has none there
     */
    boolean placeByCorners(MeshObject object, int triangle) {
        TriangleMesh mesh = object.triangles();
        if (triangle < 0 || !mesh.isTextured(triangle)) {
            return false;
        }
        // The shares of the corners are those of areas, seen along the axis that the normal follows most.
        int away = Math.abs(ny) >= Math.max(Math.abs(nx), Math.abs(nz)) ? 1 : Math.abs(nx) >= Math.abs(nz) ? 0 : 2;
        int one = (away + 1) % 3;
        int two = (away + 2) % 3;
        double pOne = own(one);
        double pTwo = own(two);
        double a = area(mesh, triangle, 1, 2, one, two, pOne, pTwo);
        double b = area(mesh, triangle, 2, 0, one, two, pOne, pTwo);
        double c = area(mesh, triangle, 0, 1, one, two, pOne, pTwo);
        double whole = a + b + c;
        if (whole == 0) {
            return false;
        }
        s = (a * mesh.textured(triangle, 0, 0) + b * mesh.textured(triangle, 1, 0) + c * mesh.textured(triangle, 2, 0))
                / whole;
        t = (a * mesh.textured(triangle, 0, 1) + b * mesh.textured(triangle, 1, 1) + c * mesh.textured(triangle, 2, 1))
                / whole;
        return true;
    }

    private double own(int axis) {
        return axis == 0 ? qx : axis == 1 ? qy : qz;
    }

    /** Twice the area between the point and two corners. */
    private static double area(TriangleMesh mesh, int triangle, int i, int j, int one, int two, double p, double q) {
        int v = mesh.vertex(triangle, i);
        int w = mesh.vertex(triangle, j);
        return (mesh.coordinate(v, one) - p) * (mesh.coordinate(w, two) - q)
                - (mesh.coordinate(w, one) - p) * (mesh.coordinate(v, two) - q);
    }
}
