package robosim.geometry.viewer.draw;

import robosim.geometry.check.NumberText;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.scene.Scene;

/** Paints the floor, lines at round coordinates with their numbers, the world's bounds, and the title. */
final class GridPainter {
    /** Of a multiple of a round length, without the noise of the product. */
    static final int DIGITS = 15;

    private final Scene scene;
    private final MapFrame frame;
    private final Canvas canvas;

    GridPainter(Scene scene, MapFrame frame, Canvas canvas) {
        this.scene = scene;
        this.frame = frame;
        this.canvas = canvas;
    }

    void paint() {
        canvas.open("grid", "");
        double left = frame.left();
        double top = frame.top();
        double right = frame.right();
        double bottom = frame.bottom();
        canvas.rectangle(left, top, right - left, bottom - top, Style.filled(Palette.FLOOR, 1));
        double step = MapFrame.roundLength(110 / frame.scale);
        Scene.View view = frame.visible();
        for (long k = (long) Math.ceil(view.minX() / step); k * step <= view.maxX(); k++) {
            double x = frame.x(k * step);
            canvas.line(x, top, x, bottom, Style.line(Palette.GRID, k == 0 ? 1.6 : 0.8, 1));
            canvas.text(x, bottom + 17, NumberText.digits(k * step, DIGITS), Canvas.Anchor.MIDDLE, 11, Palette.QUIET);
        }
        for (long k = (long) Math.ceil(view.minZ() / step); k * step <= view.maxZ(); k++) {
            double y = frame.y(k * step);
            canvas.line(left, y, right, y, Style.line(Palette.GRID, k == 0 ? 1.6 : 0.8, 1));
            canvas.text(left - 8, y + 4, NumberText.digits(k * step, DIGITS), Canvas.Anchor.END, 11, Palette.QUIET);
        }
        canvas.text(right + 22, bottom + 17, "x", Canvas.Anchor.START, 12, Palette.QUIET);
        canvas.text(left - 8, top - 12, "z", Canvas.Anchor.END, 12, Palette.QUIET);
        canvas.rectangle(left, top, right - left, bottom - top, Style.line(Palette.BORDER, 0.8, 0.5));
        if (scene.view().bordered()) {
            border(left, top, right, bottom);
        }
        canvas.close();
    }

    /** Paints the world's bounds; on a window's map only the visible part. */
    private void border(double left, double top, double right, double bottom) {
        Scene.View world = scene.view();
        boolean whole = world.equals(frame.visible());
        if (!whole) {
            canvas.clip(left, top, right - left, bottom - top);
        }
        double x = frame.x(world.minX());
        double y = frame.y(world.minZ());
        canvas.rectangle(
                x, y, frame.x(world.maxX()) - x, frame.y(world.maxZ()) - y, Style.line(Palette.BORDER, 2.5, 1));
        if (!whole) {
            canvas.unclip();
        }
    }

    void title() {
        canvas.open("title", "");
        canvas.text(frame.left(), 36, scene.title(), Canvas.Anchor.START, 22, Palette.TEXT);
        if (!scene.subtitle().isEmpty()) {
            canvas.text(frame.left(), 58, scene.subtitle(), Canvas.Anchor.START, 13, Palette.QUIET);
        }
        canvas.close();
    }
}
