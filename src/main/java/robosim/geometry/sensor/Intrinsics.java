package robosim.geometry.sensor;

import robosim.geometry.exact.Degrees;
import robosim.geometry.model.RayPattern;

/**
 * The size of a camera's images and its intrinsic parameters, as ROS and OpenCV define them: pixel (u, v), counted from 0
 * at the top left, looks {@code (u - cx) / fx} to the right and {@code (v - cy) / fy} down for each unit forward. There is
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
 */
public record Intrinsics(int width, int height, double fx, double fy, double cx, double cy) {
    /** Refuses numbers out of range. */
    public Intrinsics {
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

    /** One ray through the middle of each pixel, row by row from the top. */
    public RayPattern pattern() {
        return RayPattern.pinhole(width, height, fx, fy, cx, cy);
    }
}
