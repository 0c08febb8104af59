package robosim.geometry.collision;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.narrow.Cast;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.mesh.ContactPairs;
import robosim.geometry.narrow.mesh.NearestPairs;
import robosim.geometry.narrow.mesh.SignedPairs;
import robosim.geometry.proof.Attempt;
import robosim.geometry.proof.Prover;

/**
 * Finds where two objects touch and, within a budget of work, whether they touch and how far apart they are.
 *
 * <p>A contact is a pair of pieces, one of each object, that have a point in common: boxes, cylinders, spheres, capsules,
 * the triangles of meshes and the occupied cells of grids. The decisions are those of {@link
 * CollisionDetection#intersects}: there is a contact exactly if
 * that is true. No pieces are reported that do not meet, and none that do are left out, including faces in one plane,
 * edges and corners that only touch, and faces without area. If no faces of two parts meet but one part is a solid mesh
 * that contains the other, that is one more contact: no face is named for the solid, and for a mesh inside it the first
 * face of a piece that is inside. Penetration depth is not reported.
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
 * ContactQuery.decide(floor, above, Budget.steps(100)).answer();  // NO
 * ContactQuery.signedDistance(new BoxObject(new Point(0, 0.75, 0), 1, 1, 1), floor).direction(); // up: (0, 1, 0)
 * }</pre>
 *
 * <p>All queries are symmetric in a and b. Methods may be called from any number of threads. An argument that is null
 * or out of range throws an {@code IllegalArgumentException} that names it.
 */
public final class ContactQuery {
    private static final int STEPS_A_LOOK = 16;

    private static final Comparator<Contact> ORDER =
            Comparator.comparing(Contact::a).thenComparing(Contact::b);

    private static final ThreadLocal<ContactQuery> MEMORY = ThreadLocal.withInitial(ContactQuery::new);

    private final Scratch scratch = new Scratch();
    private final ContactPairs pairs;
    private final NearestPairs nearest;
    private final SignedPairs signed;
    private final double[] witness = new double[9];
    private final LeafColumn first = new LeafColumn(1);
    private final LeafColumn second = new LeafColumn(1);

    private ContactQuery() {
        pairs = new ContactPairs(scratch.distance);
        nearest = new NearestPairs(scratch.overlap);
        signed = new SignedPairs(scratch.distance);
    }

    /**
     * All contacts in space, ordered by part, face and half of a, then of b. For (b, a) the contacts are the same with
     * a and b exchanged: the same points, and opposite normals except between two pieces that are the same set.
     *
     * @return empty if the two are apart
     */
    public static List<Contact> contacts(GeometryObject a, GeometryObject b) {
        return contacts(a, b, Dimension.SPATIAL, Integer.MAX_VALUE);
    }

    /**
     * Contacts in space or between the projections on XZ, in the order of {@link #contacts(GeometryObject,
     * GeometryObject)}. In PLANAR every mesh counts as a surface without an inside, normals are horizontal, and the
     * height of a point is the middle of the overlap of its two pieces' height ranges, or of the gap between them.
     *
     * @param limit maximum number of contacts, at least 1. If there are more, those found first are returned: always
     *     the same ones, in whichever order the objects are given
     */
    public static List<Contact> contacts(GeometryObject a, GeometryObject b, Dimension dimension, int limit) {
        check(a, b, dimension);
        if (limit < 1) {
            throw new IllegalArgumentException("limit must be at least 1 (got: " + limit + ")");
        }
        Parts first = Parts.near(a, b);
        Parts second = Parts.near(b, a);
        return first.isEmpty() || second.isEmpty() ? List.of() : MEMORY.get().find(first, second, dimension, limit);
    }

    /**
     * One contact in space: the first that is found, which is faster than finding all. Always the same one, in
     * whichever order the objects are given. It is one of {@link #contacts(GeometryObject, GeometryObject)}, but not
     * always their first.
     *
     * @return null if the two are apart
     */
    public static @Nullable Contact first(GeometryObject a, GeometryObject b) {
        List<Contact> found = contacts(a, b, Dimension.SPATIAL, 1);
        return found.isEmpty() ? null : found.get(0);
    }

    /**
     * On which points the two pieces of a contact lie: up to four, deepest first. Two faces have the corners of the part
     * that they share, two edges their crossing, a face and an edge two points, and a corner or a ball one. What is turned by
     * less than 6 degrees against the plane of the contact counts as a face, and the end of a cylinder as an octagon. All
     * points are in plain doubles. If no such points are found, as within a solid mesh, the contact's own is the only one, with
     * depth 0.
     *
     * @param contact one of the {@link #contacts(GeometryObject, GeometryObject)} in space of the same two objects
     */
    public static List<Contact.Spot> manifold(GeometryObject a, GeometryObject b, Contact contact) {
        check(a, b, Dimension.SPATIAL);
        Checks.present("contact", contact);
        Leaf ofA = Parts.piece(a, contact.a());
        Leaf ofB = Parts.piece(b, contact.b());
        List<Contact.Spot> spots =
                ofA == null || ofB == null ? List.of() : new ContactPatch(contact.normal()).of(ofA, ofB);
        return spots.isEmpty() ? List.of(new Contact.Spot(contact.point(), 0)) : List.copyOf(spots);
    }

    /**
     * Distance along a beam from its start to an object in space, as {@code Geometry.getRayDistance} returns it in a world with
     * nothing else.
     *
     * @param width full opening angle in degrees, from 0 (a ray) up to, not including, 180
     * @return 0 if the beam starts inside a solid or on the object; {@code +Infinity} if it misses
     */
    public static double beamDistance(Ray ray, double width, GeometryObject object) {
        return beamDistance(ray, width, object, Accuracy.EXACT);
    }

    /** The same to what stands for an object at an accuracy, which is never farther. */
    public static double beamDistance(Ray ray, double width, GeometryObject object, Accuracy accuracy) {
        Checks.present("ray", ray);
        Checks.width(width);
        Checks.present("object", object);
        ContactQuery query = MEMORY.get();
        LeafColumn leaves = object.kind() == GeometryObject.Kind.GRID
                ? Parts.leaves(object, query.first)
                : Parts.leaves(object, Checks.present("accuracy", accuracy), Dimension.SPATIAL, query.first);
        Cast cast = new Cast(query.scratch);
        Point from = ray.start();
        Point to = ray.direction();
        cast.line(Dimension.SPATIAL, from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
        if (width > 0) {
            cast.beam.widen(Degrees.cos(width / 2), Degrees.sin(width / 2));
        }
        double nearest = Double.POSITIVE_INFINITY;
        for (int leaf = 0; leaf < leaves.size(); leaf++) {
            nearest = Math.min(nearest, cast.distance(leaves, leaf, nearest));
        }
        return nearest;
    }

    /**
     * Whether two objects touch or overlap in space. Stops as soon as that is known, or when the budget is spent, with
     * what is known by then. The result is never a guess.
     */
    public static Verdict decide(GeometryObject a, GeometryObject b, Budget budget) {
        return decide(a, b, Dimension.SPATIAL, budget);
    }

    /**
     * Whether two objects or their projections touch or overlap. The answer is "undecided" only if the budget was
     * spent. More steps never widen the bracket and never change a decided answer.
     */
    public static Verdict decide(GeometryObject a, GeometryObject b, Dimension dimension, Budget budget) {
        return decide(a, b, dimension, Accuracy.EXACT, budget);
    }

    /**
     * The same for what stands for the two objects at an accuracy: a sphere, box or prism around each. It never misses what the
     * objects themselves touch.
     */
    public static Verdict decide(
            GeometryObject a, GeometryObject b, Dimension dimension, Accuracy accuracy, Budget budget) {
        return limited(a, b, dimension, accuracy, budget, false);
    }

    /**
     * The distance of two objects in space: continues where {@link #decide(GeometryObject, GeometryObject, Budget)} stops,
     * until the bracket is as narrow as doubles allow or the budget is spent.
     */
    public static Verdict distance(GeometryObject a, GeometryObject b, Budget budget) {
        return distance(a, b, Dimension.SPATIAL, budget);
    }

    /**
     * The distance of two objects or of their projections. More steps never widen the bracket; without a limit its
     * width is at most 2<sup>-43</sup> of the distance and the objects' size, near contact too. Both ends are proven,
     * with rounding errors taken into account.
     */
    public static Verdict distance(GeometryObject a, GeometryObject b, Dimension dimension, Budget budget) {
        return distance(a, b, dimension, Accuracy.EXACT, budget);
    }

    /** The same for what stands for the two objects at an accuracy: the lower end is one for the objects themselves too. */
    public static Verdict distance(
            GeometryObject a, GeometryObject b, Dimension dimension, Accuracy accuracy, Budget budget) {
        return limited(a, b, dimension, accuracy, budget, true);
    }

    /**
     * The signed distance of two objects in space, with the points and the direction: positive apart, negative if they
     * overlap.
     */
    public static SignedDistance signedDistance(GeometryObject a, GeometryObject b) {
        return signedDistance(a, b, Dimension.SPATIAL, Budget.UNLIMITED);
    }

    /**
     * The same within a budget. More steps never widen the bracket. If the budget is spent before a pair of pieces has
     * been measured, the points are any two of the objects, which prove the upper end.
     */
    public static SignedDistance signedDistance(GeometryObject a, GeometryObject b, Budget budget) {
        return signedDistance(a, b, Dimension.SPATIAL, budget);
    }

    /**
     * The signed distance of two objects or of their projections. Without a limit, the bracket of two that are apart is at
     * most 2<sup>-43</sup> of the distance and the objects' size wide. Of two that overlap it is 2<sup>-43</sup> of their
     * size between boxes, spheres and triangles, and 2<sup>-33</sup> with a tipped cylinder or a capsule; for
     * objects of several pieces see {@link SignedDistance}. In PLANAR every mesh counts as a surface without an inside.
     */
    public static SignedDistance signedDistance(
            GeometryObject a, GeometryObject b, Dimension dimension, Budget budget) {
        return signedDistance(a, b, dimension, Accuracy.EXACT, budget);
    }

    /** The same for what stands for the two objects at an accuracy: the lower end is one for the objects themselves too. */
    public static SignedDistance signedDistance(
            GeometryObject a, GeometryObject b, Dimension dimension, Accuracy accuracy, Budget budget) {
        long start = System.nanoTime();
        check(a, b, dimension);
        Checks.present("accuracy", accuracy);
        Checks.present("budget", budget);
        ContactQuery query = MEMORY.get();
        SignedPairs signed = query.signed;
        LeafColumn ofA = Parts.leaves(a, accuracy, dimension, query.first);
        LeafColumn ofB = Parts.leaves(b, accuracy, dimension, query.second);
        if (budget.steps() > 0 && budget.nanos() > 0 && signed.isAnswered(dimension, ofA, ofB)) {
            return query.signed();
        }
        signed.start(dimension, ofA, ofB);
        long nanos = budget.nanos();
        while (!signed.isMeasured() && signed.steps() < budget.steps()) {
            if (signed.steps() % STEPS_A_LOOK == 0 && System.nanoTime() - start >= nanos) {
                break;
            }
            signed.step();
        }
        signed.finish();
        return query.signed();
    }

    private SignedDistance signed() {
        signed.witness(witness);
        return new SignedDistance(
                signed.low(), signed.high(), point(witness, 0), point(witness, 3), point(witness, 6), signed.steps());
    }

    private static Point point(double[] numbers, int at) {
        return new Point(numbers[at], numbers[at + 1], numbers[at + 2]);
    }

    /**
     * Whether two objects touch or overlap in space, with a proof: that they are apart, or that they have a point in common. An
     * attempt without a proof says nothing about the objects.
     */
    public static Attempt prove(GeometryObject a, GeometryObject b) {
        check(a, b, Dimension.SPATIAL);
        Prover prover = Prover.of(b);
        Attempt apart = prover.apart(a);
        return apart.isProved() ? apart : prover.touching(a, 0);
    }

    private static Verdict limited(
            GeometryObject a,
            GeometryObject b,
            Dimension dimension,
            Accuracy accuracy,
            Budget budget,
            boolean measures) {
        long start = System.nanoTime();
        check(a, b, dimension);
        Checks.present("accuracy", accuracy);
        Checks.present("budget", budget);
        ContactQuery query = MEMORY.get();
        NearestPairs nearest = query.nearest;
        nearest.start(
                dimension,
                Parts.leaves(a, accuracy, dimension, query.first),
                Parts.leaves(b, accuracy, dimension, query.second));
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

    private List<Contact> find(Parts a, Parts b, Dimension dimension, int limit) {
        pairs.find(dimension, a.leaves(), b.leaves(), limit);
        List<Contact> found = new ArrayList<>(pairs.count());
        for (int k = 0; k < pairs.count(); k++) {
            pairs.witness(k, witness);
            found.add(new Contact(
                    new ContactPart(a.number(pairs.partA(k)), pairs.faceA(k), pairs.halfA(k)),
                    new ContactPart(b.number(pairs.partB(k)), pairs.faceB(k), pairs.halfB(k)),
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
