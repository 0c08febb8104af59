package robosim.geometry.viewer.window;

import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.scene.Scene;

/**
 * The view of a window: the point of the world at the centre of its map, and a scale. Pixels are counted from the
 * window's upper left corner.
 */
public final class Camera {
    /** The zoom factor of a step of the wheel or of a key press. */
    static final double STEP = 1.2;

    /** The limits of zooming out and in, relative to the scale that shows the whole world. */
    private static final double LEAST = 0.2;

    private static final double MOST = 5000;

    private double width = 800;
    private double height = 600;
    private Scene.View whole = new Scene.View(-0.5, -0.5, 0.5, 0.5, false);
    private double centerX;
    private double centerZ;
    private double scale;

    /** Whether it always shows the whole world. */
    private boolean fitting = true;

    public Camera() {
        fit();
    }

    /** Changes the window's size; the centre of the view is kept. */
    public void resize(double newWidth, double newHeight) {
        width = newWidth;
        height = newHeight;
        if (fitting) {
            fit();
        }
    }

    /** Changes the world: shows all of it, unless its extent is the same as before. */
    public void look(Scene.View all) {
        if (!all.equals(whole)) {
            whole = all;
            fit();
        }
    }

    /** Shows the whole world from now on. */
    void fit() {
        fitting = true;
        centerX = (whole.minX() + whole.maxX()) / 2;
        centerZ = (whole.minZ() + whole.maxZ()) / 2;
        scale = fittingScale();
    }

    private double fittingScale() {
        double across = whole.maxX() - whole.minX();
        double down = whole.maxZ() - whole.minZ();
        return 0.98 * Math.min(MapFrame.screenWidth(width) / across, MapFrame.screenHeight(height) / down);
    }

    /** Zooms by a factor; the point of the world at the given pixel stays there. */
    void zoom(double x, double y, double factor) {
        MapFrame before = frame();
        double fitted = fittingScale();
        double wanted = Math.max(LEAST * fitted, Math.min(MOST * fitted, scale * factor));
        double worldX = before.worldX(x);
        double worldZ = before.worldZ(y);
        fitting = false;
        centerX = worldX + (centerX - worldX) * (scale / wanted);
        centerZ = worldZ + (centerZ - worldZ) * (scale / wanted);
        scale = wanted;
    }

    /** Moves the view by pixels; the centre stays within the world. */
    void pan(double dx, double dy) {
        fitting = false;
        centerX = clamp(centerX - dx / scale, whole.minX(), whole.maxX());
        centerZ = clamp(centerZ - dy / scale, whole.minZ(), whole.maxZ());
    }

    /** Moves the centre of the view to a place, which may be anywhere within the world. */
    void center(double x, double z) {
        fitting = false;
        centerX = clamp(x, whole.minX(), whole.maxX());
        centerZ = clamp(z, whole.minZ(), whole.maxZ());
    }

    private static double clamp(double value, double least, double most) {
        return Math.max(least, Math.min(most, value));
    }

    /** Pixels per world unit. */
    double scale() {
        return scale;
    }

    /** The layout of the window's map. */
    public MapFrame frame() {
        return MapFrame.screen(width, height, centerX, centerZ, scale);
    }
}
