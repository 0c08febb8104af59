package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.proof.Attempt;
import robosim.geometry.proof.ProofChecker;
import robosim.geometry.proof.Prover;
import robosim.geometry.proof.Scene;

/** Verdicts of random pairs are proved, those that are not true never, and the checker accepts each proof. */
class ProofOfPairsTest {
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
