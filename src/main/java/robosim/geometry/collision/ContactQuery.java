package robosim.geometry.collision;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.OwnLeaves;
import robosim.geometry.narrow.mesh.ContactPairs;
import robosim.geometry.narrow.mesh.NearestPairs;

/**
 * Where two objects touch, and whether they do and how far apart they are for as much work as one likes to spend.
 *
 * <p>A contact is a pair of pieces, one of each object, that have a point in common: boxes, cylinders, spheres and the
 * triangles of meshes. They are the same decisions as those of {@link CollisionDetection#intersects}: there is a contact
 * exactly where that is true. Pieces that do not truly meet are never named, and none that do is left out, faces in one
 * plane, edges and corners that only touch, and faces without area included. Where no faces of two parts meet but one
 * is a solid mesh that holds the other inside, that is one contact more: of the solid no face is named; of a mesh inside
 * the first face of a piece of it that is inside. How deep things are in each other is not told.
 *
 * <pre>{@code
 * BoxObject floor = new BoxObject(new Point(0, 0, 0), 10, 1, 10);
 * MeshObject roof = new MeshObject(
 *         List.of(new Point(0, 2, 0), new Point(1, 0.5, 0), new Point(0, 0.5, 1)), new int[][] {{0, 1, 2}});
 * List<Contact> contacts = ContactQuery.contacts(floor, roof);
 * contacts.size();                     // 1: the edge of the triangle lies on the floor
 * contacts.get(0).certainty();         // EXACT
 * MeshObject above = roof.movedTo(new Point(0, 3, 0));
 * ContactQuery.distance(floor, above, Budget.UNLIMITED).low(); // 3.0
 * ContactQuery.ask(floor, above, Budget.steps(100)).answer();  // NO
 * }</pre>
 *
 * <p>All questions mean the same for (a, b) and (b, a). Methods may be called from any number of threads. An argument that
 * is null or out of its range is refused with an {@code IllegalArgumentException} that names it.
 */
public final class ContactQuery {
    private static final int STEPS_A_LOOK = 16;

    private static final Comparator<Contact> ORDER =
            Comparator.comparing(Contact::a).thenComparing(Contact::b);

    private static final ThreadLocal<ContactQuery> MEMORY = ThreadLocal.withInitial(ContactQuery::new);

    private final ContactPairs pairs;
    private final NearestPairs nearest;
    private final double[] witness = new double[7];

    private ContactQuery() {
        Scratch scratch = new Scratch();
        pairs = new ContactPairs(scratch);
        nearest = new NearestPairs(scratch);
    }

    /**
     * All contacts in space, ordered by part, face and half of a, then of b. For (b, a) the same ones with their sides
     * exchanged: the same points, and opposite normals but between two pieces that are the same set.
     *
     * @return empty where the two are apart
     */
    public static List<Contact> contacts(GeometryObject a, GeometryObject b) {
        return contacts(a, b, Dimension.SPATIAL, Integer.MAX_VALUE);
    }

    /**
     * Contacts in space or between the projections on XZ, in the order of {@link #contacts(GeometryObject,
     * GeometryObject)}. In PLANAR nothing is inside of what is seen as a surface, normals are level, and a point's height
     * is the middle of what the heights of its pieces have in common or leave between them.
     *
     * @param limit how many to answer at most, at least 1. Which ones of more that is are those that are found first:
     *     always the same, in whichever order the objects are given
     */
    public static List<Contact> contacts(GeometryObject a, GeometryObject b, Dimension dimension, int limit) {
        check(a, b, dimension);
        if (limit < 1) {
            throw new IllegalArgumentException("limit must be at least 1 (got: " + limit + ")");
        }
        return MEMORY.get().find(OwnLeaves.placed(a), OwnLeaves.placed(b), dimension, limit);
    }

    /**
     * One contact in space: the first that is found, which is quicker than to find all. Always the same one, in whichever
     * order the objects are given, and one of {@link #contacts(GeometryObject, GeometryObject)}, not always the first.
     *
     * @return null where the two are apart
     */
    public static @Nullable Contact first(GeometryObject a, GeometryObject b) {
        List<Contact> found = contacts(a, b, Dimension.SPATIAL, 1);
        return found.isEmpty() ? null : found.get(0);
    }

    /**
     * Whether two objects touch or overlap in space: stops as soon as that is known, or where the budget ends with what
     * is known then. Never a guess.
     */
    public static Verdict ask(GeometryObject a, GeometryObject b, Budget budget) {
        return ask(a, b, Dimension.SPATIAL, budget);
    }

    /**
     * Whether two objects or their projections touch or overlap. The answer is "undecided" only where the budget was
     * spent. More steps never widen the bracket and never change an answer that was given.
     */
    public static Verdict ask(GeometryObject a, GeometryObject b, Dimension dimension, Budget budget) {
        return limited(a, b, dimension, budget, false);
    }

    /**
     * The distance of two objects in space: goes on where {@link #ask(GeometryObject, GeometryObject, Budget)} stops,
     * until the bracket is as narrow as doubles allow or the budget ends.
     */
    public static Verdict distance(GeometryObject a, GeometryObject b, Budget budget) {
        return distance(a, b, Dimension.SPATIAL, budget);
    }

    /**
     * The distance of two objects or of their projections. More steps never widen the bracket; without a limit it is at
     * most 2<sup>-43</sup> of the distance and the objects' size wide, near contact too. Both ends are proven, with what
     * rounding may have moved them.
     */
    public static Verdict distance(GeometryObject a, GeometryObject b, Dimension dimension, Budget budget) {
        return limited(a, b, dimension, budget, true);
    }

    private static Verdict limited(
            GeometryObject a, GeometryObject b, Dimension dimension, Budget budget, boolean measures) {
        long start = System.nanoTime();
        check(a, b, dimension);
        Checks.present("budget", budget);
        NearestPairs nearest = MEMORY.get().nearest;
        nearest.start(dimension, OwnLeaves.placed(a), OwnLeaves.placed(b));
        long nanos = budget.nanos();
        while (!(measures ? nearest.isMeasured() : nearest.isDecided()) && nearest.steps() < budget.steps()) {
            if (nearest.steps() % STEPS_A_LOOK == 0 && System.nanoTime() - start >= nanos) {
                break;
            }
            nearest.step();
        }
        nearest.close();
        boolean certain = nearest.isDecided() && (nearest.isCertain() || !nearest.touches());
        return new Verdict(
                answer(nearest),
                certain ? Certainty.EXACT : Certainty.UNCERTAIN,
                nearest.low(),
                nearest.high(),
                nearest.steps());
    }

    private static Verdict.Answer answer(NearestPairs nearest) {
        if (nearest.touches()) {
            return Verdict.Answer.YES;
        }
        return nearest.isDecided() ? Verdict.Answer.NO : Verdict.Answer.UNDECIDED;
    }

    private static void check(GeometryObject a, GeometryObject b, Dimension dimension) {
        Checks.present("a", a);
        Checks.present("b", b);
        Checks.present("dimension", dimension);
    }

    private List<Contact> find(LeafColumn a, LeafColumn b, Dimension dimension, int limit) {
        pairs.find(dimension, a, b, limit);
        List<Contact> found = new ArrayList<>(pairs.count());
        for (int k = 0; k < pairs.count(); k++) {
            pairs.witness(k, witness);
            found.add(new Contact(
                    new ContactPart(pairs.partA(k), pairs.faceA(k), pairs.halfA(k)),
                    new ContactPart(pairs.partB(k), pairs.faceB(k), pairs.halfB(k)),
                    new Point(witness[0], witness[1], witness[2]),
                    new Point(witness[3], witness[4], witness[5]),
                    witness[6],
                    pairs.isCertain(k) ? Certainty.EXACT : Certainty.UNCERTAIN));
        }
        pairs.close();
        found.sort(ORDER);
        return Collections.unmodifiableList(found);
    }
}
