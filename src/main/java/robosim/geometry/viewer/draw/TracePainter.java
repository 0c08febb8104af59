package robosim.geometry.viewer.draw;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.shared.ObjectNames;

/** Paints what happened: trails, measured distances, refused moves. */
final class TracePainter {
    private final Scene scene;
    private final MapFrame frame;
    private final Canvas canvas;
    private final double farthest;

    TracePainter(Scene scene, MapFrame frame, Canvas canvas, double farthest) {
        this.scene = scene;
        this.frame = frame;
        this.canvas = canvas;
        this.farthest = farthest;
    }

    void trails(Map<String, Ink> robots) {
        canvas.open("trails", "");
        for (Scene.Trail trail : scene.trails()) {
            Ink ink = robots.getOrDefault(trail.name(), Palette.QUIET);
            List<Point> path = trail.path();
            canvas.open("trail", trail.name());
            canvas.polyline(thinned(path), Style.line(ink, 1.5, 0.7));
            Point first = path.get(0);
            canvas.circle(
                    frame.x(first),
                    frame.y(first),
                    3.5,
                    Style.filled(Palette.FLOOR, 1).outlined(ink, 1.6, 1));
            canvas.close();
        }
        canvas.close();
    }

    /** A path on the page without points that are less than half a pixel from the previous one. */
    private double[] thinned(List<Point> path) {
        double[] page = new double[2 * path.size()];
        int size = 0;
        for (int k = 0; k < path.size(); k++) {
            double x = frame.x(path.get(k));
            double y = frame.y(path.get(k));
            boolean last = k == path.size() - 1;
            if (size == 0 || last || StrictMath.hypot(x - page[size - 2], y - page[size - 1]) >= 0.5) {
                page[size++] = x;
                page[size++] = y;
            }
        }
        return Arrays.copyOf(page, size);
    }

    void pings() {
        canvas.open("pings", "");
        for (Scene.Ping ping : scene.pings()) {
            double x = frame.x(ping.start());
            double y = frame.y(ping.start());
            boolean echo = Double.isFinite(ping.distance());
            if (!echo && !Double.isFinite(ping.range())) {
                continue;
            }
            double radius = frame.scale * (echo ? ping.distance() : ping.range());
            Ink ink = echo ? Palette.distance(farthest > 0 ? ping.distance() / farthest : 0) : Palette.QUIET;
            if (ping.width() > 0) {
                cone(ping, x, y, radius, ink, echo);
            } else {
                ray(ping, x, y, radius, ink, echo);
            }
        }
        canvas.close();
    }

    private void cone(Scene.Ping ping, double x, double y, double radius, Ink ink, boolean echo) {
        double from = ping.heading() - ping.width() / 2;
        Style inside = Style.filled(ink, echo ? 0.34 : 0.06);
        canvas.open(echo ? "ping" : "silence", "");
        canvas.sector(x, y, radius, from, ping.width(), inside);
        Style rim = Style.line(ink, echo ? 2.4 : 0.8, echo ? 0.95 : 0.6);
        canvas.arc(x, y, radius, from, ping.width(), echo ? rim : rim.dashed(4));
        canvas.close();
    }

    private void ray(Scene.Ping ping, double x, double y, double radius, Ink ink, boolean echo) {
        double angle = StrictMath.toRadians(ping.heading());
        double endX = x + radius * StrictMath.cos(angle);
        double endY = y - radius * StrictMath.sin(angle);
        canvas.open(echo ? "ping" : "silence", "");
        Style line = Style.line(ink, echo ? 1.2 : 0.8, echo ? 0.8 : 0.6);
        canvas.line(x, y, endX, endY, echo ? line : line.dashed(4));
        if (echo) {
            canvas.circle(endX, endY, 2.4, Style.filled(ink, 1));
        }
        canvas.close();
    }

    /** Paints what blocked recent moves, and the objects that were blocked. */
    void blocked() {
        canvas.open("blocked", "");
        for (Scene.Blocked each : scene.blocked()) {
            GeometryObject obstacle = each.obstacle();
            canvas.open("block", ObjectNames.of(each.mover()));
            Style style = Style.filled(Palette.REFUSED, 0.35 * each.strength())
                    .outlined(Palette.REFUSED, 2.5, each.strength());
            if (obstacle == null) {
                canvas.rectangle(
                        frame.left(),
                        frame.top(),
                        frame.right() - frame.left(),
                        frame.bottom() - frame.top(),
                        Style.line(Palette.REFUSED, 6, each.strength()));
            } else {
                ThingPainter.drawNear(obstacle, each.mover(), style, frame, canvas);
            }
            Bounds bounds = each.mover().bounds();
            double radius = frame.scale * StrictMath.hypot(bounds.width(), bounds.length()) / 2 + 4;
            canvas.circle(
                    frame.x(bounds.middleX()),
                    frame.y(bounds.middleZ()),
                    radius,
                    Style.line(Palette.REFUSED, 2, each.strength()));
            way(each);
            canvas.close();
        }
        canvas.close();
    }

    /** Paints where a refused move would have led, the way there, and where it would have touched first. */
    private void way(Scene.Blocked blocked) {
        GeometryObject aim = blocked.aim();
        if (aim != null) {
            canvas.open("attempt", ObjectNames.of(aim));
            Style ghost = Style.filled(Palette.REFUSED, 0.06 * blocked.strength())
                    .outlined(Palette.REFUSED, 1.2, 0.8 * blocked.strength())
                    .dashed(4);
            ThingPainter.draw(aim, ghost, frame, canvas);
            Style line =
                    Style.line(Palette.REFUSED, 1.2, 0.8 * blocked.strength()).dashed(4);
            Point from = blocked.mover().center();
            canvas.line(frame.x(from), frame.y(from), frame.x(aim.center()), frame.y(aim.center()), line);
            canvas.close();
        }
        Point contact = blocked.contact();
        if (contact != null) {
            canvas.open("contact", "");
            Style dot = Style.filled(Palette.REFUSED, blocked.strength()).outlined(Palette.FLOOR, 1, 1);
            canvas.circle(frame.x(contact), frame.y(contact), 3.5, dot);
            canvas.close();
        }
    }

    /** Paints the highlighted objects. */
    void marks() {
        canvas.open("marks-on-objects", "");
        for (Scene.Mark mark : scene.marks()) {
            canvas.open(role(mark), ObjectNames.of(mark.object()));
            Style style = switch (mark.why()) {
                case PICKED -> Style.line(Palette.PICKED, 2.5, 1);
                case REFUSED -> dashed(Palette.REFUSED);
                case GOAL -> dashed(Palette.GOAL);
            };
            ThingPainter.draw(mark.object(), style, frame, canvas);
            if (mark.why() == Scene.Mark.Why.GOAL) {
                middle(mark.object());
            }
            canvas.close();
        }
        canvas.close();
    }

    private static String role(Scene.Mark mark) {
        return mark.why().name().toLowerCase(Locale.ROOT);
    }

    private static Style dashed(Ink ink) {
        return Style.filled(ink, 0.12).outlined(ink, 1.8, 0.9).dashed(5);
    }

    /** Paints the centre of a goal, which may itself be too small to see. */
    private void middle(GeometryObject goal) {
        Bounds bounds = goal.bounds();
        double x = frame.x(bounds.middleX());
        double y = frame.y(bounds.middleZ());
        Style style = Style.line(Palette.GOAL, 1.8, 1);
        canvas.line(x - 6, y, x + 6, y, style);
        canvas.line(x, y - 6, x, y + 6, style);
    }

    void refusals() {
        canvas.open("refusals", "");
        Set<List<Long>> drawn = new HashSet<>();
        for (Scene.Refusal refusal : scene.refusals()) {
            double x = frame.x(refusal.place());
            double y = frame.y(refusal.place());
            // A robot that is stuck tries repeatedly; one mark is enough.
            if (drawn.add(List.of(Math.round(x), Math.round(y), Math.round(refusal.heading() / 10)))) {
                cross(canvas, x, y, refusal.heading());
            }
        }
        canvas.close();
    }

    /** Paints a cross where the object stayed, and a tick in the direction of the refused move. */
    static void cross(Canvas canvas, double x, double y, double heading) {
        double angle = StrictMath.toRadians(heading);
        double ux = StrictMath.cos(angle);
        double uy = -StrictMath.sin(angle);
        Style style = Style.line(Palette.REFUSED, 1.5, 0.85);
        double arm = 3;
        canvas.open("refusal", "");
        canvas.line(x - arm, y - arm, x + arm, y + arm, style);
        canvas.line(x - arm, y + arm, x + arm, y - arm, style);
        canvas.line(x + 4 * ux, y + 4 * uy, x + 11 * ux, y + 11 * uy, style);
        canvas.close();
    }
}
