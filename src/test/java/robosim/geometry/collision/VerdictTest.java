package robosim.geometry.collision;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.collision.Meshes.Family;
import robosim.geometry.collision.Verdict.Answer;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.reference.Reference;

/** Questions with a budget: what they answer, and how far they say that things are apart. */
class VerdictTest {
    /** Reference knows exactly whether a ball of a radius around a point reaches a surface. */
    @Test
    void theBracketHoldsTheDistanceAfterAnyNumberOfSteps() {
        SplittableRandom random = new SplittableRandom(51);
        int apart = 0;
        for (int k = 0; k < 12; k++) {
            MeshObject mesh = Family.RANDOM.mesh(random, 5, k % 2);
            Point place = new Point(random.nextDouble(-1, 2), random.nextDouble(-1, 2), random.nextDouble(-1, 2));
            SphereObject point = new SphereObject(place, 0);
            Verdict last = ContactQuery.distance(mesh, point, Budget.UNLIMITED);
            for (int steps = 0; steps <= last.steps(); steps += 1 + steps / 4) {
                Verdict verdict = ContactQuery.distance(point, mesh, Budget.steps(steps));
                String what = "point %s, mesh %s %s: %s".formatted(place, mesh, mesh.vertices(), verdict);
                assertThat(Reference.overlap(new SphereObject(place, verdict.high()), mesh, Dimension.SPATIAL))
                        .as(what)
                        .isTrue();
                if (verdict.low() > 0) {
                    double below = Math.nextDown(verdict.low());
                    assertThat(Reference.overlap(new SphereObject(place, below), mesh, Dimension.SPATIAL))
                            .as(what)
                            .isFalse();
                    apart++;
                }
            }
            assertThat(last.high() - last.low()).isLessThan(0x1p-44);
        }
        assertThat(apart).isGreaterThan(30);
    }

    @Test
    void distancesOfFineMeshesAreThoseOfTheirBoxes() {
        MeshObject a = Meshes.finely(4, 2, 6, 8, false);
        MeshObject b = Meshes.finely(2, 2, 2, 10, true).movedTo(new Point(6, 6, 16));
        Verdict verdict = ContactQuery.distance(a, b, Budget.UNLIMITED); // gaps 3, 4 and 12
        assertThat(verdict.answer()).isEqualTo(Answer.NO);
        assertThat(verdict.low()).isBetween(13 - 1e-11, 13.0);
        assertThat(verdict.high()).isBetween(13.0, 13 + 1e-11);
        assertThat(verdict.steps()).isLessThan(2000);
        Verdict asked = ContactQuery.decide(a, b, Budget.UNLIMITED);
        assertThat(asked.answer()).isEqualTo(Answer.NO);
        assertThat(asked.steps()).isLessThan(10);
        Verdict flat = ContactQuery.distance(a, b, Dimension.PLANAR, Budget.UNLIMITED);
        assertThat(flat.low()).isBetween(Math.sqrt(153) - 1e-11, Math.sqrt(153));
        assertThat(flat.high()).isBetween(Math.sqrt(153), Math.sqrt(153) + 1e-11);
    }

    @Test
    void aSpentBudgetLeavesATrueBracket() {
        MeshObject a = Meshes.finely(4, 4, 4, 12, false);
        MeshObject b = Meshes.finely(2, 2, 2, 12, false).movedTo(new Point()); // a surface inside a surface: 1 apart
        for (Budget none : List.of(Budget.steps(0), Budget.time(Duration.ZERO), new Budget(0, Duration.ofDays(1)))) {
            Verdict verdict = ContactQuery.decide(a, b, none);
            assertThat(verdict.answer()).isEqualTo(Answer.UNDECIDED);
            assertThat(verdict.certainty()).isEqualTo(Certainty.UNCERTAIN);
            assertThat(verdict.steps()).isZero();
            assertThat(verdict.low()).isZero();
            assertThat(verdict.high()).isBetween(1.0, 20.0);
        }
        Verdict early = ContactQuery.decide(a, b, Budget.steps(12));
        assertThat(early.answer()).isEqualTo(Answer.UNDECIDED);
        assertThat(early.high()).isBetween(1.0, 10.0);
        Verdict end = ContactQuery.decide(a, b, new Budget(Long.MAX_VALUE, Duration.ofDays(1_000_000)));
        assertThat(end.answer()).isEqualTo(Answer.NO);
        assertThat(end.certainty()).isEqualTo(Certainty.EXACT);
        assertThat(ContactQuery.distance(a, b, Budget.UNLIMITED).high()).isBetween(1.0, 1 + 1e-12);
    }

    /** A box and a rim, of which a plane proves that they are apart by 1.241e-11. */
    @Test
    void nothingIsNearerThanAPlaneProves() {
        CylinderObject rim = new CylinderObject(new Point(), 0.025487967607358098, 1.7310606365122398)
                .oriented(new double[] {
                    -0.9308172262620389,
                    0.3322955917586398,
                    0.15218058677643362,
                    -1.2617556417204183E-17,
                    -0.41637983315172866,
                    0.9091907580615515,
                    0.3654850083024532,
                    0.8462904195619338,
                    0.38757352136574263
                });
        Point place = new Point(0.6715335308773012, -0.8242896182683084, -0.821061556196542);
        BoxObject box = new BoxObject(place, 1.25, 1.5, 1.830765944560399);
        Verdict verdict = ContactQuery.distance(rim, box, Budget.UNLIMITED);
        assertThat(verdict.answer()).isEqualTo(Answer.NO);
        assertThat(verdict.low()).isBetween(1.23e-11, 1.2425e-11);
        assertThat(verdict.high()).isBetween(1.24e-11, 1.25e-11);
    }

    /** Two cylinders askew that touch side to side as nearly as doubles say. */
    @Test
    void doubtIsToldOfAndNeverSaidToBeProof() {
        int doubts = 0;
        int proofs = 0;
        for (int k = 1; k <= 200; k++) {
            CylinderObject upright = new CylinderObject(new Point(), 1, 10);
            GeometryObject tilted = new CylinderObject(new Point(0, 0, 2.0 - (k % 3 - 1) * 1e-9 * (k % 2)), 1, 10)
                    .oriented(tilt(Math.toRadians(10 + k / 4.0)));
            Contact contact = ContactQuery.first(upright, tilted);
            Verdict verdict = ContactQuery.decide(tilted, upright, Budget.UNLIMITED);
            assertThat(contact != null).isEqualTo(CollisionDetection.intersects(upright, tilted));
            assertThat(verdict.answer()).isEqualTo(contact == null ? Answer.NO : Answer.YES);
            if (contact == null) {
                assertThat(verdict.certainty()).isEqualTo(Certainty.EXACT);
                assertThat(verdict.low()).isNotNegative();
                continue;
            }
            assertThat(verdict.certainty()).isEqualTo(contact.certainty());
            assertThat(verdict.low()).isZero();
            if (contact.certainty() == Certainty.EXACT) {
                assertThat(verdict.high()).isZero();
                proofs++;
            } else {
                assertThat(verdict.high()).isBetween(0.0, 1e-9);
                doubts++;
            }
        }
        assertThat(doubts).isPositive();
        assertThat(proofs).isPositive();
    }

    /** About Z, so that the axis stays square to it. */
    private static double[] tilt(double angle) {
        double c = StrictMath.cos(angle);
        double s = StrictMath.sin(angle);
        return new double[] {c, -s, 0, s, c, 0, 0, 0, 1};
    }
}
