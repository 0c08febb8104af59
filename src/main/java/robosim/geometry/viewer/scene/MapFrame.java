package robosim.geometry.viewer.scene;

import robosim.geometry.model.Point;

/**
 * The position of the world on the page: a scale, and margins for the title, the marks along the edge and the legend.
 */
public final class MapFrame {
    /** The longest sides of the map; a page then fits a screen. */
    private static final double MAX_WIDTH = 1500;

    private static final double MAX_HEIGHT = 1050;

    /** Room for the legend; a narrower map is widened to it. */
    private static final double MIN_WIDTH = 760;

    static final double SIDE = 56;
    static final double TOP = 74;
    static final double BOTTOM = 116;

    /** Room along the edges of a window: numbers on the left, and below them the legend. */
    public final double scale;

    public final double width;
    public final double height;
    private final Scene.View visible;
    private final double left;
    private final double top;
    private final double below;

    /** A page around a part of the world. */
    public MapFrame(Scene.View view) {
        this.visible = view;
        double across = view.maxX() - view.minX();
        double down = view.maxZ() - view.minZ();
        this.scale = Math.min(MAX_WIDTH / across, MAX_HEIGHT / down);
        this.width = Math.ceil(Math.max(MIN_WIDTH, across * scale) + 2 * SIDE);
        this.height = Math.ceil(down * scale + TOP + BOTTOM);
        this.left = (width - across * scale) / 2;
        this.top = TOP;
        this.below = 64;
    }

    /** The part of the world that is on the map. */
    public Scene.View visible() {
        return visible;
    }

    public double x(double worldX) {
        return left + (worldX - visible.minX()) * scale;
    }

    public double y(double worldZ) {
        return top + (worldZ - visible.minZ()) * scale;
    }

    public double x(Point p) {
        return x(p.x());
    }

    public double y(Point p) {
        return y(p.z());
    }

    public double worldX(double x) {
        return visible.minX() + (x - left) / scale;
    }

    public double worldZ(double y) {
        return visible.minZ() + (y - top) / scale;
    }

    public double top() {
        return top;
    }

    public double right() {
        return x(visible.maxX());
    }

    public double left() {
        return left;
    }

    public double bottom() {
        return y(visible.maxZ());
    }

    /** The vertical position of the legend, below the map. */
    public double legend() {
        return bottom() + below;
    }

    /** A polygon of the world on the page. */
    public double[] toPage(double[] corners) {
        double[] page = new double[corners.length];
        for (int k = 0; k < corners.length; k += 2) {
            page[k] = x(corners[k]);
            page[k + 1] = y(corners[k + 1]);
        }
        return page;
    }

    /**
     * The largest of 1, 2 and 5 times a power of ten that is at most the given length; at least the smallest double.
     */
    public static double roundLength(double atMost) {
        double power = StrictMath.pow(10, Math.floor(StrictMath.log10(atMost)));
        for (double factor : new double[] {10, 5, 2, 1}) {
            if (factor * power <= atMost) {
                return factor * power;
            }
        }
        return power;
    }
}
