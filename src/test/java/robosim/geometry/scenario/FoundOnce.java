package robosim.geometry.scenario;

import static robosim.geometry.scenario.Conversation.move;
import static robosim.geometry.scenario.Conversation.sonar;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.protocol.MoveRequest;

/**
 * What stress runs have found wrong once, as conversations. Each is answered otherwise by the module as it was before that
 * was mended; a wrong verdict about an overlap alone cannot be asked for over the wire.
 */
final class FoundOnce {
    private static final double LEAST = Double.MIN_VALUE;

    /** Own Z is up. */
    private static final double[] TILTED = {1, 0, 0, 0, 0, 1, 0, -1, 0};

    private FoundOnce() {}

    static Map<String, Conversation> all() {
        Map<String, Conversation> all = new LinkedHashMap<>();
        all.put("found-flat-box", flatBox());
        all.put("found-shadow-of-a-flat-box", shadow());
        all.put("found-least-direction", leastDirection());
        all.put("found-below-a-disc", belowADisc());
        all.put("found-subnormal-mesh", subnormalMesh());
        all.put("found-subnormal-box", subnormalBox());
        all.put("found-short-side", shortSide());
        all.put("found-lost-side", lostSide());
        return all;
    }

    private static SphereObject probe(double x, double y, double z) {
        return new SphereObject(new Point(x, y, z), 0).moveable("probe");
    }

    private static Conversation flatBox() {
        double cos = 0x1.f3b92138b3964p-2;
        double sin = -0x1.bee48faab16e3p-1;
        return new Conversation("A ray that starts 1e-17 above a box that is thinner than any rounding, and goes away")
                .world(
                        Dimension.PLANAR,
                        10,
                        new BoxObject(new Point(), 0x1.743799ce872dap0, 2, 2 * LEAST)
                                .oriented(new double[] {cos, 0, sin, 0, 1, 0, -sin, 0, cos})
                                .named("flat box"),
                        probe(-0x1.107814fb7f712p-2, 0, -0x1.e753e44686f26p-2))
                .sonars(sonar("probe", 0x1.6b4ac6a501e23p-3, 0x1.44e2982f04a19p-2));
    }

    private static Conversation shadow() {
        return new Conversation("A point in the shadow of a box whose height is 1e-323: it cannot go deeper")
                .world(
                        Dimension.PLANAR,
                        20,
                        new BoxObject(
                                        new Point(0x1.0def1faaed8c4p-1, -0x1.8832dcab9e788p-2, -0x1.4283e76aab848p1),
                                        4,
                                        2 * LEAST,
                                        1)
                                .oriented(new double[] {
                                    0x1.2183249acded2p-2,
                                    -0x1.47231b531975ep-1,
                                    0x1.6e4b2532da379p-1,
                                    -0x1.7345cd99ffdf2p-2,
                                    0x1.3d181f92c672ap-1,
                                    0x1.648f21e4d8476p-1,
                                    -0x1.c6aca59a2d23ep-1,
                                    -0x1.d33b826ad65aap-2,
                                    -0x1.cf599dded3e4p-5
                                })
                                .named("flat box"),
                        probe(0, 0, -1))
                .sonars(sonar("probe", 1, 0), sonar("probe", 0, 1))
                .moves(move("probe", 0, -0.25), move("probe", -0.25, 0), move("probe", 0, 1));
    }

    private static Conversation leastDirection() {
        return new Conversation("5e-324 is a direction's coordinate like any other: that ray rises above the edge")
                .world(
                        Dimension.SPATIAL,
                        40,
                        new MeshObject(
                                List.of(new Point(-1, 0, 0), new Point(-1, -1, 1), new Point(-1, 0, 2)),
                                new int[][] {{0, 1, 2}}),
                        probe(7, 0, 1).oriented(TILTED))
                .sonars(sonar("probe", -8, 0), sonar("probe", -8, LEAST), sonar("probe", -8, -LEAST));
    }

    private static Conversation belowADisc() {
        return new Conversation("A ray that starts 5e-324 below a disc and goes down misses it")
                .world(
                        Dimension.SPATIAL,
                        40,
                        new CylinderObject(new Point(), 3, 0).named("disc"),
                        probe(1, -LEAST, 1).oriented(TILTED))
                .sonars(sonar("probe", 0, -3), sonar("probe", 0, 3));
    }

    private static Conversation subnormalMesh() {
        List<Point> corners = List.of(
                new Point(7 * LEAST, 10 * LEAST, 10 * LEAST),
                new Point(8 * LEAST, -10 * LEAST, -7 * LEAST),
                new Point(-9 * LEAST, 6 * LEAST, -7 * LEAST));
        Conversation talk = new Conversation("A mesh of subnormal size keeps its triangles: its corners are on it");
        for (Point corner : corners) {
            talk.world(
                            Dimension.SPATIAL,
                            1,
                            new MeshObject(corners, new int[][] {{0, 1, 2}}),
                            probe(corner.x(), corner.y(), corner.z()))
                    .sonars(sonar("probe", 1, 0), sonar("probe", -1, 0), sonar("probe", 0, 1));
        }
        return talk;
    }

    private static Conversation subnormalBox() {
        double unit = 0x1p-1060;
        return new Conversation("A point does not pass through a square of 1e-319")
                .world(
                        Dimension.SPATIAL,
                        1,
                        new BoxObject(new Point(0.5 * unit, 0.5 * unit, -1.5 * unit), 0, 0, 0.5 * unit)
                                .oriented(new double[] {0, 1, 0, 1, 0, 0, 0, 0, -1})
                                .named("square"),
                        probe(-2.5 * unit, -2.5 * unit, 1.25 * unit))
                .moves(new MoveRequest("probe", 6 * unit, 6 * unit, -6 * unit, 0, 0))
                .moves(new MoveRequest("probe", 2 * unit, 2 * unit, -2 * unit, 0, 0));
    }

    private static Conversation shortSide() {
        double unit = 0x1p61;
        MeshObject side = new MeshObject(
                List.of(new Point(0, -0.5 * unit, unit), new Point(-0x1p-1014, -0.5 * unit, unit)),
                new int[][] {{0, 0, 1}});
        return new Conversation("A side whose square underflows does not pass through a disc of 2e18")
                .world(
                        Dimension.PLANAR,
                        0x1p70,
                        new SphereObject(new Point(-1.5 * unit, 0, -1.5 * unit), unit).named("ball"),
                        side.moveable("side"))
                .moves(move("side", -3 * unit, -2.5 * unit));
    }

    private static Conversation lostSide() {
        MeshObject side = new MeshObject(
                List.of(new Point(-0x1.4p-537, 0, 1), new Point(0x1.5p-536, 0, 1)), new int[][] {{0, 1, 1}});
        return new Conversation("A disc goes up to a side whose square has two bits, and no further")
                .world(
                        Dimension.PLANAR,
                        8,
                        side.named("side"),
                        new CylinderObject(new Point(), 0.5, 1).moveable("disc"))
                .moves(move("disc", 0, 0.25))
                .moves(move("disc", 0, 0.25))
                .sonars(sonar("disc", 0, 1));
    }
}
