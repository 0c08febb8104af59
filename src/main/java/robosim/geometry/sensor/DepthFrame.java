package robosim.geometry.sensor;

import java.io.IOException;
import java.nio.file.Path;
import robosim.geometry.check.Checks;
import robosim.geometry.model.RayPattern;

/** An image of a {@link DepthCamera}. */
public final class DepthFrame extends RayFrame {
    /** The largest depth in millimetres that 16 bits take. */
    private static final int MOST_MILLIMETRES = 0xffff;

    private static final int SOME = 1024;

    private double[] depths = new double[0];
    private final double[] directions = new double[3 * SOME];

    /** An empty frame. */
    public DepthFrame() {}

    void finish() {
        RayPattern rays = rays();
        int count = rays.size();
        if (depths.length < count) {
            depths = new double[count];
        }
        double[] ranges = ranges();
        for (int first = 0; first < count; first += SOME) {
            int some = Math.min(SOME, count - first);
            rays.directions(first, some, directions, 0);
            for (int k = 0; k < some; k++) {
                depths[first + k] = ranges[first + k] * directions[3 * k];
            }
        }
    }

    /**
     * The depth of a pixel along the optical axis, as depth images have it: {@code range(ray)} times how far the ray's unit
     * direction goes forward; {@code +Infinity} where nothing echoes, and for a range that is none as {@link RaySensor#withRep117} reports it.
     */
    public double depth(int ray) {
        return depths[checked(ray)];
    }

    /** All depths: the frame's own array, no copy. Elements from {@link #size} on mean nothing. */
    public double[] depths() {
        return depths;
    }

    /**
     * Writes all depths as whole millimetres of 16 bits without a sign, as depth images are stored and sent: 0 where nothing
     * echoes or where the depth is 65,535.5 mm or more. A depth of less than half a millimetre is 0 too.
     *
     * @param metresPerUnit of the world, above 0: 1 for a world in metres
     * @param out           has an element for each pixel
     */
    public void millimetres(double metresPerUnit, short[] out) {
        if (!(metresPerUnit > 0 && metresPerUnit <= Checks.LIMIT)) {
            throw new IllegalArgumentException(
                    "metresPerUnit must be above 0 and at most 2^100 (got: " + metresPerUnit + ")");
        }
        if (Checks.present("out", out).length < size()) {
            throw new IllegalArgumentException(
                    "out must have an element for each of " + size() + " pixels (got: " + out.length + ")");
        }
        double scale = 1000 * metresPerUnit;
        for (int k = 0; k < size(); k++) {
            double millimetres = Math.rint(depths[k] * scale);
            out[k] = (short) (millimetres >= 0 && millimetres <= MOST_MILLIMETRES ? (int) millimetres : 0);
        }
    }

    /**
     * Writes depths along the axis as PNG, greys of 16 bits, in whole millimetres, 0 where there is none: see {@link
     * #millimetres}.
     *
     * @param metresPerUnit of the world, above 0: 1 for a world in metres
     * @throws IOException if it cannot be written, naming the file
     * @throws IllegalArgumentException if nothing has been read into this frame
     */
    public void writePng(double metresPerUnit, Path file) throws IOException {
        short[] millimetres = new short[SensorFiles.pixels(this)];
        millimetres(metresPerUnit, millimetres);
        SensorFiles.writeGreys(millimetres, this, file);
    }
}
