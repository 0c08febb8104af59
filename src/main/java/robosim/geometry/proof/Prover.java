package robosim.geometry.proof;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.proof.Witness.Contact;
import robosim.geometry.proof.Witness.Form;
import robosim.geometry.proof.Witness.Slab;

/**
 * Looks for proofs of claims about the objects of a scene. What it finds is for a {@link ProofChecker} to decide; what it does not
 * find is reported as not proved.
 *
 * <p>A prover may be used by one thread at a time.
 */
public final class Prover {
    /** A claim is about points up to this much nearer, or farther, than a computed distance, of it and of sizes and places. */
    private static final double BRACKET = 0x1p-42;

    /** The same where rims pass each other, whose planes are hard to find. */
    private static final double WIDE_BRACKET = 0x1p-24;

    /** What a parameter may be, which is kept as a coordinate is. */
    private static final double LARGEST = 0x1p100;

    /** A shorter direction has a square that is rounded to few digits, or to none. */
    private static final double SMALLEST = 0x1p-480;

    private final Scene scene;
    private final SceneRows rows;
    private final boolean isFlat;
    private final ContactSearch contacts = new ContactSearch();
    private final Runnable betweenParts;

    /** A prover of claims about a scene. */
    public Prover(Scene scene) {
        this(scene, () -> {});
    }

    /**
     * A prover of claims about a scene.
     *
     * @param betweenParts runs very often while a proof is sought; it may throw, to end the search
     */
    public Prover(Scene scene, Runnable betweenParts) {
        this(scene, Checks.present("betweenParts", betweenParts), null);
    }

    private Prover(Scene scene, Runnable betweenParts, @Nullable SceneRows earlier) {
        this.scene = Checks.present("scene", scene);
        this.betweenParts = betweenParts;
        rows = SceneRows.of(scene.objects(), earlier);
        isFlat = scene.dimension() == Dimension.PLANAR;
    }

    /** A prover of claims about two objects in space, of which this one is the second. */
    public static Prover of(GeometryObject object) {
        return new Prover(Scene.of(object));
    }

    /** A prover for a scene that may have objects in common with this one's: what is known of these is kept. */
    public Prover with(Scene next) {
        return new Prover(next, betweenParts, rows);
    }

    /** What the claims are about. */
    public Scene scene() {
        return scene;
    }

    /** That a body has no point in common with the scene's first object. */
    public Attempt apart(GeometryObject body) {
        return apart(body, Claim.ALL, 0);
    }

    /** That a body has no point in common with an object, or with any but {@code self}. */
    public Attempt apart(GeometryObject body, int self, int other) {
        return still(body, self, other, false);
    }

    /** That a body overlaps nothing but {@code self} and is within the world: what it touches is listed in the claim. */
    public Attempt clear(GeometryObject body, int self) {
        return still(body, self, Claim.ALL, true);
    }

    private Attempt still(GeometryObject body, int self, int other, boolean mayTouch) {
        Course course = Course.along(rows(body), new double[3], 0);
        Free free = new Free(course, self, other, 0, mayTouch);
        return free.attempt(new Claim.Apart(body, self, other, List.copyOf(free.touched)), body, null, 0);
    }

    /** That a body has a point in common with an object. */
    public Attempt touching(GeometryObject body, int other) {
        Claim.Touching claim = new Claim.Touching(body, other);
        Contact contact = contact(body, Piece.of(body), other, new Point(), 0);
        return contact == null
                ? Attempt.failed(claim, "no common point was found that can be verified")
                : Attempt.of(claim, new Witness(List.of(), List.of(), contact, List.of(), 0));
    }

    /** That a body can be moved by a fraction of a displacement along the world's axes. */
    public Attempt translation(GeometryObject body, int self, Point displacement, double fraction) {
        Free free = free(body, self, displacement, fraction);
        Claim claim = new Claim.Translation(body, self, displacement, fraction, List.copyOf(free.touched));
        return free.attempt(claim, body, null, 0);
    }

    /**
     * That a body can be moved by a fraction of a displacement and touches an object, or leaves the world, soon after it.
     *
     * @param other the object, or {@link Claim#BORDER}
     */
    public Attempt blocked(GeometryObject body, int self, Point displacement, double fraction, int other) {
        Free free = free(body, self, displacement, fraction);
        List<Integer> touched = List.copyOf(free.touched);
        double step = 0;
        List<Piece> mine = Piece.of(body);
        // Each step costs an exact test, so that the contact may be told up to 16 times as late as the first that
        // shows.
        for (int k = -52; k <= -16; k += 4) {
            double at = Math.min(1, fraction + step);
            Contact contact = other == Claim.BORDER ? null : contact(body, mine, other, displacement, at);
            if (contact != null || (other == Claim.BORDER && leaves(body, displacement, at))) {
                Claim claim = new Claim.Blocked(body, self, displacement, fraction, at, other, touched);
                return free.attempt(claim, body, contact, 0);
            }
            step = Math.scalb(1.0, k);
        }
        return Attempt.failed(
                new Claim.Blocked(body, self, displacement, fraction, 1, other, touched),
                "no contact was found within 2^-20 of the displacement");
    }

    /** That a body can be turned about an axis through its centre; see {@link Claim.Turn}. */
    public Attempt turn(GeometryObject body, int self, Point axis, double tangent) {
        Point c = body.center();
        Course course = Course.turn(rows(body), vector(axis), vector(c), tangent);
        Free free = new Free(course, self, Claim.ALL, 0, course.isTurn());
        return free.attempt(new Claim.Turn(body, self, axis, tangent, List.copyOf(free.touched)), body, null, 0);
    }

    /**
     * What a ray hits first.
     *
     * @param distance as it was computed, or the range if nothing is hit
     * @param other    the object hit, or {@link Claim#ALL} if none
     */
    public Attempt ray(Point start, Point direction, int self, double distance, int other) {
        double[] way = {direction.x(), isFlat ? 0 : direction.y(), direction.z()};
        double length = Rows.length(way);
        double error = BRACKET * (distance + Math.abs(start.x()) + Math.abs(start.y()) + Math.abs(start.z()));
        double low = other == Claim.ALL ? distance : Math.max(0, distance - error);
        double high = other == Claim.ALL ? Double.POSITIVE_INFINITY : distance + error;
        double reach = low / length * (1 + 0x1p-50);
        Claim.Ray claim = new Claim.Ray(start, direction, self, low, high, other);
        if (low == Double.POSITIVE_INFINITY) {
            return Attempt.failed(claim, "a proof needs a finite range");
        }
        double most = other == Claim.ALL ? low : high;
        if (!(most / length <= LARGEST) || !(length >= SMALLEST)) {
            return Attempt.failed(claim, "the direction is too short for a proof, or the range too long");
        }
        double[] point = {start.x(), start.y(), start.z(), 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0};
        Course course = Course.along(new double[][] {point}, way, reach);
        Contact hit = other == Claim.ALL ? null : hit(claim, length);
        if (other != Claim.ALL && hit == null) {
            return Attempt.failed(claim, "the hit was not verified");
        }
        Free free = low > 0 ? new Free(course, self, Claim.ALL, 0, course.isTurn()) : new Free(course);
        return free.attempt(claim, null, hit, reach);
    }

    /**
     * What is nearest in a cone.
     *
     * @param cosine   of half its opening angle
     * @param distance as it was computed, or the range if nothing is detected
     * @param other    the object with the nearest point, or {@link Claim#ALL} if only that nothing is nearer is to be proved
     */
    public Attempt cone(Point start, Point direction, double cosine, int self, double distance, int other) {
        double[] way = {direction.x(), isFlat ? 0 : direction.y(), direction.z()};
        double size = distance + Math.abs(start.x()) + Math.abs(start.y()) + Math.abs(start.z());
        Attempt attempt = cone(
                new Claim.Cone(start, direction, cosine, self, distance, distance, other), way, 4 * BRACKET * size);
        return attempt.isProved()
                ? attempt
                : cone(
                        new Claim.Cone(start, direction, cosine, self, distance, distance, other),
                        way,
                        WIDE_BRACKET * size);
    }

    private Attempt cone(Claim.Cone c, double[] way, double error) {
        double low = Math.max(0, c.low() - error);
        Claim.Cone claim = new Claim.Cone(
                c.start(), c.direction(), c.cosine(), c.self(), low, Double.POSITIVE_INFINITY, c.other());
        if (low == Double.POSITIVE_INFINITY) {
            return Attempt.failed(claim, "a proof needs a finite range");
        }
        Course course = Course.cone(vector(c.start()), way, c.cosine(), low);
        Free free = low > 0 ? new Free(course, c.self(), Claim.ALL, 0, false) : new Free(course);
        return free.attempt(claim, null, null, 0);
    }

    /**
     * How far a body is from an object, or from the nearest one but {@code self}.
     *
     * @param low  not above the distance
     * @param high not below it
     */
    public Attempt distance(GeometryObject body, int self, int other, double low, double high) {
        Claim claim = new Claim.Distance(body, self, other, low, high);
        Contact near = high == Double.POSITIVE_INFINITY
                ? null
                : new NearSearch(rows, isFlat, betweenParts).find(rows(body), self, other, high);
        if (near == null && high < Double.POSITIVE_INFINITY) {
            return Attempt.failed(claim, "no two points were found that are so near");
        }
        Course course = Course.along(rows(body), new double[3], 0);
        Free free = low > 0 ? new Free(course, self, other, low, false) : new Free(course);
        return free.attempt(claim, low > 0 ? body : null, near, 0);
    }

    private Free free(GeometryObject body, int self, Point displacement, double fraction) {
        double[] way = {displacement.x(), isFlat ? 0 : displacement.y(), displacement.z()};
        return new Free(Course.along(rows(body), way, fraction), self, Claim.ALL, 0, true);
    }

    private static double[][] rows(GeometryObject body) {
        return Piece.stored(body).toArray(double[][]::new);
    }

    private static double[] vector(Point p) {
        return new double[] {p.x(), p.y(), p.z()};
    }

    private @Nullable Contact contact(GeometryObject body, List<Piece> mine, int other, Point way, double at) {
        double[] d = {at * way.x(), at * way.y(), at * way.z()};
        double[] bounds = new double[6];
        for (int i = 0; i < mine.size(); i++) {
            Rows.bounds(ContactSearch.moved(mine.get(i).stored, d), bounds, 0);
            for (int j = rows.first[other]; j < rows.first[other + 1]; j++) {
                betweenParts.run();
                if (isNear(bounds, j)) {
                    Contact found = contacts.find(i, mine.get(i), j, rows.exact(j), way, at, isFlat);
                    if (found != null) {
                        return found;
                    }
                }
            }
        }
        return isFlat ? null : inside(body, mine, other, d);
    }

    private boolean isNear(double[] bounds, int j) {
        for (int axis = 0; axis < 3; axis++) {
            if (!(isFlat && axis == 1)
                    && (bounds[axis] > rows.bounds[6 * j + 3 + axis] || bounds[3 + axis] < rows.bounds[6 * j + axis])) {
                return false;
            }
        }
        return true;
    }

    private @Nullable Contact inside(GeometryObject body, List<Piece> mine, int other, double[] d) {
        for (int[] solid : ScenePieces.solids(scene.objects().get(other), rows.first[other])) {
            for (int i = 0; i < mine.size(); i++) {
                Vec start = mine.get(i).c.plus(Vec.of(d[0], d[1], d[2]));
                Point ray = outsides().direction(start, rows.exact(solid), 1);
                if (ray != null) {
                    return new Contact(i, solid[0], Form.INSIDE, List.of(), ray, List.of());
                }
            }
        }
        for (int[] solid : ScenePieces.solids(body, 0)) {
            for (int j = rows.first[other]; j < rows.first[other + 1]; j++) {
                Vec start = rows.exact(j).c.minus(Vec.of(d[0], d[1], d[2]));
                Point ray = outsides().direction(start, mine.subList(solid[0], solid[1]), 1);
                if (ray != null) {
                    return new Contact(solid[0], j, Form.CONTAINS, List.of(), ray, List.of());
                }
            }
        }
        return null;
    }

    private Outsides outsides() {
        return new Outsides(rows, betweenParts);
    }

    private boolean leaves(GeometryObject body, Point displacement, double at) {
        Claim claim = new Claim.Blocked(body, Claim.ALL, displacement, 0, at, Claim.BORDER, List.of());
        Witness none = new Witness(List.of(), List.of(), null, List.of(), 0);
        Scene empty = new Scene(List.of(), scene.dimension(), scene.size());
        // Where it starts outside, freedom fails, which is checked elsewhere.
        return new ProofChecker(empty).check(new Proof(claim, none)).isValid();
    }

    private @Nullable Contact hit(Claim.Ray claim, double length) {
        double to = claim.high() / length * (1 - 0x1p-50);
        Vec start = Vec.of(claim.start());
        Vec way = Vec.of(claim.direction());
        Vec far = start.plus((isFlat ? way.level() : way).times(Num.of(to)));
        double[] bounds = {
            Math.min(claim.start().x(), far.x().approximately()),
            Math.min(claim.start().y(), far.y().approximately()),
            Math.min(claim.start().z(), far.z().approximately()),
            Math.max(claim.start().x(), far.x().approximately()),
            Math.max(claim.start().y(), far.y().approximately()),
            Math.max(claim.start().z(), far.z().approximately())
        };
        for (int k = 0; k < 3; k++) {
            bounds[k] -= 1e-9 * Math.abs(bounds[k]);
            bounds[3 + k] += 1e-9 * Math.abs(bounds[3 + k]);
        }
        for (int j = rows.first[claim.other()]; j < rows.first[claim.other() + 1]; j++) {
            betweenParts.run();
            Piece piece = isNear(bounds, j) ? isFlat ? rows.exact(j).flat() : rows.exact(j) : null;
            if (piece != null && piece.meets(isFlat ? start.level() : start, isFlat ? far.level() : far, Num.ZERO)) {
                return new Contact(0, j, Form.POINT, List.of(), new Point(to, 0, 0), List.of());
            }
        }
        for (int[] solid : isFlat
                ? List.<int[]>of()
                : ScenePieces.solids(scene.objects().get(claim.other()), rows.first[claim.other()])) {
            Point ray = claim.low() == 0 ? outsides().direction(start, rows.exact(solid), 1) : null;
            if (ray != null) {
                return new Contact(0, solid[0], Form.INSIDE, List.of(), ray, List.of());
            }
        }
        return null;
    }

    /** Planes for every pair of pieces that the checker does not see apart by itself. */
    private final class Free {
        private final Course course;
        private final int self;
        private final int other;

        /** Whether pieces that are touched at the start are only claimed not to be overlapped. */
        private final boolean mayTouch;

        private final List<Point> common = new ArrayList<>();
        private final List<double[]> directions = new ArrayList<>();
        private final List<Slab> slabs = new ArrayList<>();
        private final List<Witness.Outside> outsides = new ArrayList<>();
        final Set<Integer> touched = new TreeSet<>();
        private String failure = "";

        /** Where nothing needs to be free. */
        Free(Course course) {
            this.course = course;
            mayTouch = false;
            self = Claim.ALL;
            other = Claim.ALL;
        }

        Free(Course course, int self, int other, double margin, boolean mayTouch) {
            this.course = course;
            this.mayTouch = mayTouch;
            this.self = self;
            this.other = other;
            addCommon();
            SlabSearch search = new SlabSearch(rows, scene.dimension(), course, margin);
            double[] swept = new double[6 * course.rows.length];
            for (int i = 0; i < course.rows.length; i++) {
                bounds(i, swept, 6 * i);
                for (int object = 0; object < scene.objects().size() && failure.isEmpty(); object++) {
                    if (other == Claim.ALL ? object != self : object == other) {
                        pieces(search, i, object, margin, swept);
                    }
                }
            }
        }

        private void addCommon() {
            double length = Rows.length(course.way);
            if (course.isTurn() || course.cosine > 0 || course.end == 0 || length == 0) {
                return;
            }
            for (int axis = 0; axis < 3; axis++) {
                double[] e = {axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
                double[] n = Rows.unit(Rows.cross(course.way, e));
                boolean isAxis = Math.abs(n[0]) == 1 || Math.abs(n[1]) == 1 || Math.abs(n[2]) == 1;
                if (Rows.length(n) > 0 && !isAxis && (!isFlat || axis == 1)) {
                    directions.add(n);
                    directions.add(new double[] {-n[0], -n[1], -n[2]});
                    common.add(new Point(n[0], n[1], n[2]));
                    common.add(new Point(-n[0], -n[1], -n[2]));
                }
            }
        }

        private void bounds(int i, double[] swept, int at) {
            // Without a direction in the witness, the checker has no better bound for a turning disc.
            double disc = course.isTurn() && course.rows[i].length == 17 ? course.rows[i][15] : 0;
            double pad = Rows.ROUNDING * course.size(i) + disc;
            double[] n = new double[3];
            for (int k = 0; k < 3; k++) {
                n[k] = -1;
                swept[at + k] = -course.top(i, n, 0, course.end) - pad;
                n[k] = 1;
                swept[at + 3 + k] = course.top(i, n, 0, course.end) + pad;
                n[k] = 0;
            }
        }

        private void pieces(SlabSearch search, int i, int object, double margin, double[] swept) {
            for (int j = rows.first[object]; j < rows.first[object + 1] && failure.isEmpty(); j++) {
                betweenParts.run();
                if (isClear(i, j, margin, swept) || search.find(i, j, false, slabs)) {
                    continue;
                }
                boolean isTouched = mayTouch
                        && contacts.find(i, new Piece(course.rows[i]), j, rows.exact(j), new Point(), 0, isFlat) != null
                        && search.find(i, j, true, slabs);
                if (isTouched) {
                    touched.add(j);
                } else {
                    failure = "no plane was found between piece " + i + " of the body and piece " + j + " of object "
                            + object;
                }
            }
        }

        /** Whether the axes or the common directions are enough. */
        private boolean isClear(int i, int j, double margin, double[] swept) {
            double spare = margin * (1 + 0x1p-50);
            for (int axis = 0; axis < 3; axis++) {
                boolean isLevel = !isFlat || axis != 1;
                if (isLevel
                        && (swept[6 * i + axis] > rows.bounds[6 * j + 3 + axis] + spare
                                || swept[6 * i + 3 + axis] + spare < rows.bounds[6 * j + axis])) {
                    return true;
                }
            }
            double error = Rows.ROUNDING * (course.size(i) + Rows.size(rows.rows[j]));
            for (double[] n : directions) {
                double[] back = {-n[0], -n[1], -n[2]};
                if (-Rows.most(rows.rows[j], back) - course.top(i, n, 0, course.end) > spare + error) {
                    return true;
                }
            }
            return false;
        }

        private boolean isWithin(Point size) {
            double[] swept = new double[6];
            double[] half = {size.x() / 2, size.y() / 2, size.z() / 2};
            for (int i = 0; i < course.rows.length; i++) {
                bounds(i, swept, 0);
                for (int axis = 0; axis < 3; axis++) {
                    boolean isSure =
                            (swept[axis] >= -half[axis] && swept[3 + axis] <= half[axis]) || (isFlat && axis == 1);
                    if (!isSure) {
                        Scene empty = new Scene(List.of(), scene.dimension(), size);
                        return Separation.isWithin(new ScenePieces(empty), course.exact(), size);
                    }
                }
            }
            return true;
        }

        Attempt attempt(Claim claim, @Nullable GeometryObject body, @Nullable Contact contact, double reach) {
            if (failure.isEmpty() && !isFlat && course.end + (body == null ? 0 : 1) > 0) {
                failure = outsides().add(course, body, self, other, outsides);
            }
            Point size = scene.size();
            if (failure.isEmpty() && body != null && other == Claim.ALL && size != null && !isWithin(size)) {
                failure = "the body may leave the world";
            }
            return failure.isEmpty()
                    ? Attempt.of(claim, new Witness(common, slabs, contact, outsides, reach))
                    : Attempt.failed(claim, failure);
        }
    }
}
