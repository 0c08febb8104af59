package robosim.geometry.viewer.draw;

import java.util.List;
import robosim.geometry.check.NumberText;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.scene.Scene;

/** Paints the legend below the map: the scale bar, the colour ramp of distances, and the meaning of marks. */
final class LegendPainter {
    private static final double TEXT_SIZE = 12;

    private final Scene scene;
    private final MapFrame frame;
    private final Canvas canvas;
    private final double farthest;

    LegendPainter(Scene scene, MapFrame frame, Canvas canvas, double farthest) {
        this.scene = scene;
        this.frame = frame;
        this.canvas = canvas;
        this.farthest = farthest;
    }

    void paint() {
        double y = frame.legend();
        double x = frame.left();
        x = scaleBar(x, y) + 48;
        if (farthest > 0) {
            x = ramp(x, y) + 48;
        }
        marks(x, y);
    }

    private double scaleBar(double x, double y) {
        double length = MapFrame.roundLength(220 / frame.scale);
        double pixels = length * frame.scale;
        canvas.open("scale-bar", "");
        for (int part = 0; part < 4; part++) {
            Ink ink = part % 2 == 0 ? Palette.TEXT : Palette.FLOOR;
            canvas.rectangle(x + part * pixels / 4, y - 6, pixels / 4, 6, Style.filled(ink, 1));
        }
        canvas.rectangle(x, y - 6, pixels, 6, Style.line(Palette.TEXT, 1, 1));
        canvas.text(x, y + 16, "0", Canvas.Anchor.MIDDLE, TEXT_SIZE, Palette.TEXT);
        String unit = scene.unit().isEmpty() ? "" : " " + scene.unit();
        canvas.text(
                x + pixels,
                y + 16,
                NumberText.digits(length, GridPainter.DIGITS) + unit,
                Canvas.Anchor.MIDDLE,
                TEXT_SIZE,
                Palette.TEXT);
        canvas.close();
        return x + pixels;
    }

    private double ramp(double x, double y) {
        double width = 220;
        double step = width / Palette.RAMP;
        canvas.open("ramp", "");
        for (int k = 0; k < Palette.RAMP; k++) {
            Ink ink = Palette.distance(k / (Palette.RAMP - 1.0));
            // Slightly wider than a step, so that no gap shows between two.
            canvas.rectangle(x + k * step, y - 9, step + 0.5, 9, Style.filled(ink, 1));
        }
        double tick = MapFrame.roundLength(farthest / 2);
        for (int k = 0; k * tick <= farthest; k++) {
            double at = x + width * (k * tick) / farthest;
            canvas.line(at, y, at, y + 4, Style.line(Palette.TEXT, 1, 1));
            canvas.text(
                    at,
                    y + 16,
                    NumberText.digits(k * tick, GridPainter.DIGITS),
                    Canvas.Anchor.MIDDLE,
                    TEXT_SIZE,
                    Palette.TEXT);
        }
        canvas.text(x, y - 15, "measured distance", Canvas.Anchor.START, TEXT_SIZE, Palette.QUIET);
        canvas.close();
        return x + width;
    }

    private void marks(double left, double y) {
        canvas.open("marks", "");
        double x = left;
        if (!scene.trails().isEmpty()) {
            Ink ink = Palette.robot(0);
            canvas.polyline(
                    new double[] {x, y, x + 12, y - 9, x + 26, y - 2, x + 38, y - 8}, Style.line(ink, 1.6, 0.7));
            canvas.circle(x, y, 3.5, Style.filled(Palette.FLOOR, 1).outlined(ink, 1.6, 1));
            x = label(x + 46, y, "trail");
        }
        if (scene.things().stream().anyMatch(thing -> thing.object().isMoveable())) {
            canvas.circle(x + 8, y - 5, 8, Style.filled(Palette.robot(0), 0.92));
            double[] arrow = {x + 14, y - 5, x + 4, y - 10, x + 6, y - 5, x + 4, y};
            canvas.polygons(List.of(arrow), Style.filled(Palette.FLOOR, 0.95));
            x = label(x + 22, y, "moves; the arrow is its heading");
        }
        if (scene.marks().stream().anyMatch(mark -> mark.why() == Scene.Mark.Why.GOAL)) {
            Style ring = Style.filled(Palette.GOAL, 0.12).outlined(Palette.GOAL, 1.8, 0.9);
            canvas.circle(x + 8, y - 5, 8, ring.dashed(5));
            x = label(x + 22, y, "goal");
        }
        if (!scene.refusals().isEmpty()) {
            TracePainter.cross(canvas, x + 4, y - 5, 0);
            label(x + 22, y, stopped() + ", " + scene.refusals().size() + " shown");
        }
        canvas.close();
    }

    /** What the crosses of the scene mean. */
    private String stopped() {
        long bumps = scene.refusals().stream()
                .filter(each -> each.kind() == Scene.Refusal.Kind.BUMP)
                .count();
        return bumps == 0 ? "refused move" : bumps == scene.refusals().size() ? "bump" : "refused move or bump";
    }

    private double label(double x, double y, String text) {
        canvas.text(x, y, text, Canvas.Anchor.START, TEXT_SIZE, Palette.TEXT);
        return x + 0.58 * TEXT_SIZE * text.length() + 28;
    }
}
