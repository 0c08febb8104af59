package robosim.geometry.viewer.draw;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.check.NumberText;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.world.shared.ObjectNames;

/**
 * The description of one object.
 *
 * @param heading the object's name
 * @param lines   the other lines
 */
public record Card(String heading, List<String> lines) {
    private static final double MARGIN = 12;
    private static final double LINE = 17;
    private static final double HEADING_SIZE = 14;
    private static final double SIZE = 12;

    /** Name, kind, place, heading and size. */
    public static Card of(GeometryObject object, String unit) {
        List<String> lines = new ArrayList<>();
        lines.add(object.kind().word() + (object.isMoveable() ? ", can move" : ", cannot move"));
        String suffix = unit.isEmpty() ? "" : " " + unit;
        lines.add("at x " + number(object.center().x()) + ", z "
                + number(object.center().z()) + ", y "
                + number(object.center().y()) + suffix);
        lines.add(
                object.pose().isUpright()
                        ? "heading " + number(object.heading()) + " degrees"
                        : "tipped; heading " + number(object.heading()) + " degrees");
        lines.add(size(object) + suffix);
        String name = object.name();
        return new Card(name == null ? "(no name)" : ObjectNames.of(object), lines);
    }

    private static String size(GeometryObject object) {
        if (object instanceof MeshObject mesh) {
            return mesh.triangles().size() + " triangles, " + covers(object);
        }
        if (object instanceof GridObject grid) {
            return grid.columns() + " by " + grid.rows() + " cells of " + number(grid.cell()) + ", height "
                    + number(grid.height());
        }
        if (object instanceof ObjectGroup group) {
            return group.members().size() + " members, " + covers(object);
        }
        List<String> words = new ArrayList<>();
        List<String> names = object.kind().sizes();
        double[] sizes = object.sizes();
        for (int k = 0; k < sizes.length; k++) {
            int place = names.get(k).equals("length") ? words.size() - 1 : words.size(); // the height comes last
            words.add(place, names.get(k) + " " + number(sizes[k]));
        }
        return String.join(", ", words);
    }

    /** To a thousandth. */
    private static String number(double value) {
        return NumberText.places(value, 3);
    }

    private static String covers(GeometryObject object) {
        Bounds bounds = object.bounds();
        return number(bounds.width()) + " by " + number(bounds.length());
    }

    /** Paints the card in the upper right corner of a map. */
    public void paint(MapFrame frame, Canvas canvas) {
        double widest = StrokeFont.width(heading, HEADING_SIZE);
        for (String line : lines) {
            widest = Math.max(widest, StrokeFont.width(line, SIZE));
        }
        double width = widest + 2 * MARGIN;
        double height = MARGIN * 1.6 + LINE * (lines.size() + 1);
        double x = frame.right() - width - MARGIN;
        double y = frame.top() + MARGIN;
        canvas.open("card", heading);
        canvas.rectangle(x, y, width, height, Style.filled(Palette.FLOOR, 0.94).outlined(Palette.BORDER, 1, 0.7));
        double at = y + MARGIN + HEADING_SIZE - 2;
        canvas.text(x + MARGIN, at, heading, Canvas.Anchor.START, HEADING_SIZE, Palette.TEXT);
        for (String line : lines) {
            at += LINE;
            canvas.text(x + MARGIN, at, line, Canvas.Anchor.START, SIZE, Palette.QUIET);
        }
        canvas.close();
    }
}
