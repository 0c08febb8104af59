package robosim.geometry.world.sdf;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.mesh.Prism;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;

/** Shapes of SDFormat that become closed surfaces of flat faces, whose inside is solid. */
final class SdfSurfaces {
    /** Sides around; the sides of a circle of radius 1 are within 0.0022 of it. */
    static final int SIDES = 48;

    private static final int RINGS = SIDES / 2;

    private SdfSurfaces() {}

    /** An ellipsoid of flat faces, whose corners are on it. */
    static MeshObject ellipsoid(double[] radii) {
        for (double radius : radii) {
            if (!(radius > 0)) {
                throw new IllegalArgumentException("radii must be above 0 (got: " + radius + ")");
            }
        }
        List<Point> vertices = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        vertices.add(SdfPose.place(0, 0, radii[2]));
        for (int ring = 1; ring < RINGS; ring++) {
            double down = 180.0 * ring / RINGS;
            for (int side = 0; side < SIDES; side++) {
                double around = 360.0 * side / SIDES;
                vertices.add(SdfPose.place(
                        radii[0] * Degrees.sin(down) * Degrees.cos(around),
                        radii[1] * Degrees.sin(down) * Degrees.sin(around),
                        radii[2] * Degrees.cos(down)));
            }
        }
        int last = vertices.size();
        vertices.add(SdfPose.place(0, 0, -radii[2]));
        for (int side = 0; side < SIDES; side++) {
            int next = (side + 1) % SIDES;
            faces.add(new int[] {0, 1 + side, 1 + next});
            for (int ring = 0; ring + 2 < RINGS; ring++) {
                int upper = 1 + ring * SIDES;
                int lower = upper + SIDES;
                faces.add(new int[] {upper + side, lower + side, lower + next});
                faces.add(new int[] {upper + side, lower + next, upper + next});
            }
            faces.add(new int[] {last - SIDES + side, last, last - SIDES + next});
        }
        return new MeshObject(vertices, faces.toArray(int[][]::new)).solid();
    }

    /** A cone of flat faces, its tip up. */
    static MeshObject cone(double radius, double length) {
        if (!(radius > 0) || !(length > 0)) {
            throw new IllegalArgumentException(
                    "radius and length must be above 0 (got: " + radius + " and " + length + ")");
        }
        List<Point> vertices = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (int side = 0; side < SIDES; side++) {
            double around = 360.0 * side / SIDES;
            vertices.add(SdfPose.place(radius * Degrees.cos(around), radius * Degrees.sin(around), -length / 2));
        }
        vertices.add(SdfPose.place(0, 0, length / 2));
        vertices.add(SdfPose.place(0, 0, -length / 2));
        for (int side = 0; side < SIDES; side++) {
            int next = (side + 1) % SIDES;
            faces.add(new int[] {side, next, SIDES});
            faces.add(new int[] {next, side, SIDES + 1});
        }
        return new MeshObject(vertices, faces.toArray(int[][]::new)).solid();
    }

    /** A polygon in X and Y, extruded from Z 0 to a height. */
    static MeshObject polyline(SdfElement shape) throws FileProblem {
        double height = shape.number("height");
        if (!(height > 0)) {
            throw shape.wrong("<height> must be above 0 (got: " + height + ")");
        }
        List<double[]> points = new ArrayList<>();
        for (SdfElement child : shape.children) {
            if (child.name.equals("point")) {
                double[] point = child.numbers(2);
                if (points.isEmpty() || !same(points.get(points.size() - 1), point)) {
                    points.add(point);
                }
            }
        }
        if (points.size() > 1 && same(points.get(0), points.get(points.size() - 1))) {
            points.remove(points.size() - 1); // some close it, some do not
        }
        int count = points.size();
        if (count < 3 || count > Limits.MAX_CORNERS) {
            throw shape.wrong(
                    "<polyline> must have 3 to " + Limits.MAX_CORNERS + " different points (got: " + count + ")");
        }
        if (Prism.doubleArea(points) < 0) {
            Collections.reverse(points);
        }
        return Prism.of(points, 0, height);
    }

    private static boolean same(double[] a, double[] b) {
        return a[0] == b[0] && a[1] == b[1];
    }
}
