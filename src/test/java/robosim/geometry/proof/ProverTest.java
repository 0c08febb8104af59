package robosim.geometry.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** What a prover finds holds, also where doubles are hard put to tell. */
class ProverTest {
    /** A plane counts as found where doubles are sure, so that their products with normals must be as near as they say. */
    @Test
    void productsInDoublesAreWithinTheirRounding() {
        SplittableRandom random = new SplittableRandom(7);
        for (int k = 0; k < 4000; k++) {
            Point c = new Point(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            GeometryObject drum = new CylinderObject(c, random.nextDouble(0.1, 1), random.nextDouble(0.1, 1))
                    .turned(random.nextDouble(5, 175), random.nextDouble(360));
            double[] row = Piece.stored(drum).get(0);
            double off = StrictMath.pow(10, random.nextDouble(-17, 0)); // from the axis, where a root is steep
            double[] n = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                n[axis] = row[4 + 3 * axis] + off * random.nextDouble(-1, 1);
            }
            n = Rows.unit(n);
            Num exact = new Piece(row).most(Vec.of(n[0], n[1], n[2]));
            double error = exact.minus(Num.of(Rows.most(row, n))).abs().approximately();
            assertThat(error).as("%s along %s", drum, Arrays.toString(n)).isLessThan(Rows.ROUNDING * Rows.size(row));
        }
    }

    @Test
    void aRayAlongATinyDirectionHasAValidProofOrNone() {
        GeometryObject ball = new SphereObject(new Point(3, 0, 0), 1);
        for (Dimension dimension : Dimension.values()) {
            Scene scene = new Scene(List.of(ball), dimension, null);
            for (double length : new double[] {1, 1e-20, 1e-31, 1e-150, 1e-200, Double.MIN_VALUE}) {
                Attempt attempt = new Prover(scene).ray(new Point(), new Point(length, 0, 0), Claim.ALL, 2, 0);
                assertThat(attempt.isProved()).as("%s, %s", dimension, length).isEqualTo(length > 1e-30);
                if (attempt.isProved()) {
                    assertThat(new ProofChecker(scene).check(attempt.proof()).reason())
                            .isEmpty();
                } else {
                    assertThat(attempt.reason()).contains("too short");
                }
            }
        }
    }
}
