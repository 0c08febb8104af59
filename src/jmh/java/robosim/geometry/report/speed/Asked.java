package robosim.geometry.report.speed;

import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Ray;

/** The questions of this module as batches: each loop is its own code, as in a user's program. */
final class Asked {
    private Asked() {}

    static InTurn.Batch rays(Geometry geometry, Ray[] rays, double range, Accuracy level) {
        return (from, count) -> {
            double sum = 0;
            for (int k = from; k < from + count; k++) {
                sum += Math.min(range, geometry.getRayDistance(rays[k], 0, range, 0, level));
            }
            return sum;
        };
    }

    static InTurn.Batch cones(Geometry geometry, Ray[] rays, double range, double degrees, Accuracy level) {
        return (from, count) -> {
            double sum = 0;
            for (int k = from; k < from + count; k++) {
                sum += Math.min(range, geometry.getRayDistance(rays[k], 0, range, degrees, level));
            }
            return sum;
        };
    }

    static InTurn.Batch probes(Geometry geometry, GeometryObject[] probes, Accuracy level) {
        return (from, count) -> {
            int hits = 0;
            for (int k = from; k < from + count; k++) {
                hits += geometry.testObject(probes[k], level) ? 1 : 0;
            }
            return hits;
        };
    }

    /** Robots in turn go somewhere and back, as far as they may. */
    static InTurn.Batch moves(Geometry geometry, String[] robots, double[] ways) {
        return (from, count) -> {
            int made = 0;
            for (int k = from; k < from + count; k++) {
                // An even number and the next are one way there and back.
                int leg = k >> 1;
                String robot = robots[leg % robots.length];
                double sign = (k & 1) == 0 ? 1 : -1;
                made += geometry.simpleMove(robot, sign * ways[2 * leg], 0, sign * ways[2 * leg + 1]) ? 1 : 0;
            }
            return made;
        };
    }
}
