package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.dynamics.BodyContact;
import robosim.geometry.model.Point;

/**
 * A body and what it touches, has collided with in a step, or has parted from.
 *
 * @param objectName a body
 * @param other      what it met: another body or another object; null for an object without a name and for the border of the
 *                   world
 * @param point      where they met; of several touches in the step, that of the greatest impulse
 * @param normal     unit normal there, towards {@code objectName}
 * @param impulse    what {@code objectName} was given along the normal, newton seconds, the sum over the step; 0
 *                   where they only touch or part
 * @param phase      whether the contact has begun in this step, goes on since the one before, or has ended
 * @param fall       by how much {@code objectName} has fallen before it landed here in this step, world units, if that is more
 *                   than its own height; else 0. Onto the lower border of the world, mostly a floor is missing
 */
public record ContactAnswer(
        String objectName, @Nullable String other, Point point, Point normal, double impulse, Phase phase, double fall)
        implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** How a contact stands to the step before. */
    public enum Phase {
        /** There was none in the step before. */
        BEGIN,
        /** It lasts: there was one in the step before, and it goes on. Not the final one, which is {@link #END}. */
        LAST,
        /** There was one in the step before, and is none any more. */
        END
    }

    /** Refuses null where it has no meaning, and an impulse or a fall that is not a number of at least 0. */
    public ContactAnswer {
        Checks.present("objectName", objectName);
        Checks.present("point", point);
        Checks.present("normal", normal);
        Checks.present("phase", phase);
        if (!(impulse >= 0 && impulse <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("impulse must be a finite number of at least 0 (got: " + impulse + ")");
        }
        impulse += 0.0;
        if (!(fall >= 0 && fall <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("fall must be a finite number of at least 0 (got: " + fall + ")");
        }
        fall += 0.0;
    }

    /** A contact as it is sent, and the fall that ended with it; 0 for none. */
    public static ContactAnswer of(BodyContact contact, double fall) {
        return new ContactAnswer(
                contact.body(),
                contact.other(),
                contact.point(),
                contact.normal(),
                contact.impulse(),
                Phase.valueOf(contact.phase().name()),
                fall);
    }

    /** The contact. */
    public BodyContact contact() {
        return new BodyContact(objectName, other, point, normal, impulse, BodyContact.Phase.valueOf(phase.name()));
    }

    /** A contact that ends no fall. */
    public ContactAnswer(
            String objectName, @Nullable String other, Point point, Point normal, double impulse, Phase phase) {
        this(objectName, other, point, normal, impulse, phase, 0);
    }
}
