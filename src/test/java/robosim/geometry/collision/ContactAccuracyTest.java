package robosim.geometry.collision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.contract.RandomObjects;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** Queries of two objects at an accuracy below EXACT: those of a world with that accuracy, and never a miss. */
class ContactAccuracyTest {
    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void aPairIsDecidedAsInAWorldOfThatAccuracy(Accuracy accuracy) {
        SplittableRandom random = new SplittableRandom(40_201);
        RandomObjects objects = new RandomObjects(random, 1.5);
        int added = 0;
        int touching = 0;
        for (int n = 0; n < 300; n++) {
            GeometryObject a = objects.next();
            GeometryObject b = objects.next();
            for (Dimension dimension : Dimension.values()) {
                Geometry world = new Geometry(40, 40, 40, dimension, accuracy);
                world.addObjectUnchecked(b);
                Verdict found = ContactQuery.decide(a, b, dimension, accuracy, Budget.UNLIMITED);
                Verdict exact = ContactQuery.decide(a, b, dimension, Budget.UNLIMITED);
                boolean touches = found.answer() == Verdict.Answer.YES;
                String pair = "%s, %s in %s".formatted(a, b, dimension);
                assertThat(touches).as(pair).isEqualTo(world.testObject(a));
                if (exact.answer() == Verdict.Answer.YES) {
                    assertThat(touches).as(pair).isTrue();
                }
                SignedDistance signed = ContactQuery.signedDistance(a, b, dimension, accuracy, Budget.UNLIMITED);
                SignedDistance truth = ContactQuery.signedDistance(a, b, dimension, Budget.UNLIMITED);
                if (truth.low() > 0) {
                    assertThat(signed.low()).as(pair).isLessThanOrEqualTo(truth.high() + 1e-12);
                    Verdict apart = ContactQuery.distance(a, b, dimension, accuracy, Budget.UNLIMITED);
                    assertThat(apart.low()).as(pair).isEqualTo(Math.max(0, signed.low()), within(1e-12));
                }
                touching += touches ? 1 : 0;
                added += touches && exact.answer() == Verdict.Answer.NO ? 1 : 0;
            }
        }
        assertThat(touching).isBetween(60, 560);
        assertThat(added > 0).isEqualTo(accuracy != Accuracy.EXACT);
    }

    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void aBeamIsMeasuredAsInAWorldOfThatAccuracy(Accuracy accuracy) {
        SplittableRandom random = new SplittableRandom(40_202);
        RandomObjects objects = new RandomObjects(random, 1);
        int hits = 0;
        for (int n = 0; n < 200; n++) {
            GeometryObject object = objects.next();
            Geometry world = new Geometry(40, 40, 40, Dimension.SPATIAL, accuracy);
            world.addObjectUnchecked(object);
            Point from = new Point(random.nextDouble(2, 6), random.nextDouble(-2, 2), random.nextDouble(-2, 2));
            Ray ray = new Ray(from, new Point(-from.x(), -from.y(), -from.z()));
            for (double width : new double[] {0, 20}) {
                double found = ContactQuery.beamDistance(ray, width, object, accuracy);
                assertThat(found).isEqualTo(world.getRayDistance(ray, 0, Double.POSITIVE_INFINITY, width));
                assertThat(found).isLessThanOrEqualTo(ContactQuery.beamDistance(ray, width, object) + 1e-12);
                hits += found < Double.POSITIVE_INFINITY ? 1 : 0;
            }
        }
        assertThat(hits).isBetween(100, 390);
    }

    @Test
    void anAccuracyMustBeGiven() {
        SphereObject ball = new SphereObject(new Point(), 1);
        BoxObject box = new BoxObject(new Point(1.9, 1.9, 0), 2, 2, 2);
        assertThat(ContactQuery.decide(ball, box, Dimension.SPATIAL, Accuracy.AABB, Budget.UNLIMITED)
                        .answer())
                .isEqualTo(Verdict.Answer.YES);
        assertThat(ContactQuery.decide(ball, box, Budget.UNLIMITED).answer()).isEqualTo(Verdict.Answer.NO);
        assertThatThrownBy(() -> ContactQuery.distance(ball, box, Dimension.SPATIAL, null, Budget.UNLIMITED))
                .hasMessageContaining("accuracy");
    }
}
