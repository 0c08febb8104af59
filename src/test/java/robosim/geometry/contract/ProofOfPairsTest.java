package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.proof.Attempt;
import robosim.geometry.proof.ProofChecker;
import robosim.geometry.proof.Prover;
import robosim.geometry.proof.Scene;

class ProofOfPairsTest {
    @Test
    void verdictsOfPairsAreProved() {
        SplittableRandom random = new SplittableRandom(44);
        RandomObjects objects = new RandomObjects(random, 1.2);
        TreeMap<String, Integer> unproved = new TreeMap<>();
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
                unproved.merge(touches + " " + a.kind() + " " + b.kind(), 1, Integer::sum);
                if (System.getProperty("show") != null) System.out.println(pair + " " + attempt.reason());
            }
        }
        System.out.println(proved + " of " + count + " touching " + touching + " unproved " + unproved);
    }
}
