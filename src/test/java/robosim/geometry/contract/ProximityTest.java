package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** The least distance of an object to others: right where they are nearly in contact, and the same whatever else is there. */
class ProximityTest {
    private final SplittableRandom random = new SplittableRandom(240601);

    /** Edge to edge, a millionth apart. */
    @Test
    void boxesNearContactAreAsFarApartAsTheyAre() {
        Geometry geometry = new Geometry(100, 100, 100);
        geometry.addObjectUnchecked(
                new BoxObject(new Point(), 1, 1, 1).turned(60, 120).moveable("robot"));
        Point place = new Point(-0.167293923366, 0.457843680164, -1.058114501391);
        geometry.addObjectUnchecked(new BoxObject(place, 1, 1, 1).turned(160, 300));
        assertThat(geometry.getProximity("robot", 1)).isBetween(1.0000002e-6, 1.0000004e-6);
    }

    /** Things that are equally far to within what a kernel leaves open, and that bounds tell better than it does. */
    @Test
    void whatElseIsThereChangesNoDistance() {
        int close = 0;
        int rounds = Effort.cases(3_000);
        for (int round = 0; round < rounds; round++) {
            Dimension dimension = Dimension.values()[round & 1];
            Accuracy accuracy =
                    round % 3 > 0 ? Accuracy.EXACT : Accuracy.values()[round / 3 % Accuracy.values().length];
            double gap = round % 5 == 0 ? 2 : random.nextDouble(0.1, 5);
            GeometryObject robot = robot();
            List<GeometryObject> others = new ArrayList<>();
            for (int k = 0; k < 4; k++) {
                double off = random.nextInt(4) == 0 ? 0 : Math.scalb(random.nextDouble(-1, 1), -random.nextInt(36, 52));
                others.add(wall(k, gap + off));
            }
            double least = Double.POSITIVE_INFINITY;
            int ties = 0;
            for (GeometryObject other : others) {
                double alone = proximity(dimension, accuracy, robot, List.of(other), 1e3);
                ties += Math.abs(alone - least) < 1e-9 ? 1 : 0;
                least = Math.min(least, alone);
            }
            close += ties > 0 ? 1 : 0;
            Supplier<String> what = () -> "%s %s, %s beside %s".formatted(dimension, accuracy, robot, others);
            assertThat(proximity(dimension, accuracy, robot, others, 1e3))
                    .as(what)
                    .isEqualTo(least);
            assertThat(proximity(dimension, accuracy, robot, others, least))
                    .as(what)
                    .isEqualTo(least);
            List<GeometryObject> turnedRound = new ArrayList<>(others);
            java.util.Collections.reverse(turnedRound);
            assertThat(proximity(dimension, accuracy, robot, turnedRound, 1e3))
                    .as(what)
                    .isEqualTo(least);
        }
        assertThat(close).isGreaterThan(rounds / 2);
    }

    private static double proximity(
            Dimension dimension, Accuracy accuracy, GeometryObject robot, List<GeometryObject> others, double max) {
        Geometry geometry = new Geometry(400, 400, 400, dimension, accuracy);
        assertThat(geometry.addObjectUnchecked(robot)).isTrue();
        others.forEach(other -> assertThat(geometry.addObjectUnchecked(other)).isTrue());
        return geometry.getProximity("robot", max);
    }

    private GeometryObject robot() {
        Point centre = new Point();
        GeometryObject shape = switch (random.nextInt(4)) {
            case 0 -> new BoxObject(centre, 2, 2, 2);
            case 1 -> new CylinderObject(centre, 1, 2);
            case 2 -> new CylinderObject(centre, 1, 2).turned(90, 0);
            default -> block(1, 1, 1, 3).movedTo(centre);
        };
        return shape.moveable("robot");
    }

    /** On one of four sides of a robot that reaches 1 to all of them, so far off. */
    private GeometryObject wall(int side, double gap) {
        double half = random.nextInt(1, 20);
        double along = random.nextInt(-3, 4) * 0.25;
        double away = 1 + gap + half;
        double x = side == 0 ? away : side == 1 ? -away : along;
        double z = side == 2 ? away : side == 3 ? -away : along;
        Point centre = new Point(x, random.nextInt(-1, 2) * 0.5, z);
        return switch (random.nextInt(5)) {
            case 0 -> new BoxObject(centre, 2 * half, 3, 2 * half);
            case 1 -> new CylinderObject(centre, half, 3);
            case 2 -> new CylinderObject(centre, half, 2 * half).turned(90, 90 * random.nextInt(4));
            case 3 -> new SphereObject(centre, half);
            default -> block(half, 2, half, random.nextInt(1, 6)).movedTo(centre);
        };
    }

    /** The surface of a box about the origin, each side in squares. */
    private static MeshObject block(double hx, double hy, double hz, int parts) {
        double[] h = {hx, hy, hz};
        List<Point> corners = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            for (int sign = -1; sign <= 1; sign += 2) {
                for (int p = 0; p < parts; p++) {
                    for (int q = 0; q < parts; q++) {
                        int at = corners.size();
                        for (int corner = 0; corner < 4; corner++) {
                            double[] v = new double[3];
                            v[axis] = sign * h[axis];
                            int u = (axis + 1) % 3;
                            int w = (axis + 2) % 3;
                            v[u] = h[u] * (2.0 * (p + (corner == 1 || corner == 2 ? 1 : 0)) / parts - 1);
                            v[w] = h[w] * (2.0 * (q + corner / 2) / parts - 1);
                            corners.add(new Point(v[0], v[1], v[2]));
                        }
                        faces.add(new int[] {at, at + 1, at + 2, at + 3});
                    }
                }
            }
        }
        return new MeshObject(corners, faces.toArray(new int[0][]));
    }
}
