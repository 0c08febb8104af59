package robosim.geometry.sensor;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.RayPattern;

/**
 * The size of a camera's images and its intrinsic parameters, as ROS and OpenCV define them: pixel (u, v), counted from 0
 * at the top left, looks {@code (u - cx) / fx} to the right and {@code (v - cy) / fy} down for each unit forward, if there is
 * no distortion.
 *
 * <pre>{@code
 * Intrinsics wide = Intrinsics.fieldOfView(640, 480, 90);
 * wide.fx();                   // 320.0
 * wide.cx();                   // 319.5: the middle of the image is between two pixels
 * wide.pattern().size();       // 307200
 * Intrinsics calibrated = new Intrinsics(640, 480, 525, 525, 319.5, 239.5);
 * }</pre>
 *
 * @param width  pixels in a row, at least 1
 * @param height rows, at least 1; all pixels are at most {@link RayPattern#MAX_SIZE}
 * @param fx     focal length in widths of a pixel, above 0
 * @param fy     focal length in heights of a pixel, above 0
 * @param cx     column of the optical axis
 * @param cy     row of the optical axis
 * @param distortion how the lens bends what it shows
 */
public record Intrinsics(int width, int height, double fx, double fy, double cx, double cy, Distortion distortion) {
    /** The most steps towards the place that a lens shows in a pixel; a few are enough where it can be found at all. */
    private static final int MOST_STEPS = 100;

    /** How a lens bends what it shows, as OpenCV describes it. */
    public static final class Distortion {
        /** A lens that bends nothing. */
        public static final Distortion NONE = brownConrady(0, 0, 0, 0, 0);

        private final boolean isFisheye;
        private final double first;
        private final double second;
        private final double third;
        private final double fourth;
        private final double fifth;

        /** Refuses numbers that are NaN or out of range. */
        private Distortion(boolean isFisheye, double... coefficients) {
            this.isFisheye = isFisheye;
            first = Checks.coordinate("first", coefficients[0]);
            second = Checks.coordinate("second", coefficients[1]);
            third = Checks.coordinate("third", coefficients[2]);
            fourth = Checks.coordinate("fourth", coefficients[3]);
            fifth = isFisheye ? 0 : Checks.coordinate("fifth", coefficients[4]);
        }

        /**
         * Brown and Conrady's: {@code plumb_bob} of ROS, {@code <distortion>} of SDFormat. With x to the right, y down and
         * r<sup>2</sup> = x<sup>2</sup> + y<sup>2</sup> for each unit forward, a point is seen at x (1 + k1 r<sup>2</sup> +
         * k2 r<sup>4</sup> + k3 r<sup>6</sup>) + 2 p1 x y + p2 (r<sup>2</sup> + 2 x<sup>2</sup>), and at y likewise with p1 and
         * p2 exchanged.
         */
        public static Distortion brownConrady(double k1, double k2, double p1, double p2, double k3) {
            return new Distortion(false, k1, k2, p1, p2, k3);
        }

        /**
         * A fisheye: {@code equidistant} of ROS. What is t radians off the axis is seen t (1 + k1 t<sup>2</sup> + k2
         * t<sup>4</sup> + k3 t<sup>6</sup> + k4 t<sup>8</sup>) from it. It may see more than half of the world.
         */
        public static Distortion fisheye(double k1, double k2, double k3, double k4) {
            return new Distortion(true, k1, k2, k3, k4);
        }

        /** Whether it is a fisheye. */
        public boolean isFisheye() {
            return isFisheye;
        }

        /** Whether the camera is a pinhole. */
        public boolean isNone() {
            return equals(NONE);
        }

        /** The coefficients in the order of OpenCV and of a {@code CameraInfo} of ROS. */
        public double[] coefficients() {
            return isFisheye
                    ? new double[] {first, second, third, fourth}
                    : new double[] {first, second, third, fourth, fifth};
        }

        @Override
        public boolean equals(@Nullable Object other) {
            return other instanceof Distortion that
                    && isFisheye == that.isFisheye
                    && Arrays.equals(coefficients(), that.coefficients());
        }

        @Override
        public int hashCode() {
            return Arrays.hashCode(coefficients());
        }

        @Override
        public String toString() {
            return (isFisheye ? "fisheye " : "Brown-Conrady ") + Arrays.toString(coefficients());
        }

        /** Writes what is seen at a place of the image, a unit in front: forward, up and to the right. */
        private boolean aim(double seenX, double seenY, double[] out, int at) {
            if (isFisheye) {
                return aimFisheye(seenX, seenY, out, at);
            }
            double x = seenX;
            double y = seenY;
            for (int step = 0; step < MOST_STEPS; step++) {
                double square = x * x + y * y;
                double radial = 1 + square * (first + square * (second + square * fifth));
                // Half of the derivative of the radial factor by r squared, times two.
                double slope = 2 * (first + square * (2 * second + square * 3 * fifth));
                double offX = x * radial + 2 * third * x * y + fourth * (square + 2 * x * x) - seenX;
                double offY = y * radial + 2 * fourth * x * y + third * (square + 2 * y * y) - seenY;
                double xx = radial + slope * x * x + 2 * third * y + 6 * fourth * x;
                double xy = slope * x * y + 2 * third * x + 2 * fourth * y;
                double yy = radial + slope * y * y + 2 * fourth * x + 6 * third * y;
                double determinant = xx * yy - xy * xy;
                if (!(determinant > 0) || !(xx + yy > 0)) {
                    return false; // beyond where the lens turns what it shows inside out
                }
                double moveX = (offX * yy - offY * xy) / determinant;
                double moveY = (offY * xx - offX * xy) / determinant;
                x -= moveX;
                y -= moveY;
                if (Math.abs(moveX) + Math.abs(moveY) <= 0x1p-48 * (1 + Math.abs(x) + Math.abs(y))) {
                    unit(1, -y, x, out, at);
                    return true;
                }
            }
            return false;
        }

        private boolean aimFisheye(double seenX, double seenY, double[] out, int at) {
            double seen = Math.sqrt(seenX * seenX + seenY * seenY);
            double off = seen; // radians off the axis
            for (int step = 0; step < MOST_STEPS; step++) {
                double s = off * off;
                double shown = off * (1 + s * (first + s * (second + s * (third + s * fourth))));
                double slope = 1 + s * (3 * first + s * (5 * second + s * (7 * third + s * 9 * fourth)));
                if (!(slope > 0) || off > Math.PI) {
                    return false;
                }
                double move = (shown - seen) / slope;
                off -= move;
                if (Math.abs(move) <= 0x1p-48 * (1 + off)) {
                    double aside = seen > 0 ? StrictMath.sin(off) / seen : 1;
                    unit(StrictMath.cos(off), -seenY * aside, seenX * aside, out, at);
                    return true;
                }
            }
            return false;
        }

        private static void unit(double x, double y, double z, double[] out, int at) {
            double length = Math.sqrt(x * x + y * y + z * z);
            out[at] = x / length + 0.0; // no -0.0
            out[at + 1] = y / length + 0.0;
            out[at + 2] = z / length + 0.0;
        }
    }

    /** A camera without distortion. */
    public Intrinsics(int width, int height, double fx, double fy, double cx, double cy) {
        this(width, height, fx, fy, cx, cy, Distortion.NONE);
    }

    /** Refuses numbers out of range. */
    public Intrinsics {
        Checks.present("distortion", distortion);
        checkSize("width", width, 1, "");
        checkSize("height", height, width, " rows of " + width + " pixels");
        checkFocalLength("fx", fx);
        checkFocalLength("fy", fy);
        checkCentre("cx", cx);
        checkCentre("cy", cy);
        cx += 0.0; // no -0.0
        cy += 0.0;
    }

    /**
     * Square pixels and an optical axis through the middle of the image.
     *
     * @param horizontalFieldOfViewDegrees from the left edge of the image to the right one, from 0.001 to 179.999
     */
    public static Intrinsics fieldOfView(int width, int height, double horizontalFieldOfViewDegrees) {
        if (!(horizontalFieldOfViewDegrees >= 0.001 && horizontalFieldOfViewDegrees <= 179.999)) {
            throw new IllegalArgumentException("horizontalFieldOfViewDegrees must be from 0.001 to 179.999 (got: "
                    + horizontalFieldOfViewDegrees + ")");
        }
        double half = horizontalFieldOfViewDegrees / 2;
        double focalLength = width * Degrees.cos(half) / (2 * Degrees.sin(half));
        return new Intrinsics(width, height, focalLength, focalLength, (width - 1) / 2.0, (height - 1) / 2.0);
    }

    private static void checkSize(String argument, int count, int times, String what) {
        int most = RayPattern.MAX_SIZE / times;
        if (count < 1 || count > most) {
            throw new IllegalArgumentException(
                    argument + " must be from 1 to " + most + what + " (got: " + count + ")");
        }
    }

    private static void checkFocalLength(String argument, double length) {
        if (!(length >= 0x1p-20 && length <= 0x1p60)) { // written so that NaN fails it
            throw new IllegalArgumentException(argument + " must be from 2^-20 to 2^60 (got: " + length + ")");
        }
    }

    private static void checkCentre(String argument, double place) {
        if (!(Math.abs(place) <= 0x1p60)) {
            throw new IllegalArgumentException(argument + " must be from -2^60 to 2^60 (got: " + place + ")");
        }
    }

    /** The same camera with another lens. */
    public Intrinsics withDistortion(Distortion other) {
        return new Intrinsics(width, height, fx, fy, cx, cy, other);
    }

    /**
     * One ray through the middle of each pixel, row by row from the top.
     *
     * @throws IllegalArgumentException if the distortion shows nothing in some pixel: its numbers are not for this image
     */
    public RayPattern pattern() {
        if (distortion.isNone()) {
            return RayPattern.pinhole(width, height, fx, fy, cx, cy);
        }
        double[] directions = new double[3 * width * height];
        int at = 0;
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++, at += 3) {
                aim(column, row, directions, at);
            }
        }
        return RayPattern.of(width, height, directions);
    }

    /**
     * Writes the unit direction of a place in the image: forward, up and to the right.
     *
     * @param column counted from 0, the middle of the first pixel; may be between pixels
     * @param row    likewise, from the top
     * @param out    takes three numbers
     * @param at     the index of the first one
     * @throws IllegalArgumentException if the distortion shows nothing there
     */
    public void aim(double column, double row, double[] out, int at) {
        if (!distortion.aim((column - cx) / fx, (row - cy) / fy, out, at)) {
            throw new IllegalArgumentException(
                    "distortion must show something in every pixel; check its coefficients and"
                            + " the focal length (got: " + distortion + ", nothing in column " + column + " of row "
                            + row + ")");
        }
    }
}
