package robosim.geometry.viewer.space;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.viewer.draw.Ink;
import robosim.geometry.viewer.draw.Palette;
import robosim.geometry.viewer.scene.Scene;

/** What is drawn over a picture: paths, measured distances, refused moves, and outlines of what is selected or in the way. */
final class Traces {
    /** Points of the rim of a cone. */
    private static final int RIM = 32;

    /** How far before a point its line of sight ends, as a share: most points lie on surfaces. */
    private static final double SHORT = 2e-3;

    /** The edges of a box by their corners, whose bits say which of X, Y and Z is the larger. */
    private static final int[] EDGES = {0, 1, 0, 2, 0, 4, 1, 3, 1, 5, 2, 3, 2, 6, 4, 5, 4, 6, 3, 7, 5, 7, 6, 7};

    private static final int PARTS = 8;

    private Traces() {}

    static List<Trace> of(Moment moment) {
        Scene life = moment.life();
        List<Trace> traces = new ArrayList<>();
        trails(life, traces);
        for (Scene.Ping ping : life.pings()) {
            ping(ping, life.farthest(), moment.dimension(), traces);
        }
        for (Scene.Refusal refusal : life.refusals()) {
            Point place = refusal.place();
            traces.add(Trace.of(
                    Trace.Kind.DOTS, new double[] {place.x(), place.y(), place.z()}, Palette.REFUSED, 5, 0.85));
        }
        for (Scene.Blocked blocked : life.blocked()) {
            outline(blocked.mover(), Palette.REFUSED, 2, blocked.strength(), traces);
            if (blocked.obstacle() != null) {
                outline(blocked.obstacle(), Palette.REFUSED, 2.5, blocked.strength(), traces);
            }
        }
        for (Scene.Mark mark : life.marks()) {
            Ink ink = mark.why() == Scene.Mark.Why.REFUSED ? Palette.REFUSED : Palette.TEXT;
            outline(mark.object(), ink, 1.8, 1, traces);
        }
        return traces;
    }

    private static void trails(Scene life, List<Trace> traces) {
        for (Scene.Trail trail : life.trails()) {
            double[] points = new double[3 * trail.path().size()];
            int at = 0;
            for (Point point : trail.path()) {
                points[at++] = point.x();
                points[at++] = point.y();
                points[at++] = point.z();
            }
            traces.add(Trace.of(Trace.Kind.LINE, points, ink(life, trail.name()), 1.5, 0.8));
        }
    }

    /** The colour of a moveable object. */
    private static Ink ink(Scene life, String name) {
        int number = 0;
        for (Scene.Thing thing : life.things()) {
            if (name.equals(thing.object().name())) {
                Integer colour = thing.colour();
                return colour == null ? Palette.robot(number) : new Ink(colour, colour);
            }
            number++;
        }
        return Palette.QUIET;
    }

    private static void ping(Scene.Ping ping, double farthest, Dimension dimension, List<Trace> traces) {
        boolean isEcho = Double.isFinite(ping.distance());
        double reach = isEcho ? ping.distance() : ping.range();
        if (!Double.isFinite(reach)) {
            return;
        }
        Ink ink = isEcho ? Palette.distance(farthest > 0 ? reach / farthest : 0) : Palette.QUIET;
        if (ping.width() == 0) {
            double[] line = new double[6];
            set(line, 0, ping.start());
            aim(line, 1, ping, 0, 0, reach);
            traces.add(Trace.of(Trace.Kind.LINE, line, ink, 1.2, isEcho ? 0.8 : 0.35));
            if (isEcho) {
                double[] end = {line[3], line[4], line[5]};
                traces.add(Trace.of(Trace.Kind.DOTS, end, ink, 5, 1));
            }
            return;
        }
        double[] fan = new double[3 * (RIM + 2)];
        set(fan, 0, ping.start());
        double half = ping.width() / 2;
        for (int k = 0; k <= RIM; k++) {
            if (dimension == Dimension.PLANAR) {
                aim(fan, k + 1, ping, half * (2.0 * k / RIM - 1), 0, reach);
            } else {
                aim(fan, k + 1, ping, half, 360.0 * k / RIM, reach);
            }
        }
        traces.add(Trace.of(Trace.Kind.FAN, fan, ink, 1, isEcho ? 0.3 : 0.07));
        double[] rim = new double[3 * (RIM + 1)];
        System.arraycopy(fan, 3, rim, 0, rim.length);
        traces.add(Trace.of(Trace.Kind.LINE, rim, ink, isEcho ? 2 : 1, isEcho ? 0.95 : 0.5));
    }

    /** A point at a distance, away from the middle of a beam by an angle, in a direction about the beam from its left. */
    private static void aim(double[] out, int point, Scene.Ping ping, double aside, double about, double distance) {
        double ahead = distance * Degrees.cos(aside);
        double left = distance * Degrees.sin(aside) * Degrees.cos(about);
        double up = distance * Degrees.sin(aside) * Degrees.sin(about);
        double c = Degrees.cos(ping.heading());
        double s = Degrees.sin(ping.heading());
        out[3 * point] = ping.start().x() + ahead * c - left * s;
        out[3 * point + 1] = ping.start().y() + up;
        out[3 * point + 2] = ping.start().z() - ahead * s - left * c;
    }

    private static void set(double[] out, int point, Point place) {
        out[3 * point] = place.x();
        out[3 * point + 1] = place.y();
        out[3 * point + 2] = place.z();
    }

    /** The edges of a box, or those of the bounds of anything else. */
    private static void outline(GeometryObject object, Ink ink, double width, double share, List<Trace> traces) {
        double[] corners = object instanceof BoxObject box ? corners(box) : corners(object.bounds());
        for (int k = 0; k < EDGES.length; k += 2) {
            double[] line = new double[3 * (PARTS + 1)];
            for (int part = 0; part <= PARTS; part++) {
                for (int axis = 0; axis < 3; axis++) {
                    double from = corners[3 * EDGES[k] + axis];
                    double to = corners[3 * EDGES[k + 1] + axis];
                    line[3 * part + axis] = from + (to - from) * part / PARTS;
                }
            }
            traces.add(Trace.of(Trace.Kind.LINE, line, ink, width, share));
        }
    }

    private static double[] corners(Bounds b) {
        double[] corners = new double[24];
        for (int k = 0; k < 8; k++) {
            corners[3 * k] = (k & 1) == 0 ? b.minX() : b.maxX();
            corners[3 * k + 1] = (k & 2) == 0 ? b.minY() : b.maxY();
            corners[3 * k + 2] = (k & 4) == 0 ? b.minZ() : b.maxZ();
        }
        return corners;
    }

    private static double[] corners(BoxObject box) {
        double[] r = box.rotation();
        double[] corners = new double[24];
        for (int k = 0; k < 8; k++) {
            double x = ((k & 1) - 0.5) * box.width();
            double y = ((k >> 1 & 1) - 0.5) * box.height();
            double z = ((k >> 2 & 1) - 0.5) * box.length();
            corners[3 * k] = box.center().x() + r[0] * x + r[1] * y + r[2] * z;
            corners[3 * k + 1] = box.center().y() + r[3] * x + r[4] * y + r[5] * z;
            corners[3 * k + 2] = box.center().z() + r[6] * x + r[7] * y + r[8] * z;
        }
        return corners;
    }

    /** The same traces with what is hidden from an eye, found by exact rays that end just before each point. */
    static List<Trace> hidden(List<Trace> traces, Point eye, @Nullable String carrier, Geometry world) {
        List<Trace> found = new ArrayList<>();
        for (Trace trace : traces) {
            int count = trace.size();
            double[] rays = new double[7 * count];
            for (int k = 0; k < count; k++) {
                double dx = trace.points()[3 * k] - eye.x();
                double dy = trace.points()[3 * k + 1] - eye.y();
                double dz = trace.points()[3 * k + 2] - eye.z();
                double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
                boolean isHere = !(length > 0);
                rays[7 * k] = eye.x();
                rays[7 * k + 1] = eye.y();
                rays[7 * k + 2] = eye.z();
                rays[7 * k + 3] = isHere ? 1 : dx / length;
                rays[7 * k + 4] = isHere ? 0 : dy / length;
                rays[7 * k + 5] = isHere ? 0 : dz / length;
                rays[7 * k + 6] = length * (1 - SHORT);
            }
            long[] free = new long[(count + 63) / 64];
            if (carrier == null) {
                world.freeRays(rays, count, free);
            } else {
                world.freeRays(rays, count, carrier, free);
            }
            boolean[] seen = new boolean[count];
            for (int k = 0; k < count; k++) {
                seen[k] = (free[k / 64] >> (k % 64) & 1) != 0;
            }
            found.add(trace.seen(seen));
        }
        return found;
    }
}
