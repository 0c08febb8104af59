package robosim.geometry.viewer;

import robosim.geometry.model.Point;

/** Where the world stands on the page: a scale, and margins for the title, the marks along the edge and the legend. */
final class MapFrame {
    /** The longest sides of the map; a page then fits a screen. */
    private static final double MAX_WIDTH = 1500;

    private static final double MAX_HEIGHT = 1050;

    /** Room for the legend; a narrower map is widened to it. */
    private static final double MIN_WIDTH = 760;

    static final double SIDE = 56;
    static final double TOP = 74;
    static final double BOTTOM = 116;

    final double scale;
    final double width;
    final double height;
    private final Scene.View view;
    private final double left;

    MapFrame(Scene.View view) {
        this.view = view;
        double across = view.maxX() - view.minX();
        double down = view.maxZ() - view.minZ();
        this.scale = Math.min(MAX_WIDTH / across, MAX_HEIGHT / down);
        this.width = Math.ceil(Math.max(MIN_WIDTH, across * scale) + 2 * SIDE);
        this.height = Math.ceil(down * scale + TOP + BOTTOM);
        this.left = (width - across * scale) / 2;
    }

    double x(double worldX) {
        return left + (worldX - view.minX()) * scale;
    }

    double y(double worldZ) {
        return TOP + (worldZ - view.minZ()) * scale;
    }

    double x(Point p) {
        return x(p.x());
    }

    double y(Point p) {
        return y(p.z());
    }

    double right() {
        return x(view.maxX());
    }

    double left() {
        return left;
    }

    double bottom() {
        return y(view.maxZ());
    }

    /** A polygon of the world on the page. */
    double[] toPage(double[] corners) {
        double[] page = new double[corners.length];
        for (int k = 0; k < corners.length; k += 2) {
            page[k] = x(corners[k]);
            page[k + 1] = y(corners[k + 1]);
        }
        return page;
    }

    /** The largest of 1, 2 and 5 times a power of ten that is at most so many world units; at least the least double. */
    static double roundLength(double atMost) {
        double power = StrictMath.pow(10, Math.floor(StrictMath.log10(atMost)));
        for (double factor : new double[] {10, 5, 2, 1}) {
            if (factor * power <= atMost) {
                return factor * power;
            }
        }
        return power;
    }
}
