package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.Certainty;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.collision.Contact;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.Verdict;
import robosim.geometry.collision.Verdict.Answer;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/** Contacts and limited questions over all shapes: one verdict however it is asked for, whoever comes first. */
class ContactLawsTest {
    private static final int COUNT = 1500;

    private static boolean collide(GeometryObject a, GeometryObject b, Dimension dimension) {
        if (dimension == Dimension.SPATIAL) {
            return CollisionDetection.intersects(a, b);
        }
        Geometry world = new Geometry(1000, 1000, 1000, dimension, Accuracy.EXACT);
        assertThat(world.addObjectUnchecked(a)).isTrue();
        return world.testObject(b);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void allQuestionsHaveOneVerdict(Dimension dimension) {
        RandomObjects objects = new RandomObjects(new SplittableRandom(31), 1.4);
        int hits = 0;
        for (int k = 0; k < COUNT; k++) {
            GeometryObject a = objects.next();
            GeometryObject b = objects.next();
            String pair = "%s, pair %d: %s | %s".formatted(dimension, k, a, b);
            boolean truth = collide(a, b, dimension);
            List<Contact> contacts = ContactQuery.contacts(a, b, dimension, Integer.MAX_VALUE);
            assertThat(!contacts.isEmpty()).as(pair).isEqualTo(truth);
            List<Contact> one = ContactQuery.contacts(a, b, dimension, 1);
            assertThat(one).as(pair).hasSize(truth ? 1 : 0);
            assertThat(contacts).as(pair).containsAll(one);
            Verdict asked = ContactQuery.decide(a, b, dimension, Budget.UNLIMITED);
            assertThat(asked.answer()).as(pair).isEqualTo(truth ? Answer.YES : Answer.NO);
            Verdict measured = ContactQuery.distance(a, b, dimension, Budget.UNLIMITED);
            assertThat(measured.answer()).as(pair).isEqualTo(asked.answer());
            assertThat(measured.low()).as(pair).isGreaterThanOrEqualTo(asked.low());
            assertThat(measured.high()).as(pair).isLessThanOrEqualTo(asked.high());
            if (truth) {
                assertThat(measured.low()).as(pair).isZero();
            }
            assertThat(measured.high() - measured.low()).as(pair).isBetween(0.0, 0x1p-40 * (8 + measured.low()));
            hits += truth ? 1 : 0;
        }
        assertThat(hits).isBetween(COUNT * 3 / 10, COUNT * 8 / 10);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void theOrderOfTheTwoIsAMatterOfNames(Dimension dimension) {
        RandomObjects objects = new RandomObjects(new SplittableRandom(32), 1.2);
        int seen = 0;
        for (int k = 0; k < COUNT; k++) {
            GeometryObject a = objects.next();
            GeometryObject b = objects.next();
            String pair = "%s, pair %d: %s | %s".formatted(dimension, k, a, b);
            List<Contact> one = ContactQuery.contacts(a, b, dimension, Integer.MAX_VALUE);
            List<Contact> other = ContactQuery.contacts(b, a, dimension, Integer.MAX_VALUE);
            assertThat(other.stream().map(ContactLawsTest::swapped)).as(pair).containsExactlyInAnyOrderElementsOf(one);
            assertThat(ContactQuery.contacts(b, a, dimension, 2).stream().map(ContactLawsTest::swapped))
                    .as(pair)
                    .containsExactlyInAnyOrderElementsOf(ContactQuery.contacts(a, b, dimension, 2));
            Budget few = Budget.steps(k % 12);
            assertThat(ContactQuery.decide(b, a, dimension, few))
                    .as(pair)
                    .isEqualTo(ContactQuery.decide(a, b, dimension, few));
            assertThat(ContactQuery.distance(b, a, dimension, few))
                    .as(pair)
                    .isEqualTo(ContactQuery.distance(a, b, dimension, few));
            seen += one.size();
        }
        assertThat(seen).isGreaterThan(COUNT);
    }

    private static Contact swapped(Contact contact) {
        Point n = contact.normal();
        return new Contact(
                contact.b(),
                contact.a(),
                contact.point(),
                new Point(-n.x(), -n.y(), -n.z()),
                contact.error(),
                contact.certainty());
    }

    @Test
    void contactsAreInOrderWithPointsOnBothAndUnitNormals() {
        RandomObjects objects = new RandomObjects(new SplittableRandom(33), 1);
        int seen = 0;
        double worst = 0;
        for (int k = 0; k < COUNT; k++) {
            GeometryObject a = objects.next();
            GeometryObject b = objects.next();
            Contact last = null;
            for (Contact contact : ContactQuery.contacts(a, b)) {
                String what = "pair %d: %s | %s: %s".formatted(k, a, b, contact);
                if (last != null) {
                    int order = last.a().compareTo(contact.a());
                    assertThat(order == 0 ? last.b().compareTo(contact.b()) : order)
                            .as(what)
                            .isNegative();
                }
                last = contact;
                Point n = contact.normal();
                assertThat(Math.sqrt(n.x() * n.x() + n.y() * n.y() + n.z() * n.z()))
                        .as(what)
                        .isBetween(1 - 1e-12, 1 + 1e-12);
                worst = Math.max(worst, contact.error());
                seen++;
            }
        }
        assertThat(seen).isGreaterThan(COUNT);
        assertThat(worst).isBetween(0x1p-60, 0x1p-36);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void moreStepsNeverWidenTheBracketNorChangeTheAnswer(Dimension dimension) {
        RandomObjects objects = new RandomObjects(new SplittableRandom(34), 2);
        int undecided = 0;
        int decided = 0;
        for (int k = 0; k < 300; k++) {
            GeometryObject a = objects.next();
            GeometryObject b = objects.next();
            String pair = "%s, pair %d: %s | %s".formatted(dimension, k, a, b);
            Verdict truth = ContactQuery.distance(a, b, dimension, Budget.UNLIMITED);
            assertThat(truth.answer()).as(pair).isNotEqualTo(Answer.UNDECIDED);
            Verdict last = null;
            for (int steps = 0; steps <= truth.steps() + 1; steps++) {
                Verdict now = ContactQuery.distance(a, b, dimension, Budget.steps(steps));
                String what = pair + " after " + steps + " steps: " + now + " of " + truth;
                assertThat(now.low()).as(what).isLessThanOrEqualTo(truth.high());
                assertThat(now.high()).as(what).isGreaterThanOrEqualTo(truth.low());
                assertThat(now.low()).as(what).isLessThanOrEqualTo(now.high());
                assertThat(now.steps()).as(what).isEqualTo(Math.min(steps, truth.steps()));
                if (last != null) {
                    assertThat(now.low()).as(what).isGreaterThanOrEqualTo(last.low());
                    assertThat(now.high()).as(what).isLessThanOrEqualTo(last.high());
                    if (last.answer() != Answer.UNDECIDED) {
                        assertThat(now.answer()).as(what).isEqualTo(last.answer());
                    }
                }
                if (now.answer() == Answer.UNDECIDED) {
                    assertThat(now.certainty()).as(what).isEqualTo(Certainty.UNCERTAIN);
                    undecided++;
                } else {
                    assertThat(now.answer()).as(what).isEqualTo(truth.answer());
                    decided++;
                }
                last = now;
            }
            assertThat(last).as(pair).isEqualTo(truth);
        }
        assertThat(undecided).isGreaterThan(300);
        assertThat(decided).isGreaterThan(300);
    }
}
