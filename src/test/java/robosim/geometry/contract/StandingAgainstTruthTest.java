package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.StandingTruth;

/** Straight moves on a lattice, where contacts of all kinds are common, against the rule as linear programs know it. */
class StandingAgainstTruthTest {
    private static final int CASES = Integer.getInteger("standing.cases", Effort.cases(350));

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void movesAreAllowedByTheRule(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(Long.getLong("standing.seed", 61) + dimension.ordinal());
        int[] answers = new int[3];
        int excused = 0;
        for (int k = 0; k < CASES; k++) {
            List<GeometryObject> others = new ArrayList<>();
            for (int n = random.nextInt(1, 5); n > 0; n--) {
                others.add(obstacle(random));
            }
            GeometryObject mover = mover(dimension, random);
            Move move = new Move(random.nextInt(-6, 7), random.nextInt(-2, 3), random.nextInt(-6, 7), 0, 0);
            if (k % 2 == 0) {
                int axis = dimension == Dimension.SPATIAL && random.nextInt(3) != 0 ? 1 : 2 * random.nextInt(2);
                mover = stand(axis, mover, others, random);
                if (random.nextInt(4) != 0) {
                    move = new Move(axis == 0 ? 0 : move.x(), axis == 1 ? 0 : move.y(), axis == 2 ? 0 : move.z(), 0, 0);
                }
            }
            mover = mover.moveable("mover");
            int nudge = random.nextInt(6);
            Point c = mover.center();
            Point end = new Point(c.x() + move.x(), c.y() + move.y(), c.z() + move.z());
            if (nudge == 0) {
                move = new Move(move.x(), move.y() + (random.nextBoolean() ? 0x1p-48 : -0x1p-48), move.z(), 0, 0);
                end = new Point(end.x(), c.y() + move.y(), end.z());
            }
            Geometry world = new Geometry(64, 64, 64, dimension, Accuracy.EXACT);
            others.forEach(other -> assertThat(world.addObjectUnchecked(other)).isTrue());
            assertThat(world.addObjectUnchecked(mover)).isTrue();
            MoveResult result = world.moveGlobal("mover", move);
            StandingTruth.Answer truth = StandingTruth.move(mover, mover.movedTo(end), others, dimension);
            answers[truth.ordinal()]++;
            String what = "case %d: %s by %s beside %s: %s, %s"
                    .formatted(
                            k,
                            text(mover),
                            move,
                            others.stream().map(StandingAgainstTruthTest::text).toList(),
                            truth,
                            result);
            if (truth != StandingTruth.Answer.UNKNOWN) {
                assertThat(result.allowed()).as(what).isEqualTo(truth == StandingTruth.Answer.FREE);
            }
            if (truth == StandingTruth.Answer.FREE
                    && StandingTruth.isExcused(mover, mover.movedTo(end), others, dimension)) {
                excused++;
            }
        }
        // A sample that is all hits or all misses proves nothing.
        assertThat(answers[0]).isGreaterThan(CASES / 5);
        assertThat(answers[1]).isGreaterThan(CASES / 5);
        assertThat(excused).isGreaterThan(CASES / 100);
    }

    /** Puts the mover and what is beside it on two sides of a level, or of a wall, but for some that stand out by a little. */
    private static GeometryObject stand(
            int axis, GeometryObject mover, List<GeometryObject> others, SplittableRandom random) {
        int side = random.nextBoolean() ? 1 : -1;
        others.replaceAll(other -> {
            double out = random.nextInt(5) == 0 ? random.nextInt(-1, 2) * 0x1p-48 : 0;
            GeometryObject moved = shifted(other, axis, side * (out - end(other, axis, side)));
            int across = axis == 0 ? 2 : 0;
            return shifted(moved, across, random.nextInt(-4, 5));
        });
        return shifted(mover, axis, side * end(mover, axis, -side));
    }

    /** How far an object reaches along an axis, or against it. */
    private static double end(GeometryObject object, int axis, int side) {
        if (object instanceof MeshObject mesh) {
            return mesh.vertices().stream()
                    .mapToDouble(p -> side * of(p, axis))
                    .max()
                    .orElseThrow();
        }
        double half = switch (object.kind()) {
            case BOX -> {
                BoxObject box = (BoxObject) object;
                double[] r = box.rotation();
                yield (Math.abs(r[3 * axis]) * box.width()
                                + Math.abs(r[3 * axis + 1]) * box.height()
                                + Math.abs(r[3 * axis + 2]) * box.length())
                        / 2;
            }
            case CYLINDER -> ((CylinderObject) object).radius();
            default -> ((SphereObject) object).radius();
        };
        return side * of(object.center(), axis) + half;
    }

    private static double of(Point p, int axis) {
        return axis == 0 ? p.x() : axis == 1 ? p.y() : p.z();
    }

    private static GeometryObject shifted(GeometryObject object, int axis, double by) {
        Point c = object.center();
        return object.movedTo(
                new Point(c.x() + (axis == 0 ? by : 0), c.y() + (axis == 1 ? by : 0), c.z() + (axis == 2 ? by : 0)));
    }

    private static String text(GeometryObject object) {
        return object instanceof MeshObject mesh
                ? mesh + " " + mesh.vertices() + Arrays.deepToString(mesh.faces())
                : object.toString();
    }

    private static GeometryObject mover(Dimension dimension, SplittableRandom random) {
        return switch (random.nextInt(dimension == Dimension.PLANAR ? 5 : 4)) {
            case 0, 1 -> box(random);
            case 2 -> triangles(random, 1);
            case 3 -> new SphereObject(place(random), random.nextInt(0, 3));
            default -> new CylinderObject(place(random), random.nextInt(0, 3), 2);
        };
    }

    private static GeometryObject obstacle(SplittableRandom random) {
        return random.nextInt(3) == 0 ? triangles(random, random.nextInt(1, 3)) : box(random);
    }

    private static BoxObject box(SplittableRandom random) {
        BoxObject box = new BoxObject(place(random), random.nextInt(0, 5), random.nextInt(1, 5), random.nextInt(0, 5));
        if (random.nextInt(4) != 0) {
            return box;
        }
        // Of numbers that are not orthonormal to the bit, as stored.
        return random.nextBoolean() ? box.turned(0, 45) : box.turned(30, 60);
    }

    private static MeshObject triangles(SplittableRandom random, int count) {
        List<Point> corners = new ArrayList<>();
        for (int k = 0; k < count + 2; k++) {
            corners.add(place(random));
        }
        if (random.nextBoolean()) {
            double level = corners.get(0).y();
            corners.replaceAll(p -> new Point(p.x(), level, p.z()));
        }
        int[][] faces = new int[count][];
        for (int k = 0; k < count; k++) {
            faces[k] = new int[] {k, k + 1, k + 2};
        }
        return new MeshObject(corners, faces);
    }

    private static Point place(SplittableRandom random) {
        return new Point(random.nextInt(-3, 4), random.nextInt(-2, 3), random.nextInt(-3, 4));
    }
}
