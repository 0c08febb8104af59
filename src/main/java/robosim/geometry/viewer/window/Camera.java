package robosim.geometry.viewer.window;

import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.scene.Scene;

/**
 * Where a window looks: a place of the world in the middle of its map, and a scale. Pixels are those of the window, from
 * its upper left corner.
 */
public final class Camera {
    /** A step of the wheel or of a key. */
    static final double STEP = 1.2;

    /** How far beyond the size that shows all of it a world can be made smaller, and larger. */
    private static final double LEAST = 0.2;

    private static final double MOST = 5000;

    private double width = 800;
    private double height = 600;
    private Scene.View whole = new Scene.View(-0.5, -0.5, 0.5, 0.5, false);
    private double centerX;
    private double centerZ;
    private double scale;

    /** Whether it shows all of it, whatever the size of the window. */
    private boolean fitting = true;

    public Camera() {
        fit();
    }

    /** The window has another size; what was in the middle stays there. */
    public void resize(double newWidth, double newHeight) {
        width = newWidth;
        height = newHeight;
        if (fitting) {
            fit();
        }
    }

    /** There is another world: all of it is shown, but where it has the extent of the one before. */
    public void look(Scene.View all) {
        if (!all.equals(whole)) {
            whole = all;
            fit();
        }
    }

    /** Shows all of it, from now on. */
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

    /** Makes the world larger by a factor, or smaller; what is at a pixel stays there. */
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

    /** Moves the world by pixels; its middle is never lost. */
    void pan(double dx, double dy) {
        fitting = false;
        centerX = clamp(centerX - dx / scale, whole.minX(), whole.maxX());
        centerZ = clamp(centerZ - dy / scale, whole.minZ(), whole.maxZ());
    }

    private static double clamp(double value, double least, double most) {
        return Math.max(least, Math.min(most, value));
    }

    /** Pixels for a world unit. */
    double scale() {
        return scale;
    }

    /** Where everything stands on the window. */
    public MapFrame frame() {
        return MapFrame.screen(width, height, centerX, centerZ, scale);
    }
}
