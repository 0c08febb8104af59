package robosim.geometry.viewer.space;

import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.render.Viewpoints;

/**
 * A camera that a hand moves: it looks at a point from a distance, circles it, moves with it, comes nearer, or looks around
 * from where it is. It stays upright in the picture.
 */
public final class SpaceCamera {
    /** Degrees by which a pixel of a drag turns. */
    static final double DEGREES_PER_PIXEL = 0.4;

    /** The zoom factor of a step of the wheel or of a key press. */
    public static final double STEP = 1.2;

    /** The share of its distance by which a key press moves the camera. */
    static final double STRIDE = 0.08;

    /** The limits of the distance from the point looked at, relative to the size of the world. */
    private static final double NEAREST = 1e-4;

    private static final double FARTHEST = 20;

    private final double firstAzimuth;
    private final double firstElevation;

    private int width = 800;
    private int height = 600;
    private Bounds whole = new Bounds(-0.5, 0, -0.5, 0.5, 0.5, 0.5);

    // The point looked at, and where the camera is as seen from there.
    private double x;
    private double y;
    private double z;
    private double azimuth;
    private double elevation;
    private double distance;

    /** Whether it always shows the whole world. */
    private boolean fitting = true;

    /**
     * A camera that sees the whole world from a direction.
     *
     * @param azimuth   degrees counter-clockwise about the vertical from +X, where the camera is as seen from the world
     * @param elevation degrees above the level of what it looks at, from -90 to 90
     */
    public SpaceCamera(double azimuth, double elevation) {
        firstAzimuth = Checks.angle("azimuth", azimuth);
        if (!(elevation >= -90 && elevation <= 90)) { // written so that NaN fails it
            throw new IllegalArgumentException("elevation must be from -90 to 90 (got: " + elevation + ")");
        }
        firstElevation = elevation;
        fit();
    }

    /** A camera with the usual view: from a corner, from above. */
    public static SpaceCamera usual() {
        return new SpaceCamera(-60, 35);
    }

    /** Changes the size of its picture; it stays where it is, unless it shows the whole world. */
    public void resize(int newWidth, int newHeight) {
        int wide = Math.max(1, newWidth);
        int high = Math.max(1, newHeight);
        if (wide == width && high == height) {
            return;
        }
        width = wide;
        height = high;
        if (fitting) {
            fit();
        }
    }

    /** Changes the world: shows all of it, unless its extent is the same as before. */
    public void look(Bounds all) {
        if (!all.equals(whole)) {
            whole = all;
            fit();
        }
    }

    /** Shows the whole world from the first direction from now on. */
    public void fit() {
        fitting = true;
        azimuth = firstAzimuth;
        elevation = firstElevation;
        x = whole.middleX();
        y = whole.middleY();
        z = whole.middleZ();
        Pose pose = Viewpoints.around(
                whole, azimuth, elevation, SpaceView.horizontal(width, height), (double) width / height);
        distance = length(pose.center());
    }

    private double length(Point from) {
        return VectorMath.length(from.x() - x, from.y() - y, from.z() - z);
    }

    private double size() {
        return whole.width() + whole.height() + whole.length();
    }

    /** Circles the point looked at, by pixels of a drag: what is in front follows the hand. */
    public void orbit(double dx, double dy) {
        fitting = false;
        azimuth = turned(-dx);
        elevation = tipped(dy);
    }

    /** Looks around from where it is, by pixels of a drag: what is seen follows the hand. */
    public void lookAround(double dx, double dy) {
        fitting = false;
        Point eye = eye();
        azimuth = turned(dx);
        elevation = tipped(dy);
        x += eye.x() - eye().x();
        y += eye.y() - eye().y();
        z += eye.z() - eye().z();
    }

    private double turned(double pixels) {
        double degrees = azimuth + DEGREES_PER_PIXEL * pixels;
        return degrees - 360 * Math.floor(degrees / 360);
    }

    private double tipped(double pixels) {
        return Math.max(-90, Math.min(90, elevation + DEGREES_PER_PIXEL * pixels));
    }

    /** Moves across its line of sight, by pixels of a drag: the point looked at follows the hand. */
    public void pan(double dx, double dy) {
        fitting = false;
        double each = perPixel();
        shift(0, dy * each, -dx * each);
    }

    /** World units that a pixel covers at the point looked at. */
    private double perPixel() {
        double half = SpaceView.horizontal(width, height) / 2;
        return 2 * distance * Degrees.sin(half) / Degrees.cos(half) / width;
    }

    /** Comes nearer by a factor; what is at the given pixel, as far away as the point looked at, stays there. */
    public void zoom(double px, double py, double factor) {
        fitting = false;
        double each = perPixel();
        double right = (px - width / 2.0) * each;
        double up = (height / 2.0 - py) * each;
        double wanted = Math.max(NEAREST * size(), Math.min(FARTHEST * size(), distance / factor));
        double share = 1 - wanted / distance;
        shift(0, up * share, right * share);
        distance = wanted;
    }

    /** Flies, together with the point looked at, in steps of a share of the distance between them. */
    public void fly(double ahead, double up, double right) {
        fitting = false;
        double stride = STRIDE * distance;
        shift(ahead * stride, up * stride, right * stride);
    }

    /** Looks at another point from where that leaves it; the distance and the direction stay. */
    public void center(Point target) {
        fitting = false;
        x = target.x();
        y = target.y();
        z = target.z();
        clamp();
    }

    private void shift(double ahead, double up, double right) {
        double[] r = rotation();
        x += r[0] * ahead + r[1] * up + r[2] * right;
        y += r[3] * ahead + r[4] * up + r[5] * right;
        z += r[6] * ahead + r[7] * up + r[8] * right;
        clamp();
    }

    /** The point looked at stays near the world, so that nobody gets lost. */
    private void clamp() {
        double far = size();
        x = Math.max(whole.minX() - far, Math.min(whole.maxX() + far, x));
        y = Math.max(whole.minY() - far, Math.min(whole.maxY() + far, y));
        z = Math.max(whole.minZ() - far, Math.min(whole.maxZ() + far, z));
    }

    private Point eye() {
        double away = distance * Degrees.cos(elevation);
        return new Point(
                x + away * Degrees.cos(azimuth),
                y + distance * Degrees.sin(elevation),
                z - away * Degrees.sin(azimuth));
    }

    /** The columns are forward, up and right; also defined where it looks straight down. */
    private double[] rotation() {
        return rotation(azimuth, elevation);
    }

    /** The rotation of a camera that is in that direction from what it looks at. */
    static double[] rotation(double azimuth, double elevation) {
        double ca = Degrees.cos(azimuth);
        double sa = Degrees.sin(azimuth);
        double ce = Degrees.cos(elevation);
        double se = Degrees.sin(elevation);
        return new double[] {-ca * ce, -ca * se, -sa, -se, ce, 0, sa * ce, sa * se, -ca};
    }

    /** The point looked at. */
    Point target() {
        return new Point(x, y, z);
    }

    double distance() {
        return distance;
    }

    /** What it sees. */
    public SpaceView view() {
        return SpaceView.of(Pose.of(eye(), 0).oriented(rotation()), width, height);
    }
}
