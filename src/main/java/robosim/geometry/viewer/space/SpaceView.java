package robosim.geometry.viewer.space;

import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/**
 * A view through a camera without distortion: how points of the world and of its picture correspond. Pixels are counted
 * from the upper left corner of the picture.
 *
 * @param pose        of the camera in the world; it looks along its own +X, with +Y up in the picture and +Z to the right
 * @param fieldOfView horizontal, in degrees
 * @param width       of the picture in pixels
 * @param height      of the picture
 */
public record SpaceView(Pose pose, double fieldOfView, int width, int height) {
    /** The angle in degrees that the longer side of a picture covers. */
    static final double LONG_SIDE = 60;

    /** What is nearer to the camera than this share of the coordinates is not drawn. */
    private static final double NEAR = 1e-9;

    public SpaceView {
        Checks.present("pose", pose);
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException(
                    "width and height must be at least 1 (got: " + width + " x " + height + ")");
        }
        if (!(fieldOfView > 0 && fieldOfView < 180)) { // written so that NaN fails it
            throw new IllegalArgumentException("fieldOfView must be above 0 and below 180 (got: " + fieldOfView + ")");
        }
    }

    /** A view of that size whose longer side covers the usual angle. */
    public static SpaceView of(Pose pose, int width, int height) {
        return new SpaceView(pose, horizontal(width, height), width, height);
    }

    /** The horizontal field of view of a picture whose longer side covers the usual angle. */
    static double horizontal(int width, int height) {
        return horizontal(width, height, LONG_SIDE);
    }

    /** The horizontal field of view of a picture whose longer side covers that angle. */
    static double horizontal(int width, int height, double longSide) {
        if (width >= height) {
            return longSide;
        }
        double tangent = Degrees.sin(longSide / 2) / Degrees.cos(longSide / 2) * width / height;
        return 2 * Degrees.toDegrees(StrictMath.atan(tangent));
    }

    /** Half the width of the picture at a distance of 1. */
    double tangent() {
        return Degrees.sin(fieldOfView / 2) / Degrees.cos(fieldOfView / 2);
    }

    /**
     * Finds the pixel at which a point of the world is seen.
     *
     * @param out takes its x and y, and how far ahead of the camera the point is
     * @return whether it is in front of the camera; if not, only the last number is set
     */
    public boolean project(double x, double y, double z, double[] out) {
        Point eye = pose.center();
        double dx = x - eye.x();
        double dy = y - eye.y();
        double dz = z - eye.z();
        double ahead = pose.rotation(0) * dx + pose.rotation(3) * dy + pose.rotation(6) * dz;
        double up = pose.rotation(1) * dx + pose.rotation(4) * dy + pose.rotation(7) * dz;
        double right = pose.rotation(2) * dx + pose.rotation(5) * dy + pose.rotation(8) * dz;
        out[2] = ahead;
        double size = Math.abs(eye.x()) + Math.abs(eye.y()) + Math.abs(eye.z());
        if (!(ahead > NEAR * Math.max(size, Math.abs(up) + Math.abs(right)))) {
            return false;
        }
        double scale = width / 2.0 / (tangent() * ahead);
        out[0] = width / 2.0 + right * scale;
        out[1] = height / 2.0 - up * scale;
        return true;
    }

    /** The unit direction in the world in which a point of the picture looks. */
    public Point direction(double x, double y) {
        double right = (2 * x - width) / width * tangent();
        double up = (height - 2 * y) / width * tangent();
        double length = Math.sqrt(1 + up * up + right * right);
        return new Point(
                (pose.rotation(0) + pose.rotation(1) * up + pose.rotation(2) * right) / length,
                (pose.rotation(3) + pose.rotation(4) * up + pose.rotation(5) * right) / length,
                (pose.rotation(6) + pose.rotation(7) * up + pose.rotation(8) * right) / length);
    }
}
