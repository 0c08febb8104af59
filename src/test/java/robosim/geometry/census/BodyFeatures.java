package robosim.geometry.census;

import java.util.ArrayList;
import java.util.List;

/** The features of a body: which is furthest along a direction, and how it goes on from a point. */
final class BodyFeatures {
    private BodyFeatures() {}

    /** What of it is furthest along n: a point, a line or a face. */
    static String feature(Body body, double[] n) {
        double small = 1e-9;
        switch (body.type) {
            case BOX -> {
                int flat = 0;
                for (int k = 0; k < 3; k++) {
                    flat += Math.abs(Vec.dot(n, body.axes[k])) < small ? 1 : 0;
                }
                return List.of("corner", "edge", "face").get(flat);
            }
            case CYLINDER -> {
                double along = Math.abs(Vec.dot(n, body.axes[1]));
                return along < small ? "mantle" : Vec.length(Vec.cross(n, body.axes[1])) < small ? "cap" : "rim";
            }
            case SPHERE -> {
                return "sphere";
            }
            case CAPSULE -> {
                return Math.abs(Vec.dot(n, body.axes[1])) < small ? "side" : "end";
            }
            default -> {
                double reach = body.reach(n);
                int tops = 0;
                for (double[] corner : body.corners) {
                    tops += reach - Vec.dot(n, corner) < small * body.size() ? 1 : 0;
                }
                return List.of("", "corner", "edge", "face").get(tops);
            }
        }
    }

    /** Directions in which it goes on, both ways, from a point of its surface. */
    static List<double[]> tangents(Body body, double[] p) {
        double[] w = Vec.minus(p, body.c);
        double inner = 1 - 1e-11;
        List<double[]> out = new ArrayList<>();
        switch (body.type) {
            case BOX -> {
                for (int k = 0; k < 3; k++) {
                    if (Math.abs(Vec.dot(w, body.axes[k])) < inner * body.row[3 + k]) {
                        out.add(body.axes[k]);
                    }
                }
            }
            case CYLINDER -> {
                double t = Vec.dot(w, body.axes[1]);
                double[] aside = Vec.plus(w, -t, body.axes[1]);
                if (Math.abs(t) < inner * body.row[4]) {
                    out.add(body.axes[1]);
                }
                if (Vec.length(aside) > 0) {
                    double[] radial = Vec.unit(aside);
                    out.add(Vec.unit(Vec.cross(body.axes[1], radial)));
                    if (Vec.length(aside) < inner * body.row[3]) {
                        out.add(radial);
                    }
                }
            }
            case TRIANGLE -> {
                for (double[] edge : body.edges) {
                    double[] way = {edge[3], edge[4], edge[5]};
                    double length = Vec.length(way);
                    if (length > 0) {
                        out.add(Vec.plus(new double[3], 1 / length, way));
                    }
                }
            }
            case SPHERE, CAPSULE -> {}
        }
        return out;
    }
}
