package robosim.geometry.render;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/** Poses for cameras: towards a point, around it, and so that a whole box is in the picture. */
public final class Viewpoints {
    /** The share of the picture that what is to be seen may reach over. */
    private static final double FILLED = 0.93;

    private Viewpoints() {}

    /**
     * The pose of a camera that looks from one point to another, upright in the picture. One that looks straight up or down
     * has -Z up in a picture from above and +Z up in one from below, as on a plan.
     *
     * @throws IllegalArgumentException if the two are the same point
     */
    public static Pose lookAt(Point eye, Point target) {
        Checks.present("eye", eye);
        Checks.present("target", target);
        double x = target.x() - eye.x();
        double y = target.y() - eye.y();
        double z = target.z() - eye.z();
        double length = VectorMath.length(x, y, z);
        if (!(length > 0)) {
            throw new IllegalArgumentException("target must not be the eye itself (got: " + target + ")");
        }
        x /= length;
        y /= length;
        z /= length;
        // To the right: forward times up, which is (-z, 0, x).
        double level = VectorMath.length(x, 0, z);
        double rightX = level > 0x1p-20 ? -z / level : 1;
        double rightZ = level > 0x1p-20 ? x / level : 0;
        if (level <= 0x1p-20) {
            x = 0;
            z = 0;
            y = y < 0 ? -1 : 1;
        }
        // Up: to the right times forward.
        double upX = -rightZ * y;
        double upY = rightZ * x - rightX * z;
        double upZ = rightX * y;
        return Pose.of(eye, 0).oriented(new double[] {x, upX, rightX, y, upY, 0, z, upZ, rightZ});
    }

    /**
     * The pose of a camera that sees a whole box from a direction, from as near as it can, with the box in the middle of the
     * picture and a narrow border around it.
     *
     * @param azimuth     degrees counter-clockwise about the vertical from +X, where the camera stands as seen from the box
     * @param elevation   degrees above the level at which it stands, from -90 to 90
     * @param fieldOfView horizontal field of view in degrees, above 0 and below 180
     * @param aspect      width of the picture over its height
     */
    public static Pose around(Bounds box, double azimuth, double elevation, double fieldOfView, double aspect) {
        return around(corners(Checks.present("box", box)), azimuth, elevation, fieldOfView, aspect);
    }

    /**
     * The pose of a camera that sees some points from a direction, from as near as it can: in the direction that decides how
     * near that is, the points reach over {@value #FILLED} of the picture, and in both directions the border is the same on
     * either side.
     *
     * @param points      at least one
     * @param azimuth     degrees counter-clockwise about the vertical from +X, where the camera stands as seen from the points
     * @param elevation   degrees above the level at which it stands, from -90 to 90
     * @param fieldOfView horizontal field of view in degrees, above 0 and below 180
     * @param aspect      width of the picture over its height
     */
    public static Pose around(
            Collection<Point> points, double azimuth, double elevation, double fieldOfView, double aspect) {
        if (Checks.present("points", points).isEmpty()) {
            throw new IllegalArgumentException("points must not be empty (got: none)");
        }
        Checks.angle("azimuth", azimuth);
        check("elevation", elevation, -90, 90);
        if (!(fieldOfView > 0 && fieldOfView < 180)) { // written so that NaN fails it
            throw new IllegalArgumentException("fieldOfView must be above 0 and below 180 (got: " + fieldOfView + ")");
        }
        if (!(aspect > 0 && aspect <= 0x1p20)) {
            throw new IllegalArgumentException("aspect must be above 0 and at most 2^20 (got: " + aspect + ")");
        }
        double away = Degrees.cos(elevation);
        Point back = new Point(Degrees.cos(azimuth) * away, Degrees.sin(elevation), -Degrees.sin(azimuth) * away);
        Pose turned = lookAt(back, new Point());
        double[] r = turned.rotation();
        double wide = FILLED * Degrees.sin(fieldOfView / 2) / Degrees.cos(fieldOfView / 2);
        double high = wide / aspect;
        // The planes on the four sides of what may be seen each touch a point: their offsets, as seen along the
        // camera's axes.
        double right = Double.NEGATIVE_INFINITY;
        double left = Double.NEGATIVE_INFINITY;
        double top = Double.NEGATIVE_INFINITY;
        double bottom = Double.NEGATIVE_INFINITY;
        double near = Double.POSITIVE_INFINITY;
        double far = Double.NEGATIVE_INFINITY;
        for (Point point : points) {
            double ahead = r[0] * point.x() + r[3] * point.y() + r[6] * point.z();
            double up = r[1] * point.x() + r[4] * point.y() + r[7] * point.z();
            double aside = r[2] * point.x() + r[5] * point.y() + r[8] * point.z();
            right = Math.max(right, aside - wide * ahead);
            left = Math.max(left, -aside - wide * ahead);
            top = Math.max(top, up - high * ahead);
            bottom = Math.max(bottom, -up - high * ahead);
            near = Math.min(near, ahead);
            far = Math.max(far, ahead);
        }
        double ahead = Math.min(-(right + left) / (2 * wide), -(top + bottom) / (2 * high));
        // In front of a single point too, and of a corner that is sharper than the picture is wide.
        double eye = Math.min(ahead, near - Math.max((far - near) / 32, 0x1p-20 * Math.max(Math.abs(near), 0x1p-16)));
        double up = (top - bottom) / 2;
        double aside = (right - left) / 2;
        return turned.movedTo(new Point(
                r[0] * eye + r[1] * up + r[2] * aside,
                r[3] * eye + r[4] * up + r[5] * aside,
                r[6] * eye + r[7] * up + r[8] * aside));
    }

    /** The eight corners of a box. */
    public static List<Point> corners(Bounds box) {
        List<Point> corners = new ArrayList<>();
        for (int corner = 0; corner < 8; corner++) {
            corners.add(new Point(
                    (corner & 1) == 0 ? box.minX() : box.maxX(),
                    (corner & 2) == 0 ? box.minY() : box.maxY(),
                    (corner & 4) == 0 ? box.minZ() : box.maxZ()));
        }
        return corners;
    }

    /** The smallest box along the axes that holds some boxes. */
    public static Bounds enclosing(List<Bounds> boxes) {
        if (Checks.list("boxes", boxes).isEmpty()) {
            throw new IllegalArgumentException("boxes must not be empty (got: none)");
        }
        Bounds all = boxes.get(0);
        for (Bounds box : boxes) {
            all = new Bounds(
                    Math.min(all.minX(), box.minX()),
                    Math.min(all.minY(), box.minY()),
                    Math.min(all.minZ(), box.minZ()),
                    Math.max(all.maxX(), box.maxX()),
                    Math.max(all.maxY(), box.maxY()),
                    Math.max(all.maxZ(), box.maxZ()));
        }
        return all;
    }

    private static void check(String argument, double value, double least, double most) {
        if (!(value >= least && value <= most)) { // written so that NaN fails it
            throw new IllegalArgumentException(
                    argument + " must be from " + least + " to " + most + " (got: " + value + ")");
        }
    }
}
