package robosim.geometry.model;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;

/**
 * The beams of a range sensor: their directions in the sensor's own frame, whose +X is forward, +Y up and +Z to the
 * right. The order is fixed, row by row, so that element {@code row * columns() + column} of an answer belongs to the
 * same beam each time.
 *
 * <pre>{@code
 * RayPattern laser = RayPattern.fan(-135, 0.25, 1081);                                     // from right to left
 * RayPattern lidar = RayPattern.layers(new double[] {-15, -5, 5, 15}, 180, -0.2, 1800);    // a turn, clockwise
 * RayPattern camera = RayPattern.pinhole(320, 240, 87);                                    // a depth image
 * camera.size();                                                                           // 76800
 * camera.rows();                                                                           // 240
 * lidar.withDuration(0.1).time(900);                                                       // 0.05, half a turn
 * laser.direction(540).x();                                                                // 1: straight ahead
 * }</pre>
 *
 * Patterns are immutable and equal where their directions, bit for bit, their rows and their times are. Making one computes all
 * directions; keep it and use it again.
 */
public final class RayPattern {
    /** The maximum number of beams: an image of 4096 x 4096, whose directions take 400 MB. */
    public static final int MAX_SIZE = 1 << 24;

    private final int rows;
    private final int columns;

    /** Three numbers for each beam. */
    private final double[] directions;

    /** One for each beam, or one for each column; null where all beams are fired at once. */
    private final double @Nullable [] times;

    private final double farthestTime;

    /** Whether all directions are level: 0 if nobody has asked yet, else 1 or -1. Threads that ask at once find the same. */
    private int level;

    private RayPattern(int rows, int columns) {
        this(rows, columns, new double[3 * rows * columns], null);
    }

    private RayPattern(int rows, int columns, double[] directions, double @Nullable [] times) {
        this.rows = rows;
        this.columns = columns;
        this.directions = directions;
        this.times = times;
        double farthest = 0;
        for (int k = 0; times != null && k < times.length; k++) {
            farthest = Math.max(farthest, Math.abs(times[k]));
        }
        farthestTime = farthest;
    }

    /**
     * Beams in the sensor's own XZ plane, as a laser scanner or a ring of sonars has them. Beam k points
     * {@code firstDegrees + k * stepDegrees} counter-clockwise from forward, seen from above.
     *
     * @param count number of beams, 1 to {@link #MAX_SIZE}
     */
    public static RayPattern fan(double firstDegrees, double stepDegrees, int count) {
        Checks.angle("firstDegrees", firstDegrees);
        Checks.angle("stepDegrees", stepDegrees);
        checkSize("count", count, 1, "");
        RayPattern pattern = new RayPattern(1, count);
        pattern.sweep(0, 1, 0, firstDegrees, stepDegrees);
        return pattern;
    }

    /**
     * Layers of beams, as a lidar has them: row r has the beams of one elevation, column k those of one azimuth. A beam
     * points {@code firstAzimuthDegrees + k * stepAzimuthDegrees} counter-clockwise from forward, seen from above, and
     * from there up by its elevation.
     *
     * @param elevationsDegrees from -90 (down) to 90 (up), one for each row
     * @param count             number of columns; rows times columns are at most {@link #MAX_SIZE}
     */
    public static RayPattern layers(
            double[] elevationsDegrees, double firstAzimuthDegrees, double stepAzimuthDegrees, int count) {
        int layers = Checks.present("elevationsDegrees", elevationsDegrees).length;
        return layers(elevationsDegrees, new double[layers], firstAzimuthDegrees, stepAzimuthDegrees, count);
    }

    /**
     * Layers of beams that do not stand in one vertical plane: those of row r are turned by a further angle of their own,
     * as the lasers of many lidars are.
     *
     * @param elevationsDegrees from -90 (down) to 90 (up), one for each row
     * @param offsetsDegrees    what is added to the azimuths of each row
     * @param count             number of columns; rows times columns are at most {@link #MAX_SIZE}
     */
    public static RayPattern layers(
            double[] elevationsDegrees,
            double[] offsetsDegrees,
            double firstAzimuthDegrees,
            double stepAzimuthDegrees,
            int count) {
        int layers = Checks.present("elevationsDegrees", elevationsDegrees).length;
        if (Checks.present("offsetsDegrees", offsetsDegrees).length != layers) {
            throw new IllegalArgumentException("offsetsDegrees must have one number for each elevation, " + layers
                    + " (got: " + offsetsDegrees.length + ")");
        }
        if (layers == 0) {
            throw new IllegalArgumentException("elevationsDegrees must have at least one number (got: none)");
        }
        for (double elevation : elevationsDegrees) {
            if (!(Math.abs(elevation) <= 90)) { // written so that NaN fails it
                throw new IllegalArgumentException(
                        "an elevation must be from -90 to 90 degrees (got: " + elevation + ")");
            }
        }
        Checks.angle("firstAzimuthDegrees", firstAzimuthDegrees);
        Checks.angle("stepAzimuthDegrees", stepAzimuthDegrees);
        checkSize("count", count, layers, " columns of " + layers + " rows");
        RayPattern pattern = new RayPattern(layers, count);
        for (int row = 0; row < layers; row++) {
            double level = Degrees.cos(elevationsDegrees[row]);
            double up = Degrees.sin(elevationsDegrees[row]);
            double first = firstAzimuthDegrees + Checks.angle("an offset", offsetsDegrees[row]);
            pattern.sweep(row, level, up, first, stepAzimuthDegrees);
        }
        return pattern;
    }

    /** Sets the directions of a row: all of one elevation. */
    private void sweep(int row, double level, double up, double first, double step) {
        int at = 3 * row * columns;
        for (int k = 0; k < columns; k++) {
            double degrees = Checks.angle("angle of the last beam", first + k * step);
            directions[at++] = level * Degrees.cos(degrees) + 0.0; // no -0.0
            directions[at++] = up + 0.0;
            directions[at++] = level * -Degrees.sin(degrees) + 0.0;
        }
    }

    /**
     * One beam through the middle of each pixel of a camera without distortion: row by row from the top, each row from
     * the left. The optical axis, through the middle of the image, is the sensor's own +X; +Y is up in the image and +Z
     * to the right. Pixels are square. An answer is a distance along the beam from the pinhole, not a depth along the
     * axis: for that, multiply it by the beam's {@link #x}.
     *
     * @param width                        pixels in a row, at least 1
     * @param height                       rows, at least 1; all pixels are at most {@link #MAX_SIZE}
     * @param horizontalFieldOfViewDegrees from the left edge of the image to the right one, above 0 and below 180
     */
    public static RayPattern pinhole(int width, int height, double horizontalFieldOfViewDegrees) {
        checkSize("width", width, 1, "");
        checkSize("height", height, width, " rows of " + width + " pixels");
        if (!(horizontalFieldOfViewDegrees > 0 && horizontalFieldOfViewDegrees < 180)) {
            throw new IllegalArgumentException("horizontalFieldOfViewDegrees must be above 0 and below 180 (got: "
                    + horizontalFieldOfViewDegrees + ")");
        }
        RayPattern pattern = new RayPattern(height, width);
        double half = horizontalFieldOfViewDegrees / 2;
        double tangent = Degrees.sin(half) / Degrees.cos(half);
        double[] out = pattern.directions;
        int at = 0;
        for (int row = 0; row < height; row++) {
            double y = (double) (height - 1 - 2 * row) / width * tangent;
            for (int column = 0; column < width; column++) {
                double z = (double) (2 * column + 1 - width) / width * tangent;
                double length = Math.sqrt(1 + y * y + z * z);
                out[at++] = 1 / length;
                out[at++] = y / length;
                out[at++] = z / length;
            }
        }
        return pattern;
    }

    /**
     * One beam through the middle of each pixel of a camera without distortion, given by its intrinsic parameters as ROS
     * and OpenCV define them: the beam of the pixel in column u and row v, both counted from 0, goes {@code (u - cx) / fx}
     * to the right and {@code (v - cy) / fy} down for each unit forward. So {@code cx = (width - 1) / 2.0} is the middle of
     * the image. The order of the beams and their axes are as above.
     *
     * @param width  pixels in a row, at least 1
     * @param height rows, at least 1; all pixels are at most {@link #MAX_SIZE}
     * @param fx     focal length in widths of a pixel, above 0
     * @param fy     focal length in heights of a pixel, above 0
     * @param cx     column of the optical axis
     * @param cy     row of the optical axis
     */
    public static RayPattern pinhole(int width, int height, double fx, double fy, double cx, double cy) {
        checkSize("width", width, 1, "");
        checkSize("height", height, width, " rows of " + width + " pixels");
        checkFocalLength("fx", fx);
        checkFocalLength("fy", fy);
        Checks.coordinate("cx", cx);
        Checks.coordinate("cy", cy);
        RayPattern pattern = new RayPattern(height, width);
        double[] out = pattern.directions;
        int at = 0;
        for (int row = 0; row < height; row++) {
            double y = (cy - row) / fy;
            for (int column = 0; column < width; column++) {
                double z = (column - cx) / fx;
                double length = Math.sqrt(1 + y * y + z * z);
                out[at++] = 1 / length;
                out[at++] = y / length + 0.0; // no -0.0
                out[at++] = z / length + 0.0;
            }
        }
        return pattern;
    }

    // Bounds that no camera meets, within which the tangents of the angles to the axis can be squared.
    private static void checkFocalLength(String argument, double length) {
        if (!(length >= 0x1p-100 && length <= Checks.LIMIT)) {
            throw new IllegalArgumentException(argument + " must be from 2^-100 to 2^100 (got: " + length + ")");
        }
    }

    /**
     * Beams in any directions, in one row. The numbers are kept as given; the length of a direction has no effect on
     * distances.
     *
     * @param directions X, Y and Z of each direction, of any length but zero; copied
     */
    public static RayPattern of(double[] directions) {
        return of(Checks.present("directions", directions).length / 3, 1, directions);
    }

    /**
     * Beams in any directions, in rows: for a camera whose lens bends them, say.
     *
     * @param width      beams in a row, at least 1
     * @param height     rows, at least 1
     * @param directions X, Y and Z of each direction, row by row, of any length but zero; copied
     */
    public static RayPattern of(int width, int height, double[] directions) {
        int length = Checks.present("directions", directions).length;
        if (length == 0 || length % 3 != 0 || length / 3 > MAX_SIZE) {
            throw new IllegalArgumentException("directions must have three numbers for each beam, of 1 to " + MAX_SIZE
                    + " beams (got: " + length + " numbers)");
        }
        if ((long) width * height != length / 3) {
            throw new IllegalArgumentException(
                    "directions must be width times height, " + width + " x " + height + " (got: " + length / 3 + ")");
        }
        RayPattern pattern = new RayPattern(height, width, directions.clone(), null);
        pattern.check();
        return pattern;
    }

    private void check() {
        for (int k = 0; k < directions.length; k++) {
            if (!(Math.abs(directions[k]) <= Checks.LIMIT)) {
                Checks.coordinate("directions[" + k + "]", directions[k]);
            }
            directions[k] += 0.0; // no -0.0
        }
        for (int k = 0; k < size(); k++) {
            if (x(k) == 0 && y(k) == 0 && z(k) == 0) {
                throw new IllegalArgumentException("direction " + k + " must not be zero (got: (0.0, 0.0, 0.0))");
            }
        }
    }

    private static void checkSize(String argument, int count, int times, String what) {
        if (count < 1 || count > MAX_SIZE / times) {
            throw new IllegalArgumentException(
                    argument + " must be from 1 to " + MAX_SIZE / times + what + " (got: " + count + ")");
        }
    }

    /**
     * The same beams, each fired at a time of its own. Times count only for a sensor that moves while it measures: see
     * {@link SenseOptions#withMotion}.
     *
     * @param seconds for each beam, or for each column, when it is fired; 0 is when the sensor is where the call says, and
     *     earlier times are negative; copied
     */
    public RayPattern withTimes(double[] seconds) {
        int length = Checks.present("seconds", seconds).length;
        if (length != size() && length != columns) {
            throw new IllegalArgumentException("seconds must have " + size() + " numbers, one for each beam"
                    + (rows > 1 ? ", or " + columns + ", one for each column" : "") + " (got: " + length + ")");
        }
        double[] times = seconds.clone();
        for (int k = 0; k < length; k++) {
            times[k] = Checks.coordinate("seconds[" + k + "]", times[k]);
        }
        return new RayPattern(rows, columns, directions, times);
    }

    /**
     * The same beams, with the columns fired one after the other at equal intervals, the first one at 0: the scan of a laser
     * or the turn of a lidar.
     *
     * @param seconds from the first column to the first one of the next scan
     */
    public RayPattern withDuration(double seconds) {
        Checks.coordinate("seconds", seconds);
        double[] times = new double[columns];
        for (int k = 0; k < columns; k++) {
            times[k] = seconds * k / columns;
        }
        return withTimes(times);
    }

    /**
     * Whether no beam rises or falls, as in a {@link #fan}: the pattern of a level laser, which measures in the plane in a
     * PLANAR world.
     */
    public boolean isLevel() {
        if (level == 0) {
            level = findLevel() ? 1 : -1;
        }
        return level > 0;
    }

    private boolean findLevel() {
        for (int at = 1; at < directions.length; at += 3) {
            if (directions[at] != 0) {
                return false;
            }
        }
        return true;
    }

    /** Whether the beams are fired at different times. */
    public boolean hasTimes() {
        return times != null;
    }

    /** Whether all beams of a column are fired at the same time. */
    public boolean hasColumnTimes() {
        double[] at = times;
        return at == null || at.length == columns;
    }

    /** When a beam is fired, in seconds; 0 in a pattern without times. */
    public double time(int beam) {
        int checked = checked(beam);
        double[] at = times;
        return at == null ? 0 : at[at.length == columns ? checked % columns : checked];
    }

    /** The greatest of the times, without their signs; 0 in a pattern without times. */
    public double farthestTime() {
        return farthestTime;
    }

    /** The number of beams. */
    public int size() {
        return rows * columns;
    }

    /** The number of rows: of layers, or of rows of pixels; else 1. */
    public int rows() {
        return rows;
    }

    /** The number of beams in a row. */
    public int columns() {
        return columns;
    }

    /** How far a beam's direction goes forward. */
    public double x(int beam) {
        return directions[3 * checked(beam)];
    }

    /** How far a beam's direction goes up. */
    public double y(int beam) {
        return directions[3 * checked(beam) + 1];
    }

    /** How far a beam's direction goes to the right. */
    public double z(int beam) {
        return directions[3 * checked(beam) + 2];
    }

    /** The direction of a beam. */
    public Point direction(int beam) {
        return new Point(x(beam), y(beam), z(beam));
    }

    /**
     * Writes the directions of consecutive beams into an array, X, Y and Z of each.
     *
     * @param first the first beam
     * @param count how many of them
     * @param out   has room for three numbers for each
     * @param at    where in the array they begin
     */
    public void directions(int first, int count, double[] out, int at) {
        if (first < 0 || count < 0 || count > size() - first) {
            throw new IllegalArgumentException("first and count must tell beams from 0 to " + (size() - 1) + " (got: "
                    + first + " and " + count + ")");
        }
        Checks.present("out", out);
        if (at < 0 || at > out.length - 3 * count) {
            throw new IllegalArgumentException("at must leave room for " + 3 * count + " numbers in an array of "
                    + out.length + " (got: " + at + ")");
        }
        System.arraycopy(directions, 3 * first, out, at, 3 * count);
    }

    private int checked(int beam) {
        if (beam < 0 || beam >= size()) {
            throw new IllegalArgumentException("beam must be from 0 to " + (size() - 1) + " (got: " + beam + ")");
        }
        return beam;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof RayPattern that
                && rows == that.rows
                && Arrays.equals(directions, that.directions)
                && Arrays.equals(times, that.times);
    }

    @Override
    public int hashCode() {
        return 31 * (31 * rows + Arrays.hashCode(directions)) + Arrays.hashCode(times);
    }

    @Override
    public String toString() {
        return "RayPattern of " + rows + " x " + columns + " beams";
    }
}
