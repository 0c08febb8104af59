package robosim.geometry.render;

import java.util.List;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/** Poses for cameras: towards a point, around it, and so that a whole box is in the picture. */
public final class Viewpoints {
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
     * The pose of a camera that sees a whole box from a direction, from as near as it can.
     *
     * @param azimuth     degrees counter-clockwise about the vertical from +X, where the camera stands as seen from the box
     * @param elevation   degrees above the level at which it stands, from -90 to 90
     * @param fieldOfView horizontal field of view in degrees, above 0 and below 180
     * @param aspect      width of the picture over its height
     */
    public static Pose around(Bounds box, double azimuth, double elevation, double fieldOfView, double aspect) {
        Checks.present("box", box);
        Checks.angle("azimuth", azimuth);
        check("elevation", elevation, -90, 90);
        if (!(fieldOfView > 0 && fieldOfView < 180)) { // written so that NaN fails it
            throw new IllegalArgumentException("fieldOfView must be above 0 and below 180 (got: " + fieldOfView + ")");
        }
        if (!(aspect > 0 && aspect <= 0x1p20)) {
            throw new IllegalArgumentException("aspect must be above 0 and at most 2^20 (got: " + aspect + ")");
        }
        Point middle = new Point(
                box.minX() / 2 + box.maxX() / 2, box.minY() / 2 + box.maxY() / 2, box.minZ() / 2 + box.maxZ() / 2);
        double away = Degrees.cos(elevation);
        Point side = new Point(
                middle.x() + Degrees.cos(azimuth) * away,
                middle.y() + Degrees.sin(elevation),
                middle.z() - Degrees.sin(azimuth) * away);
        double[] r = lookAt(side, middle).rotation();
        double tangent = Degrees.sin(fieldOfView / 2) / Degrees.cos(fieldOfView / 2);
        // The distance from the middle at which each corner is just within the picture.
        double distance = 0;
        for (int corner = 0; corner < 8; corner++) {
            double x = ((corner & 1) == 0 ? box.minX() : box.maxX()) - middle.x();
            double y = ((corner & 2) == 0 ? box.minY() : box.maxY()) - middle.y();
            double z = ((corner & 4) == 0 ? box.minZ() : box.maxZ()) - middle.z();
            double ahead = r[0] * x + r[3] * y + r[6] * z;
            double up = Math.abs(r[1] * x + r[4] * y + r[7] * z);
            double right = Math.abs(r[2] * x + r[5] * y + r[8] * z);
            distance = Math.max(distance, Math.max(right / tangent, up * aspect / tangent) - ahead);
        }
        double far = Math.max(distance * 1.04, 0x1p-20); // a little air around it
        return lookAt(
                new Point(
                        middle.x() + (side.x() - middle.x()) * far,
                        middle.y() + (side.y() - middle.y()) * far,
                        middle.z() + (side.z() - middle.z()) * far),
                middle);
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
