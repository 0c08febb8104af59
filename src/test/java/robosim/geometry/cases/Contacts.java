package robosim.geometry.cases;

import java.math.BigDecimal;
import java.util.List;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.Contact;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.Verdict;
import robosim.geometry.collision.Verdict.Answer;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.reference.Gaps;

/** What {@link ContactQuery} says to the same questions. */
final class Contacts {
    /** How many of the contacts of a pair are looked at: each is held against the exact reference. */
    private static final int LOOKED_AT = 3;

    private Contacts() {}

    /** What is wrong with the contacts, or also with their points, or the verdicts of a pair; empty where nothing is. */
    static String complaint(GeometryObject a, GeometryObject b, Dimension dimension, boolean collides, boolean points) {
        List<Contact> contacts = ContactQuery.contacts(a, b, dimension, LOOKED_AT);
        if (contacts.isEmpty() == collides) {
            return "contacts " + contacts;
        }
        for (Contact contact : points ? contacts : List.<Contact>of()) {
            for (GeometryObject object : List.of(a, b)) {
                BigDecimal off = Trial.known(() -> Gaps.distance(Trial.point(contact.point()), object, dimension));
                if (off.compareTo(new BigDecimal(contact.error())) > 0) {
                    return "contact " + contact + " is " + off.doubleValue() + " off";
                }
            }
        }
        Answer expected = collides ? Answer.YES : Answer.NO;
        Verdict whole = ContactQuery.decide(a, b, dimension, Budget.UNLIMITED);
        Verdict early = ContactQuery.decide(a, b, dimension, Budget.steps(2));
        boolean same = whole.answer() == expected
                && (early.answer() == expected || early.answer() == Answer.UNDECIDED)
                && (!collides || early.low() == 0);
        return same ? "" : "verdict " + whole + ", after two steps " + early;
    }

    /** Whether the bracket of a distance holds the truth and is as narrow as promised. */
    static boolean brackets(GeometryObject a, GeometryObject b, Dimension dimension, BigDecimal truth) {
        Verdict verdict = ContactQuery.distance(a, b, dimension, Budget.UNLIMITED);
        double size = Math.max(truth.doubleValue(), Math.max(Truth.size(a), Truth.size(b)));
        return new BigDecimal(verdict.low()).compareTo(truth) <= 0
                && new BigDecimal(verdict.high()).compareTo(truth) >= 0
                && verdict.high() - verdict.low() <= 2 * size * 0x1p-40;
    }
}
