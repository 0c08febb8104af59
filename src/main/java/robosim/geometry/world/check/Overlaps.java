package robosim.geometry.world.check;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.WorkLimit;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.Contact;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.Verdict;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.QuadTree;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/**
 * The pairs of a world's objects that are in contact, in the order of the objects.
 *
 * <p>Of n objects in one place there are n^2 / 2 pairs, so not all are looked at. Pairs of static objects are counted up to a
 * limit. A moveable object that has been found in enough contacts is full, and is compared only with those that are not: a
 * world without full ones has all of its pairs.
 */
final class Overlaps {
    /** A penetration depth below this fraction of the smaller object counts as touching. */
    private static final double TOUCH = 0x1p-30;

    /** Number of bisections of a depth that is known to within a factor of two. */
    private static final int HALVINGS = 7;

    /** Steps of a question whether two objects touch, after which it is asked again with more: so it can be cancelled. */
    private static final long STEPS = 1 << 14;

    /** Number of objects near a moveable one that are compared before it is asked whether it is full. */
    private static final int CHUNK = 1024;

    /** Number of contacts of moveable objects after which one contact of each is enough. */
    private static final int MANY_STARTS = 2_000;

    /** Number of contacts around which it is counted how many objects lie in one place. */
    private static final int PILES = 16;

    private final List<WorldObject> objects;
    private final List<Bounds> bounds;
    private final Dimension dimension;
    private final WorkLimit meter;
    private final List<Overlap> found = new ArrayList<>();
    private final QuadTree fixed;

    /** The moveable objects so far that are not full, and those that are. */
    private final QuadTree open;

    private final QuadTree full;
    private final QuadCursor fixedCursor;
    private final QuadCursor openCursor;
    private final QuadCursor fullCursor;

    /** By object, the number of its contacts that were found, and of those that hinder it. */
    private final int[] contacts;

    private final int[] hindered;
    private final List<Integer> near = new ArrayList<>();
    private int starts;
    private int staticCount;
    private long compared;
    private @Nullable Pile pile;

    Overlaps(World world, CheckProgress watch, WorkLimit meter) {
        objects = world.objects();
        dimension = world.dimension();
        this.meter = meter;
        bounds = objects.stream().map(o -> o.object().bounds()).toList();
        fixed = tree(world);
        open = tree(world);
        full = tree(world);
        fixedCursor = fixed.cursor();
        openCursor = open.cursor();
        fullCursor = full.cursor();
        contacts = new int[objects.size()];
        hindered = new int[objects.size()];
        for (int k = 0; k < objects.size(); k++) {
            watch.at("overlaps", k, objects.size());
            if (objects.get(k).object().isMoveable()) {
                moveable(k);
            } else {
                fixed(k);
            }
        }
        if (full.size() > 0 || staticCount >= WorldCheck.MOST_COUNTED) {
            pile = largestPile();
        }
    }

    private void fixed(int k) {
        near.clear();
        if (staticCount < WorldCheck.MOST_COUNTED) {
            start(fixedCursor, k);
            collect(fixedCursor, Integer.MAX_VALUE);
        }
        start(openCursor, k);
        collect(openCursor, Integer.MAX_VALUE);
        compareNear(k);
        add(fixed, k);
    }

    private void moveable(int k) {
        near.clear();
        start(fixedCursor, k);
        while (collect(fixedCursor, CHUNK) && !isFull(k)) {
            compareNear(k);
        }
        start(openCursor, k);
        collect(openCursor, Integer.MAX_VALUE);
        compareNear(k);
        start(fullCursor, k);
        while (!isFull(k) && collect(fullCursor, CHUNK)) {
            compareNear(k);
        }
        compareNear(k);
        add(isFull(k) ? full : open, k);
    }

    private void add(QuadTree tree, int k) {
        Bounds e = bounds.get(k);
        tree.add(k, e.minX(), e.minZ(), e.maxX(), e.maxZ());
    }

    private void start(QuadCursor cursor, int k) {
        Bounds e = bounds.get(k);
        cursor.startBox(e.minX(), e.minZ(), e.maxX(), e.maxZ());
    }

    /** Adds to the objects that are near until there are so many; returns false if there are no more. */
    private boolean collect(QuadCursor cursor, int most) {
        while (near.size() < most) {
            int other = cursor.next();
            if (other < 0) {
                return false;
            }
            near.add(other);
        }
        return true;
    }

    private void compareNear(int k) {
        near.sort(null);
        meter.take(near.size());
        Bounds e = bounds.get(k);
        for (int other : near) {
            if (dimension == Dimension.PLANAR || haveCommonHeight(e, bounds.get(other))) {
                compare(other, k, Math.min(e.size(), bounds.get(other).size()));
            }
        }
        near.clear();
    }

    /** Whether a moveable object has been found in enough contacts. */
    private boolean isFull(int k) {
        int most = starts < MANY_STARTS ? WorldCheck.MAX_STARTING_CONTACTS : 1;
        return hindered[k] >= most || contacts[k] >= CHUNK;
    }

    /** Whether nothing would follow from another contact of two objects. */
    private boolean isEnough(int a, int b) {
        boolean isMovingA = objects.get(a).object().isMoveable();
        boolean isMovingB = objects.get(b).object().isMoveable();
        return (isMovingA || isMovingB) && (!isMovingA || isFull(a)) && (!isMovingB || isFull(b));
    }

    private void count(int k, boolean hinders) {
        contacts[k]++;
        hindered[k] += hinders ? 1 : 0;
        if (isFull(k) && open.contains(k)) {
            open.remove(k);
            add(full, k);
        }
    }

    /** The place where most objects were found. */
    private @Nullable Pile largestPile() {
        Pile largest = null;
        for (int k = 0; k < PILES; k++) {
            Point at = found.get((int) ((long) k * found.size() / PILES)).contact();
            int count = countAt(at);
            largest = largest == null || count > largest.objects() ? new Pile(at, count) : largest;
        }
        return largest;
    }

    /** How many objects contain a point. */
    private int countAt(Point at) {
        SphereObject point = new SphereObject(at, 0);
        int count = 0;
        for (QuadCursor cursor : List.of(fixedCursor, openCursor, fullCursor)) {
            cursor.startBox(at.x(), at.z(), at.x(), at.z());
            for (int k = cursor.next(); k >= 0; k = cursor.next()) {
                count += touches(objects.get(k).object(), point) ? 1 : 0;
            }
        }
        return count;
    }

    /** The place with the most objects, if not all pairs were looked at. */
    @Nullable
    Pile pile() {
        return pile;
    }

    /** How many pairs were looked at. */
    long compared() {
        return compared;
    }

    private static QuadTree tree(World world) {
        return new QuadTree(-world.width() / 2, -world.length() / 2, world.width() / 2, world.length() / 2);
    }

    private static boolean haveCommonHeight(Bounds a, Bounds b) {
        return a.minY() <= b.maxY() && b.minY() <= a.maxY();
    }

    /** All overlaps with a moveable object that is not full, and those of two static objects up to the limit. */
    List<Overlap> found() {
        return found;
    }

    int staticCount() {
        return staticCount;
    }

    private void compare(int earlier, int later, double size) {
        boolean isSwapped = objects.get(later).object().isMoveable()
                && !objects.get(earlier).object().isMoveable();
        WorldObject first = objects.get(isSwapped ? later : earlier);
        WorldObject second = objects.get(isSwapped ? earlier : later);
        boolean isStatic = !first.object().isMoveable();
        if ((isStatic && staticCount >= WorldCheck.MOST_COUNTED) || isEnough(earlier, later)) {
            return;
        }
        compared++;
        if (isStatic && staticCount >= WorldCheck.MAX_STATIC_OVERLAPS) {
            staticCount += touches(first.object(), second.object()) ? 1 : 0;
            return;
        }
        if (!touches(first.object(), second.object())) {
            return;
        }
        List<Contact> contact = ContactQuery.contacts(first.object(), second.object(), dimension, 1);
        if (contact.isEmpty()) {
            return;
        }
        Contact at = contact.get(0);
        double depth = depth(first.object(), second.object(), at.normal(), size);
        Overlap overlap = new Overlap(first, second, at.point(), at.normal(), depth);
        found.add(overlap);
        if (isStatic) {
            staticCount++;
            return;
        }
        boolean hinders = !FloorSupport.isStanding(overlap);
        starts += hinders ? 1 : 0;
        for (int k : new int[] {earlier, later}) {
            if (objects.get(k).object().isMoveable()) {
                count(k, hinders);
            }
        }
    }

    private boolean touches(GeometryObject a, GeometryObject b) {
        Verdict verdict = null;
        for (long steps = STEPS; verdict == null || verdict.answer() == Verdict.Answer.UNDECIDED; steps *= 4) {
            verdict = ContactQuery.decide(a, b, dimension, Budget.steps(steps));
            meter.take(verdict.steps());
        }
        return verdict.answer() == Verdict.Answer.YES;
    }

    /** How far the first must move along the normal until it is clear of the second. */
    private double depth(GeometryObject first, GeometryObject second, Point normal, double size) {
        double reach = TOUCH * (size > 0 ? size : 1);
        if (isClear(first, second, normal, reach)) {
            return 0;
        }
        double least = reach;
        double most = 2 * (first.bounds().size() + second.bounds().size()) + reach;
        while (!isClear(first, second, normal, 2 * least)) {
            least *= 2;
            if (least > most) {
                return Double.POSITIVE_INFINITY;
            }
        }
        double clear = 2 * least;
        for (int k = 0; k < HALVINGS; k++) {
            double middle = (least + clear) / 2;
            if (isClear(first, second, normal, middle)) {
                clear = middle;
            } else {
                least = middle;
            }
        }
        return clear;
    }

    private boolean isClear(GeometryObject first, GeometryObject second, Point n, double way) {
        Point c = first.center();
        @Nullable GeometryObject moved;
        try {
            moved = first.movedTo(new Point(c.x() + way * n.x(), c.y() + way * n.y(), c.z() + way * n.z()));
        } catch (IllegalArgumentException beyondAllCoordinates) {
            return false;
        }
        return !touches(moved, second);
    }
}
