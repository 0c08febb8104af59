package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.proof.Attempt;
import robosim.geometry.proof.ProofChecker;
import robosim.geometry.proof.Prover;
import robosim.geometry.proof.Scene;

/** Answers of random worlds and pairs, most of which are to be proved; a proof that is found always holds. */
class ProofOfAnswersTest {
    private final TreeMap<String, int[]> counts = new TreeMap<>();

    private void check(Geometry world, List<Attempt> attempts, String what) {
        ProofChecker checker = world.prove().checker();
        for (Attempt attempt : attempts) {
            String kind = what + " " + attempt.claim().getClass().getSimpleName();
            int[] count = counts.computeIfAbsent(kind, k -> new int[2]);
            count[0]++;
            if (attempt.proof() == null) {
                count[1]++;
                continue;
            }
            ProofChecker.Result result = checker.check(attempt.proof());
            assertThat(result.reason())
                    .as(attempt.proof() + " " + world.objects())
                    .isEmpty();
        }
    }

    private void run(Dimension dimension, boolean upright, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        RandomObjects objects = new RandomObjects(random, 6);
        for (int k = 0; k < Effort.cases(160); k++) {
            Geometry world = new Geometry(40, 40, 40, dimension, Accuracy.EXACT);
            for (int n = 0; n < 20; n++) {
                world.addObject(upright ? objects.upright() : objects.next());
            }
            GeometryObject robot = objects.primitive();
            robot = upright ? objects.upright() : robot;
            if (!world.addObject(robot.moveable("robot"))) {
                continue;
            }
            check(world, List.of(world.prove().apart("robot")), "apart");
            check(world, List.of(world.prove().proximity("robot", 20)), "proximity");
            Point d = objects.direction();
            check(
                    world,
                    world.prove().move("robot", new Move(d.x() * 3, upright ? 0 : d.y(), d.z() * 3, 0, 0)),
                    "move");
            double ry = random.nextDouble(-170, 170);
            check(world, world.prove().move("robot", new Move(0, 0, 0, 0, ry)), "turn");
            if (dimension == Dimension.SPATIAL) {
                check(world, world.prove().move("robot", new Move(0, 0, 0, ry, 0)), "tip");
            }
            Ray ray = new Ray(
                    objects.place(),
                    dimension == Dimension.PLANAR ? new Point(d.x(), 0, d.z() == 0 && d.x() == 0 ? 1 : d.z()) : d);
            check(world, List.of(world.prove().ray(ray, 30)), "ray");
            check(world, List.of(world.prove().cone(ray, 30, random.nextDouble(1, 90))), "cone");
        }
        // Cones past rims and a few distances of thin triangles have no proof yet.
        counts.forEach((kind, count) ->
                assertThat(count[1]).as(kind + ", not proved of " + count[0]).isLessThanOrEqualTo(1 + count[0] / 50));
        assertThat(counts).hasSizeGreaterThan(8);
    }

    @Test
    void answersInSpaceAreProved() {
        run(Dimension.SPATIAL, false, 1);
    }

    @Test
    void answersOfUprightObjectsAreProved() {
        run(Dimension.SPATIAL, true, 2);
    }

    @Test
    void answersInThePlaneAreProved() {
        run(Dimension.PLANAR, true, 3);
    }

    /** Verdicts of random pairs are proved, those that are not true never, and the checker accepts each proof. */
    @Test
    void verdictsOfPairsAreProved() {
        SplittableRandom random = new SplittableRandom(44);
        RandomObjects objects = new RandomObjects(random, 1.2);
        List<String> unproved = new ArrayList<>();
        int touching = 0;
        int count = Effort.cases(4000);
        int proved = 0;
        for (int k = 0; k < count; k++) {
            GeometryObject a = objects.next();
            GeometryObject b = objects.next();
            boolean touches = CollisionDetection.intersects(a, b);
            touching += touches ? 1 : 0;
            Prover prover = Prover.of(b);
            Attempt attempt = touches ? prover.touching(a, 0) : prover.apart(a);
            Attempt opposite = touches ? prover.apart(a) : prover.touching(a, 0);
            String pair = a + ", " + b + " touching " + touches;
            assertThat(opposite.isProved()).as(pair + " the opposite").isFalse();
            if (attempt.isProved()) {
                proved++;
                ProofChecker.Result result = new ProofChecker(Scene.of(b)).check(attempt.proof());
                assertThat(result.reason()).as(pair + attempt.proof()).isEmpty();
            } else {
                unproved.add(pair);
            }
        }
        // A sample of only touching, or only separate, pairs proves nothing.
        assertThat(touching).isBetween(count * 3 / 10, count * 7 / 10);
        assertThat(unproved).hasSizeLessThanOrEqualTo(1 + count / 1000);
        assertThat(proved + unproved.size()).isEqualTo(count);
    }
}
