package robosim.geometry.sensor;

import robosim.geometry.SenseBuffer;
import robosim.geometry.check.Checks;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.Twist;

/**
 * A lidar or laser scanner: rays that turn, each with its ring and its time.
 *
 * <pre>{@code
 * Lidar roof = Lidar.ousterOs1With128(10).on("robot", Pose.of(new Point(0, 1.2, 0), 0));
 * roof.pattern().rows();                   // 128
 * Lidar laser = Lidar.hokuyoUtm30lx();
 * laser.pattern().size();                  // 1081
 * RayPattern rings = RayPattern.layers(new double[] {-10, 0, 10}, 180, -0.5, 720).withDuration(0.1);
 * Lidar own = Lidar.of(rings, SenseOptions.range(0.5, 50)).withMotion(Twist.drive(1.5, 20));
 * own.time(719) < 0.1;                     // true: the last column of a turn that takes a tenth of a second
 * }</pre>
 *
 * <p>The presets follow what their manufacturers publish of the beams' directions, times and ranges, with one metre to the
 * world unit; real sensors differ from it by their calibration. Their rows count from the lowest beam up, and their
 * columns begin behind the sensor, or at the end of its field of view, so that straight ahead is in the middle. Azimuths
 * are those of the start of a firing: what a head turns while its lasers fire one after another, less than the step
 * between two columns, is not in the directions.
 */
public final class Lidar extends RaySensor<Lidar, LidarFrame> {
    /** Seconds from the firing of one laser of a VLP-16 or VLP-32C to that of the next, and of the whole sequence. */
    private static final double FIRING = 2.304e-6;

    private static final double SEQUENCE = 55.296e-6;

    // Elevation and azimuth offset of the lasers of a VLP-32C, from the lowest up.
    private static final double[] VLP32C_ELEVATIONS = {
        -25, -15.639, -11.31, -8.843, -7.254, -6.148, -5.333, -4.667, -4, -3.667, -3.333, -3, -2.667, -2.333, -2,
        -1.667, -1.333, -1, -0.667, -0.333, 0, 0.333, 0.667, 1, 1.333, 1.667, 2.333, 3.333, 4.667, 7, 10.333, 15
    };
    private static final double[] VLP32C_AZIMUTHS = {
        1.4, -1.4, 1.4, -1.4, 1.4, -1.4, 4.2, 1.4, -1.4, -4.2, 4.2, 1.4, -1.4, -4.2, 4.2, 1.4, -1.4, -4.2, 4.2, 1.4,
        -1.4, -4.2, 4.2, 1.4, -1.4, -4.2, 1.4, -1.4, 1.4, -1.4, 1.4, -1.4
    };

    // The number of each of these lasers in the firing order, in which two fire at once.
    private static final int[] VLP32C_IDS = {
        0, 3, 4, 7, 8, 11, 12, 16, 15, 19, 20, 24, 23, 27, 28, 2, 31, 1, 6, 10, 5, 9, 14, 18, 13, 17, 22, 21, 26, 25,
        30, 29
    };

    /** Seconds from the first ray of a column to the others of it, by row. */
    private final double[] delays;

    private Lidar(Setup setup, double[] delays) {
        super(setup);
        this.delays = delays;
    }

    /**
     * A lidar with any rays, whose rows are its rings; it sends them at the {@linkplain RayPattern#withTimes times} of the
     * pattern.
     *
     * @param options how the rays are asked; of width 0
     */
    public static Lidar of(RayPattern pattern, SenseOptions options) {
        if (Checks.present("options", options).width() > 0) {
            throw new IllegalArgumentException("width must be 0 for a lidar (got: " + options.width() + ")");
        }
        return new Lidar(
                Setup.of(pattern, options),
                new double[Checks.present("pattern", pattern).rows()]);
    }

    /**
     * A Velodyne VLP-16 ("Puck"): 16 lasers from -15 to 15 degrees in steps of 2, that fire one after another every 2.304
     * microseconds, a sequence of 55.296 microseconds; up to 100 m. Source: Velodyne, VLP-16 User Manual 63-9243 Rev. D,
     * 9.3 to 9.5. It names no blind range; here it is 0.
     *
     * @param hertz turns in a second, 5 to 20
     */
    public static Lidar velodyneVlp16(double hertz) {
        double[] elevations = new double[16];
        int[] order = new int[16];
        for (int row = 0; row < 16; row++) {
            elevations[row] = 2 * row - 15;
            // In firing order: -15, 1, -13, 3, ..., -1, 15.
            order[row] = row < 8 ? 2 * row : 2 * (row - 8) + 1;
        }
        return velodyne(elevations, new double[16], order, hertz, 100);
    }

    /**
     * A Velodyne VLP-32C ("Ultra Puck"): 32 lasers from -25 to 15 degrees, closer near the horizon and in four columns of
     * different azimuths, that fire in pairs every 2.304 microseconds, a sequence of 55.296 microseconds; up to 200 m.
     * Source: Velodyne, VLP-32C User Manual 63-9325 Rev. C, 9.3 to 9.5, tables 9-2 and 9-6. It names no blind range; here
     * it is 0.
     *
     * @param hertz turns in a second, 5 to 20
     */
    public static Lidar velodyneVlp32c(double hertz) {
        int[] order = new int[32];
        double[] offsets = new double[32];
        for (int row = 0; row < 32; row++) {
            order[row] = VLP32C_IDS[row] / 2;
            offsets[row] = -VLP32C_AZIMUTHS[row]; // theirs are clockwise
        }
        return velodyne(VLP32C_ELEVATIONS, offsets, order, hertz, 200);
    }

    private static Lidar velodyne(double[] elevations, double[] offsets, int[] order, double hertz, double max) {
        checkRate(hertz, 5, 20);
        int columns = (int) Math.round(1 / (hertz * SEQUENCE));
        int middle = columns / 2;
        double step = -360 * hertz * SEQUENCE; // clockwise, as seen from above
        RayPattern pattern = RayPattern.layers(elevations, offsets, -middle * step, step, columns)
                .withDuration(columns * SEQUENCE);
        double[] delays = new double[order.length];
        for (int row = 0; row < delays.length; row++) {
            delays[row] = order[row] * FIRING;
        }
        return new Lidar(Setup.of(pattern, SenseOptions.range(0, max)), delays);
    }

    /**
     * An Ouster OS1 with 64 channels: evenly from -16.6 to 16.6 degrees, 1024 columns, all channels of a column at once;
     * 0.8 to 120 m. Source: Ouster, OS1 datasheet ("OS1 High Resolution Imaging Lidar").
     *
     * @param hertz turns in a second, 10 or 20
     */
    public static Lidar ousterOs1With64(double hertz) {
        return ouster(64, 16.6, hertz);
    }

    /**
     * An Ouster OS1 with 128 channels: evenly from -22.5 to 22.5 degrees, 1024 columns, all channels of a column at once;
     * 0.8 to 120 m. Source: Ouster, OS1 datasheet ("OS1 High Resolution Imaging Lidar").
     *
     * @param hertz turns in a second, 10 or 20
     */
    public static Lidar ousterOs1With128(double hertz) {
        return ouster(128, 22.5, hertz);
    }

    private static Lidar ouster(int channels, double end, double hertz) {
        checkRate(hertz, 10, 20);
        double[] elevations = new double[channels];
        for (int row = 0; row < channels; row++) {
            elevations[row] = end * (2 * row - (channels - 1)) / (channels - 1);
        }
        RayPattern pattern =
                RayPattern.layers(elevations, 180, -360.0 / 1024, 1024).withDuration(1 / hertz);
        return of(pattern, SenseOptions.range(0.8, 120));
    }

    private static void checkRate(double hertz, double least, double most) {
        if (!(hertz >= least && hertz <= most)) { // written so that NaN fails it
            throw new IllegalArgumentException(
                    "hertz must be from " + (int) least + " to " + (int) most + " (got: " + hertz + ")");
        }
    }

    /**
     * A Hokuyo UTM-30LX: a planar laser with 1081 rays over 270 degrees, from right to left, 1440 steps to a turn of 25 ms;
     * 0.1 to 30 m. Sources: Hokuyo, "Communication Protocol Specification for SCIP2.0" C-42-03320B, table 2, and the
     * specification of the UTM-30LX.
     */
    public static Lidar hokuyoUtm30lx() {
        RayPattern pattern = RayPattern.fan(-135, 0.25, 1081).withDuration(0.025 * 1081 / 1440);
        return of(pattern, SenseOptions.range(0.1, 30));
    }

    /**
     * A Robotis LDS-02, the laser of a TurtleBot3: planar, 360 rays, one for each degree, counter-clockwise from behind; 5
     * turns a second; 0.16 to 8 m. Source: Robotis, e-Manual of TurtleBot3, "LDS-02".
     */
    public static Lidar robotisLds02() {
        return of(RayPattern.fan(-180, 1, 360).withDuration(0.2), SenseOptions.range(0.16, 8));
    }

    /**
     * This lidar, moving during its turns: see {@link SenseOptions#withMotion}. Each column is measured from where the lidar
     * is when its first ray is sent; the pose at which a frame is read is that of time 0.
     */
    public Lidar withMotion(Twist velocity) {
        return with(setup.with(setup.options().withMotion(velocity)));
    }

    /** This lidar at rest during its turns. */
    public Lidar withoutMotion() {
        return with(setup.with(setup.options().withoutMotion()));
    }

    /** Seconds from the start of a turn until a ray is sent; the pattern has the time of its column's first ray. */
    public double time(int ray) {
        if (ray < 0 || ray >= pattern().size()) {
            throw new IllegalArgumentException(
                    "ray must be from 0 to " + (pattern().size() - 1) + " (got: " + ray + ")");
        }
        return pattern().time(ray) + delays[ray / pattern().columns()];
    }

    @Override
    Lidar with(Setup other) {
        return new Lidar(other, delays);
    }

    @Override
    void finish(LidarFrame out) {
        out.finish(this);
    }

    @Override
    boolean needs(SenseBuffer.Extra extra, LidarFrame out) {
        return out.has(LidarFrame.Extra.INTENSITIES)
                || (out.has(LidarFrame.Extra.OBJECTS) && extra != SenseBuffer.Extra.NORMALS);
    }
}
