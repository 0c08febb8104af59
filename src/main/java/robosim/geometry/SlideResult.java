package robosim.geometry;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.engine.motion.Slide;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * The outcome of {@link Geometry#moveAndSlide}.
 *
 * <pre>{@code
 * Geometry geometry = new Geometry();
 * geometry.addObject(new BoxObject(new Point(5, 0, 0), 2, 2, 20).named("wall"));
 * geometry.addObject(new SphereObject(new Point(0, 0, 0), 1).moveable("ball"));
 * SlideResult result = geometry.moveAndSlide("ball", new Move(6, 0, 4, 0, 0), 0, 4);
 * result.contacts().get(0).obstacle().name(); // "wall"
 * result.made().z();                          // 4.0: along the wall
 * geometry.getObject("ball").center().x() < 3; // true: just before the wall, which begins at 4
 * }</pre>
 *
 * @param made         the displacement of the centre along the world's axes, from start to end
 * @param length       the length of the path, world units. The part that regains a lost clearance, and the rise and descent of a
 *                     step, count too
 * @param left         the displacement along the world's axes that was still to go where the object stopped, as it was when
 *                     the last contact was met; zero if the way was made to its end, or to within 2<sup>-40</sup> of its
 *                     length. What a contact takes from the way,
 *                     its part into the plane of the contact, is in neither {@code made} nor {@code left}
 * @param turnFraction the fraction of the turns that was made, from 0 to 1, as in {@link MoveResult}
 * @param contacts     what was met, in order; empty if and only if nothing blocked. A plane that is met again before the
 *                     object has left it is listed once
 */
public record SlideResult(Point made, double length, Point left, double turnFraction, List<SlideContact> contacts) {
    /** Takes a copy of the list. */
    public SlideResult {
        Checks.present("made", made);
        Checks.present("left", left);
        contacts = Checks.list("contacts", contacts);
    }

    /**
     * A contact on the way.
     *
     * @param obstacle what was met, at its present place; null for the world's bounds
     * @param point    where the moved object touches it, at the place where it was stopped
     * @param normal   the unit normal at the contact, from what blocks towards the moved object
     */
    public record SlideContact(@Nullable GeometryObject obstacle, Point point, Point normal) {}

    static SlideResult of(Slide slide, ObjectTable objects) {
        List<SlideContact> contacts = new ArrayList<>(slide.count());
        for (int k = 0; k < slide.count(); k++) {
            int obstacle = slide.obstacle(k);
            contacts.add(new SlideContact(
                    obstacle >= 0 ? objects.present(obstacle) : null,
                    new Point(slide.contact(k, 0), slide.contact(k, 1), slide.contact(k, 2)),
                    new Point(slide.contact(k, 3), slide.contact(k, 4), slide.contact(k, 5))));
        }
        return new SlideResult(
                new Point(slide.made(0), slide.made(1), slide.made(2)),
                slide.length(),
                new Point(slide.left(0), slide.left(1), slide.left(2)),
                slide.turnFraction(),
                contacts);
    }
}
