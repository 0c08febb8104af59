package robosim.geometry.viewer.draw;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.viewer.scene.Footprint;
import robosim.geometry.viewer.scene.Layers;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.scene.Scene;

/** Paints names next to or on their objects where there is room; no label covers another. */
final class LabelPainter {
    private static final double ROBOT_SIZE = 12;
    private static final double STATIC_SIZE = 10;

    /** The mean width of a letter as a fraction of the font size, used for layout with any font. */
    private static final double ADVANCE = 0.6;

    /** Number of points along a name that are tested for being covered. */
    private static final int SAMPLES = 5;

    private final MapFrame frame;
    private final Canvas canvas;
    private final List<double[]> taken = new ArrayList<>();

    LabelPainter(MapFrame frame, Canvas canvas) {
        this.frame = frame;
        this.canvas = canvas;
    }

    /**
     * Paints names.
     *
     * @param movers moveable objects
     * @param layers static objects, from below
     */
    void paint(List<Scene.Thing> movers, List<Layers.Layer> layers) {
        canvas.open("names", "");
        for (Scene.Thing thing : movers) {
            reserve(thing.object());
        }
        for (Scene.Thing thing : movers) {
            beside(thing.object());
        }
        // Topmost first: objects under it get no name there.
        List<Cover> above = new ArrayList<>();
        Set<GeometryObject> named = Collections.newSetFromMap(new IdentityHashMap<>());
        for (int k = layers.size() - 1; k >= 0; k--) {
            GeometryObject object = layers.get(k).thing().object();
            if (named.add(object)) {
                upon(object, above);
            }
            above.add(Cover.of(layers.get(k)));
        }
        canvas.close();
    }

    /** Reserves the area of a robot, which no name may cover. */
    private void reserve(GeometryObject robot) {
        Bounds bounds = robot.bounds();
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
        Bounds bounds = robot.bounds();
        double half = frame.scale * Math.max(bounds.width(), bounds.length()) / 2;
        // A small robot's arrow is next to it.
        double reach = (half < ThingPainter.SMALL_ARROW ? half + 2 * ThingPainter.SMALL_ARROW : half) + 5;
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

    /** An object that lies over those still to be labelled. */
    private record Cover(List<Footprint> outlines, Bounds bounds) {
        static Cover of(Layers.Layer layer) {
            return new Cover(layer.areas(), layer.bounds());
        }

        boolean isApart(double fromX, double fromZ, double toX, double toZ) {
            return toX < bounds.minX() || bounds.maxX() < fromX || toZ < bounds.minZ() || bounds.maxZ() < fromZ;
        }
    }

    /** Paints a static object's name on it if it fits and is not covered. */
    private void upon(GeometryObject object, List<Cover> above) {
        Bounds bounds = object.bounds();
        String name = object.name();
        // The middle of a grid is as a rule free floor.
        if (name != null && object.kind() != GeometryObject.Kind.GRID && !upon(name, bounds, above)) {
            // Of an imported object the model's name, which tells more than that of its link.
            int model = name.indexOf("::");
            if (model > 0) {
                upon(name.substring(0, model), bounds, above);
            }
        }
    }

    private boolean upon(String name, Bounds bounds, List<Cover> above) {
        double width = ADVANCE * STATIC_SIZE * name.length();
        boolean fits = frame.scale * bounds.width() > width + 6 && frame.scale * bounds.length() > STATIC_SIZE + 2;
        double x = frame.x(bounds.middleX());
        double y = frame.y(bounds.middleZ()) + STATIC_SIZE * 0.36;
        if (fits && !isCovered(x - width / 2, y, width, above) && take(x - width / 2, y, width, STATIC_SIZE)) {
            canvas.text(x, y, name, Canvas.Anchor.MIDDLE, STATIC_SIZE, Palette.TEXT);
            return true;
        }
        return false;
    }

    private boolean isCovered(double x, double y, double width, List<Cover> above) {
        double fromX = frame.worldX(x);
        double toX = frame.worldX(x + width);
        double fromZ = frame.worldZ(y - STATIC_SIZE);
        double toZ = frame.worldZ(y);
        for (Cover cover : above) {
            if (cover.isApart(fromX, fromZ, toX, toZ)) {
                continue;
            }
            for (int k = 0; k < 2 * SAMPLES; k++) {
                int column = k / 2;
                double at = fromX + (toX - fromX) * column / (SAMPLES - 1.0);
                double z = k % 2 == 0 ? fromZ : toZ;
                for (Footprint outline : cover.outlines) {
                    if (Footprint.depth(outline, at, z) >= 0) {
                        return true;
                    }
                }
            }
        }
        return false;
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
}
