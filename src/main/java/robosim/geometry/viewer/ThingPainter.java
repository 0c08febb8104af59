package robosim.geometry.viewer;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.GeometryObject;

/** Objects: what they cover of the floor, and for those that move where forward is. */
final class ThingPainter {
    private ThingPainter() {}

    static void paintStatic(Scene.Thing thing, MapFrame frame, Canvas canvas) {
        GeometryObject object = thing.object();
        Integer colour = thing.colour();
        Ink ink = colour == null ? Palette.of(object.kind()) : new Ink(colour, Shade.dimmed(colour));
        Ink edge = new Ink(Shade.mix(ink.light(), 0x000000, 0.38), Shade.mix(ink.dark(), 0xffffff, 0.35));
        canvas.open("object " + role(object), text(object));
        draw(object, Style.filled(ink, 1).outlined(edge, 1, 0.9), frame, canvas);
        canvas.close();
    }

    static void paintMoveable(Scene.Thing thing, Ink ink, MapFrame frame, Canvas canvas) {
        GeometryObject object = thing.object();
        canvas.open("robot " + role(object), text(object));
        draw(object, Style.filled(ink, 0.92).outlined(Palette.FLOOR, 1.5, 1), frame, canvas);
        Bounds bounds = new Bounds();
        Outline.of(object).forEach(bounds::add);
        double reach = Math.max(5, frame.scale * Math.min(bounds.width(), bounds.length()) / 2 * 0.72);
        double[] rotation = object.rotation();
        // Forward is the own X; a robot that looks straight up shows no arrow.
        double fx = rotation[0];
        double fz = rotation[6];
        double length = Math.sqrt(fx * fx + fz * fz);
        if (length > 1e-9) {
            double ux = fx / length * reach;
            double uz = fz / length * reach;
            double x = frame.x(object.center());
            double y = frame.y(object.center());
            double[] arrow = {
                x + ux,
                y + uz,
                x - 0.7 * ux - 0.6 * uz,
                y - 0.7 * uz + 0.6 * ux,
                x - 0.35 * ux,
                y - 0.35 * uz,
                x - 0.7 * ux + 0.6 * uz,
                y - 0.7 * uz - 0.6 * ux
            };
            canvas.polygons(List.of(arrow), Style.filled(Palette.FLOOR, 0.95));
        }
        canvas.close();
    }

    static void draw(GeometryObject object, Style style, MapFrame frame, Canvas canvas) {
        List<double[]> polygons = new ArrayList<>();
        for (Outline outline : Outline.of(object)) {
            if (outline instanceof Outline.Disc disc) {
                // No smaller than a dot that can be seen.
                double radius = Math.max(1.2, disc.radius() * frame.scale);
                canvas.circle(frame.x(disc.x()), frame.y(disc.z()), radius, style);
            } else if (outline instanceof Outline.Polygon polygon) {
                polygons.add(frame.toPage(polygon.corners()));
            }
        }
        if (!polygons.isEmpty()) {
            boolean many = polygons.size() > 8;
            Style drawn = many ? new Style(style.fill(), style.fillOpacity(), style.stroke(), 0.5, 0.5, 0) : style;
            canvas.polygons(polygons, drawn);
        }
    }

    private static String role(GeometryObject object) {
        return switch (object.kind()) {
            case BOX -> "box";
            case CYLINDER -> "cylinder";
            case SPHERE -> "sphere";
            case MESH -> "mesh";
            case GROUP -> "group";
        };
    }

    private static String text(GeometryObject object) {
        String name = object.name();
        return name == null ? "" : name;
    }

    /** Mixtures of colours, for edges and for dark paper. */
    static final class Shade {
        private Shade() {}

        /** A share of one colour and the rest of another. */
        static int mix(int rgb, int other, double share) {
            int mixed = 0;
            for (int shift = 16; shift >= 0; shift -= 8) {
                int a = rgb >> shift & 0xff;
                int b = other >> shift & 0xff;
                mixed |= (int) Math.round(a + share * (b - a)) << shift;
            }
            return mixed;
        }

        static int dimmed(int rgb) {
            return mix(rgb, Palette.FLOOR.dark(), 0.3);
        }
    }
}
