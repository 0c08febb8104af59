package robosim.geometry.viewer.scene;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * Everything that a picture shows, in world units.
 *
 * @param title    above the picture
 * @param subtitle below the title; may be empty
 * @param unit     name of the world unit for the scale bar; may be empty
 * @param view     the part of the world that is shown
 * @param things   objects at their present places, drawn in this order, moveable ones last
 * @param trails   where moveable objects have been
 * @param pings    measured distances
 * @param refusals moves that were not made
 * @param blocked  what blocked the recent ones of them
 * @param marks    objects to highlight
 * @param farthest the minimum distance at the end of the colour ramp, so that the ramp does not change with each step;
 *     or 0
 */
public record Scene(
        String title,
        String subtitle,
        String unit,
        View view,
        List<Thing> things,
        List<Trail> trails,
        List<Ping> pings,
        List<Refusal> refusals,
        List<Blocked> blocked,
        List<Mark> marks,
        double farthest) {

    /** Copies the lists. */
    public Scene {
        Checks.present("title", title);
        Checks.present("subtitle", subtitle);
        Checks.present("unit", unit);
        Checks.present("view", view);
        things = Checks.list("things", things);
        trails = Checks.list("trails", trails);
        pings = Checks.list("pings", pings);
        refusals = Checks.list("refusals", refusals);
        blocked = Checks.list("blocked", blocked);
        marks = Checks.list("marks", marks);
    }

    /** The scene of a world with its objects. */
    public static Scene of(String title, View view, List<Thing> things) {
        return new Scene(title, "", "", view, things, List.of(), List.of(), List.of(), List.of(), List.of(), 0);
    }

    /** This scene with a line below its title and with the name of its unit. */
    public Scene described(String newSubtitle, String newUnit) {
        return new Scene(title, newSubtitle, newUnit, view, things, trails, pings, refusals, blocked, marks, farthest);
    }

    /** This scene under another title. */
    public Scene titled(String newTitle) {
        return new Scene(newTitle, subtitle, unit, view, things, trails, pings, refusals, blocked, marks, farthest);
    }

    /** This scene with another part of its world. */
    public Scene viewed(View newView) {
        return new Scene(title, subtitle, unit, newView, things, trails, pings, refusals, blocked, marks, farthest);
    }

    /** This scene with other objects. */
    public Scene showing(List<Thing> newThings) {
        return new Scene(title, subtitle, unit, view, newThings, trails, pings, refusals, blocked, marks, farthest);
    }

    /** This scene with what happened in it. */
    public Scene with(List<Trail> newTrails, List<Ping> newPings, List<Refusal> newRefusals) {
        return new Scene(
                title, subtitle, unit, view, things, newTrails, newPings, newRefusals, blocked, marks, farthest);
    }

    /** This scene with what blocked its recent moves. */
    public Scene blocked(List<Blocked> newBlocked) {
        return new Scene(title, subtitle, unit, view, things, trails, pings, refusals, newBlocked, marks, farthest);
    }

    /** This scene with highlighted objects, and with a minimum for the end of the colour ramp. */
    public Scene marked(List<Mark> newMarks, double newFarthest) {
        return new Scene(title, subtitle, unit, view, things, trails, pings, refusals, blocked, newMarks, newFarthest);
    }

    /**
     * A rectangle of the XZ plane; closed, and larger than a point.
     *
     * @param bordered whether its edge is that of the world
     */
    public record View(double minX, double minZ, double maxX, double maxZ, boolean bordered) {
        /** Refuses a rectangle without an area. */
        public View {
            if (!(maxX > minX) || !(maxZ > minZ) || !Double.isFinite(maxX - minX) || !Double.isFinite(maxZ - minZ)) {
                throw new IllegalArgumentException("view must have a finite area (got: x " + minX + " to " + maxX
                        + ", z " + minZ + " to " + maxZ + ")");
            }
        }

        /** A whole world of that width and length, centred at the origin. */
        public static View world(double width, double length) {
            return new View(-width / 2, -length / 2, width / 2, length / 2, true);
        }

        /** A whole world; if its objects fill less than a quarter of it, only the area around them. */
        public static View of(double width, double length, List<Thing> things) {
            View around = around(things.stream().map(Thing::object).toList());
            double across = around.maxX() - around.minX();
            double down = around.maxZ() - around.minZ();
            boolean whole = things.isEmpty() || across * down * 4 >= width * length;
            return whole ? world(width, length) : around;
        }

        /** This area, extended to include an object. */
        public View with(GeometryObject object) {
            Bounds b = object.bounds();
            boolean isWithin = minX <= b.minX() && minZ <= b.minZ() && b.maxX() <= maxX && b.maxZ() <= maxZ;
            return isWithin ? this : around(b.and(bounds()));
        }

        /** What holds every object, and a margin around them; a unit square where there is none. */
        public static View around(List<GeometryObject> objects) {
            return objects.stream()
                    .map(GeometryObject::bounds)
                    .reduce(Bounds::and)
                    .map(View::around)
                    .orElse(new View(-0.5, -0.5, 0.5, 0.5, false));
        }

        /** Bounds as seen from above, and a margin of a twentieth around them. */
        public static View around(Bounds bounds) {
            double size = Math.max(bounds.width(), bounds.length());
            double margin = size > 0 ? size / 20 : 0.5;
            return new View(
                    bounds.minX() - margin,
                    bounds.minZ() - margin,
                    bounds.maxX() + margin,
                    bounds.maxZ() + margin,
                    false);
        }

        /** This rectangle, without a height. */
        public Bounds bounds() {
            return new Bounds(minX, 0, minZ, maxX, 0, maxZ);
        }
    }

    /**
     * An object.
     *
     * @param colour 0xRRGGBB; null for a colour by its kind
     */
    public record Thing(GeometryObject object, @Nullable Integer colour) {
        /** Refuses null for an object. */
        public Thing {
            Checks.present("object", object);
        }
    }

    /**
     * Where a moveable object has been.
     *
     * @param name name of the object
     * @param path its places, in order; at least one
     */
    public record Trail(String name, List<Point> path) {
        /** Copies the path. */
        public Trail {
            path = List.copyOf(path);
            if (path.isEmpty()) {
                throw new IllegalArgumentException("path must hold at least one place (got: none)");
            }
        }
    }

    /**
     * A measured distance.
     *
     * @param start    position of the sensor
     * @param heading  degrees about the vertical from the world's X to the middle of the beam
     * @param width    full opening angle in degrees, from 0 (a line) up to, not including, 180
     * @param range    the largest distance that can be measured; may be infinite
     * @param distance the measured distance; infinite if nothing echoed
     */
    public record Ping(Point start, double heading, double width, double range, double distance) {}

    /**
     * A move that was not made, or a driven robot that ran into something.
     *
     * @param place   where the object stayed
     * @param heading direction of what is in the way, degrees about the vertical from the world's X
     */
    public record Refusal(Point place, double heading, Kind kind) {
        /** What happened. */
        public enum Kind {
            /** A move was asked for and not made. */
            MOVE,
            /** A body ran into something while it was driven. */
            BUMP
        }

        /** A refused move. */
        public Refusal(Point place, double heading) {
            this(place, heading, Kind.MOVE);
        }
    }

    /**
     * What blocked a recent move.
     *
     * @param mover    the object, where it stayed
     * @param obstacle what blocked it; null for the world's bounds
     * @param strength strength of the mark, from 0 to 1; stronger for more recent moves
     * @param aim      the object where the move would have led; null if it is not shown
     * @param contact  where the two would have touched first; null if unknown
     */
    public record Blocked(
            GeometryObject mover,
            @Nullable GeometryObject obstacle,
            double strength,
            @Nullable GeometryObject aim,
            @Nullable Point contact) {
        /** Refuses an invalid strength. */
        public Blocked {
            if (!(strength >= 0 && strength <= 1)) {
                throw new IllegalArgumentException("strength must be 0 to 1 (got: " + strength + ")");
            }
        }

        /** What blocked a move whose way is not shown. */
        public Blocked(GeometryObject mover, @Nullable GeometryObject obstacle, double strength) {
            this(mover, obstacle, strength, null, null);
        }
    }

    /** A highlighted object. */
    public record Mark(GeometryObject object, Why why) {
        /** Why it is highlighted. */
        public enum Why {
            /** It is selected. */
            PICKED,
            /** It must not be placed there. */
            REFUSED,
            /** It is a goal. */
            GOAL
        }
    }
}
