package robosim.geometry.viewer.draw;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.viewer.scene.CellArea;
import robosim.geometry.viewer.scene.Footprint;
import robosim.geometry.viewer.scene.Layers;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.scene.Scene;

/** Paints objects: the area that they cover, and for moveable ones the forward direction. */
final class ThingPainter {
    /** Width in pixels of the light edge around moveable objects. */
    private static final double HALO = 1;

    /** Radius in pixels of the smallest visible dot. */
    private static final double DOT = 2.5;

    /** The smallest length in pixels of an arrow drawn on an object. */
    private static final double LEAST_ARROW = 4;

    /** The length in pixels of an arrow on the floor. */
    static final double SMALL_ARROW = 8;

    /** How much of the floor's colour the lowest parts of meshes have. */
    private static final double PALEST = 0.75;

    /** Width in pixels of the line in its own colour that closes the seams between triangles. */
    private static final double SEAM = 0.5;

    /** Width in pixels of the edges of meshes. */
    private static final double MESH_LINE = 0.7;

    private ThingPainter() {}

    /** Begins the part of the picture that shows an object. */
    static void open(String role, GeometryObject object, Canvas canvas) {
        canvas.open(role + " " + object.kind().word(), text(object));
    }

    /** Paints what stands still. Of a mesh, higher parts are stronger in colour, and only its edges are drawn. */
    static void paint(Layers.Layer layer, MapFrame frame, Canvas canvas) {
        GeometryObject object = layer.thing().object();
        Integer colour = layer.thing().colour();
        Ink ink = colour == null ? Palette.of(object.kind()) : new Ink(colour, Shade.dimmed(colour));
        Ink edge = new Ink(Shade.mix(ink.light(), 0x000000, 0.38), Shade.mix(ink.dark(), 0xffffff, 0.35));
        if (layer.isMesh()) {
            Ink shaded = Shade.faded(ink, PALEST * (1 - layer.height()));
            canvas.polygons(
                    onPage(layer.areas(), frame), Style.filled(shaded, 1).outlined(shaded, SEAM, 1));
            if (!layer.lines().isEmpty()) {
                List<double[]> lines = layer.lines().stream().map(frame::toPage).toList();
                canvas.polygons(lines, Style.line(edge, MESH_LINE, 0.9));
            }
        } else {
            draw(layer.areas(), Style.filled(ink, 1).outlined(edge, 1, 0.9), frame, canvas);
        }
    }

    private static List<double[]> onPage(List<Footprint> triangles, MapFrame frame) {
        List<double[]> page = new ArrayList<>();
        for (Footprint triangle : triangles) {
            page.add(frame.toPage(((Footprint.Polygon) triangle).corners()));
        }
        return page;
    }

    static void paintMoveable(Scene.Thing thing, Ink ink, MapFrame frame, Canvas canvas) {
        GeometryObject object = thing.object();
        List<Footprint> outlines = Footprint.of(object);
        open("moveable", object, canvas);
        // The light edge lies below the colour, so it cannot hide even a small object.
        draw(outlines, Style.line(Palette.FLOOR, 2 * HALO, 1), frame, canvas);
        draw(outlines, Style.filled(ink, 0.92), frame, canvas);
        Bounds bounds = object.bounds();
        if (frame.scale * Math.max(bounds.width(), bounds.length()) < 2 * DOT) {
            double x = frame.x(bounds.middleX());
            double y = frame.y(bounds.middleZ());
            canvas.circle(x, y, DOT, Style.filled(ink, 0.92));
        }
        paintHeading(object, outlines, ink, frame, canvas);
        canvas.close();
    }

    /**
     * Paints an arrow at the object's own centre: light, on the part there and no larger than it, if there is room;
     * else a small one in the object's colour, visible on the floor.
     */
    private static void paintHeading(
            GeometryObject object, List<Footprint> outlines, Ink ink, MapFrame frame, Canvas canvas) {
        double[] rotation = object.rotation();
        // Forward is the object's own X; if it points straight up there is no arrow.
        double fx = rotation[0];
        double fz = rotation[6];
        double length = Math.sqrt(fx * fx + fz * fz);
        if (!(length > 1e-9)) {
            return;
        }
        double depth = 0;
        for (Footprint outline : outlines) {
            depth = Math.max(
                    depth,
                    Footprint.depth(
                            outline, object.center().x(), object.center().z()));
        }
        double room = 0.72 * frame.scale * depth;
        double x = frame.x(object.center());
        double y = frame.y(object.center());
        if (room >= LEAST_ARROW) {
            canvas.polygons(
                    List.of(arrow(x, y, fx / length * room, fz / length * room)), Style.filled(Palette.FLOOR, 0.95));
            return;
        }
        // Next to a small part, so as not to cover it; at the centre if there is no part.
        double away = depth > 0 ? frame.scale * depth + SMALL_ARROW + 1 : 0;
        double[] small = arrow(
                x + fx / length * away, y + fz / length * away, fx / length * SMALL_ARROW, fz / length * SMALL_ARROW);
        canvas.polygons(List.of(small), Style.filled(ink, 0.92));
    }

    /** An arrow head at a point of the page, with the given extent along each axis. */
    private static double[] arrow(double x, double y, double ux, double uz) {
        return new double[] {
            x + ux,
            y + uz,
            x - 0.7 * ux - 0.6 * uz,
            y - 0.7 * uz + 0.6 * ux,
            x - 0.35 * ux,
            y - 0.35 * uz,
            x - 0.7 * ux + 0.6 * uz,
            y - 0.7 * uz - 0.6 * ux
        };
    }

    static void draw(GeometryObject object, Style style, MapFrame frame, Canvas canvas) {
        draw(Footprint.of(object), style, frame, canvas);
    }

    private static void draw(List<Footprint> outlines, Style style, MapFrame frame, Canvas canvas) {
        List<double[]> polygons = new ArrayList<>();
        for (Footprint outline : outlines) {
            if (outline instanceof Footprint.Disc disc) {
                // At least as large as the smallest visible dot.
                double radius = Math.max(1.2, disc.radius() * frame.scale);
                canvas.circle(frame.x(disc.x()), frame.y(disc.z()), radius, style);
            } else if (outline instanceof Footprint.Polygon polygon) {
                polygons.add(frame.toPage(polygon.corners()));
            } else if (outline instanceof CellArea cells) {
                draw(cells, style, frame, canvas);
            }
        }
        if (!polygons.isEmpty()) {
            boolean many = polygons.size() > 8;
            Style drawn = many ? new Style(style.fill(), style.fillOpacity(), style.stroke(), 0.5, 0.5, 0) : style;
            canvas.polygons(polygons, drawn);
        }
    }

    /** Cells are filled and have no outlines of their own; where nothing is filled, the whole grid has one. */
    private static void draw(CellArea cells, Style style, MapFrame frame, Canvas canvas) {
        if (style.fill() == null) {
            canvas.polygons(List.of(cells.outline(frame)), style);
        } else {
            fill(cells.onPage(frame, null), style, canvas);
        }
    }

    private static void fill(List<double[]> polygons, Style style, Canvas canvas) {
        if (!polygons.isEmpty()) {
            canvas.polygons(polygons, new Style(style.fill(), style.fillOpacity(), null, 0, 0, 0));
        }
    }

    /** Draws an object, but of a grid only the cells near another object. */
    static void drawNear(GeometryObject object, GeometryObject other, Style style, MapFrame frame, Canvas canvas) {
        if (!(object instanceof GridObject)) {
            draw(object, style, frame, canvas);
            return;
        }
        Bounds b = other.bounds();
        double more = Math.max(b.width(), b.length());
        Bounds around =
                new Bounds(b.minX() - more, b.minY(), b.minZ() - more, b.maxX() + more, b.maxY(), b.maxZ() + more);
        for (Footprint outline : Footprint.of(object)) {
            fill(((CellArea) outline).onPage(frame, around), style, canvas);
        }
    }

    private static String text(GeometryObject object) {
        String name = object.name();
        return name == null ? "" : name;
    }

    /** Mixes colours, for edges and for dark backgrounds. */
    static final class Shade {
        private Shade() {}

        /** Mixes a fraction of one colour with another. */
        static int mix(int rgb, int other, double share) {
            int mixed = 0;
            for (int shift = 16; shift >= 0; shift -= 8) {
                int a = rgb >> shift & 0xff;
                int b = other >> shift & 0xff;
                mixed |= (int) Math.round(a + share * (b - a)) << shift;
            }
            return mixed;
        }

        /** A colour with a part of the floor's. */
        static Ink faded(Ink ink, double share) {
            return new Ink(
                    mix(ink.light(), Palette.FLOOR.light(), share), mix(ink.dark(), Palette.FLOOR.dark(), share));
        }

        static int dimmed(int rgb) {
            return mix(rgb, Palette.FLOOR.dark(), 0.3);
        }
    }
}
