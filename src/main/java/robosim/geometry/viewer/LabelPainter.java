package robosim.geometry.viewer;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.GeometryObject;

/** Names beside or upon their objects, where there is room: no label covers another. */
final class LabelPainter {
    private static final double ROBOT_SIZE = 12;
    private static final double STATIC_SIZE = 10;

    /** The mean advance of a letter in its size; the page is laid out by it, whatever the font. */
    private static final double ADVANCE = 0.6;

    private final MapFrame frame;
    private final Canvas canvas;
    private final List<double[]> taken = new ArrayList<>();

    LabelPainter(MapFrame frame, Canvas canvas) {
        this.frame = frame;
        this.canvas = canvas;
    }

    void paint(List<Scene.Thing> things) {
        canvas.open("names", "");
        for (Scene.Thing thing : things) {
            if (thing.object().isMoveable()) {
                reserve(thing.object());
            }
        }
        for (Scene.Thing thing : things) {
            if (thing.object().isMoveable()) {
                beside(thing.object());
            }
        }
        for (Scene.Thing thing : things) {
            if (!thing.object().isMoveable()) {
                upon(thing.object());
            }
        }
        canvas.close();
    }

    /** No name may cover a robot. */
    private void reserve(GeometryObject robot) {
        Bounds bounds = bounds(robot);
        double halfWidth = frame.scale * bounds.width() / 2;
        double halfHeight = frame.scale * bounds.length() / 2;
        double x = frame.x(bounds.middleX());
        double y = frame.y(bounds.middleZ());
        taken.add(new double[] {x - halfWidth, y - halfHeight, x + halfWidth, y + halfHeight});
    }

    private void beside(GeometryObject robot) {
        String name = robot.name();
        if (name == null) {
            return;
        }
        Bounds bounds = bounds(robot);
        double reach = frame.scale * Math.max(bounds.width(), bounds.length()) / 2 + 5;
        double x = frame.x(bounds.middleX());
        double y = frame.y(bounds.middleZ());
        double width = ADVANCE * ROBOT_SIZE * name.length();
        double[][] places = {
            {x + reach, y + 4}, {x - reach - width, y + 4}, {x - width / 2, y - reach}, {x - width / 2, y + reach + 10}
        };
        for (double[] place : places) {
            if (take(place[0], place[1], width, ROBOT_SIZE)) {
                canvas.text(place[0], place[1], name, Canvas.Anchor.START, ROBOT_SIZE, Palette.TEXT);
                return;
            }
        }
        canvas.text(places[0][0], places[0][1], name, Canvas.Anchor.START, ROBOT_SIZE, Palette.TEXT);
    }

    /** A static object's name stands on it, where it fits. */
    private void upon(GeometryObject object) {
        String name = object.name();
        if (name == null) {
            return;
        }
        Bounds bounds = bounds(object);
        double width = ADVANCE * STATIC_SIZE * name.length();
        boolean fits = frame.scale * bounds.width() > width + 6 && frame.scale * bounds.length() > STATIC_SIZE + 2;
        double x = frame.x(bounds.middleX());
        double y = frame.y(bounds.middleZ()) + STATIC_SIZE * 0.36;
        if (fits && take(x - width / 2, y, width, STATIC_SIZE)) {
            canvas.text(x, y, name, Canvas.Anchor.MIDDLE, STATIC_SIZE, Palette.TEXT);
        }
    }

    private boolean take(double x, double y, double width, double size) {
        double[] box = {x - 1, y - size, x + width + 1, y + 0.25 * size};
        if (box[0] < frame.left() || box[2] > frame.right() || box[1] < frame.top() || box[3] > frame.bottom()) {
            return false;
        }
        for (double[] other : taken) {
            if (box[0] < other[2] && other[0] < box[2] && box[1] < other[3] && other[1] < box[3]) {
                return false;
            }
        }
        taken.add(box);
        return true;
    }

    private static Bounds bounds(GeometryObject object) {
        Bounds bounds = new Bounds();
        Outline.of(object).forEach(bounds::add);
        return bounds;
    }
}
