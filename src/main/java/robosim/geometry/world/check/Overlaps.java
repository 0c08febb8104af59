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
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** The pairs of a world's objects that are in contact, in the order of the objects. */
final class Overlaps {
    /** A penetration depth below this fraction of the smaller object counts as touching. */
    private static final double TOUCH = 0x1p-30;

    /** Number of bisections of a depth that is known to within a factor of two. */
    private static final int HALVINGS = 7;

    /** Steps of a question whether two objects touch, after which it is asked again with more: so it can be cancelled. */
    private static final long STEPS = 1 << 14;

    private final List<WorldObject> objects;
    private final Dimension dimension;
    private final WorkLimit.Meter meter;
    private final List<Overlap> found = new ArrayList<>();
    private int staticCount;

    Overlaps(World world, Watch watch, WorkLimit.Meter meter) {
        objects = world.objects();
        dimension = world.dimension();
        this.meter = meter;
        List<Bounds> bounds = objects.stream().map(o -> o.object().bounds()).toList();
        // Apart, as of static objects not all pairs need be looked at: of n that lie in one place there are n^2 / 2.
        QuadTree fixed = tree(world);
        QuadTree moving = tree(world);
        QuadCursor fixedCursor = fixed.cursor();
        QuadCursor movingCursor = moving.cursor();
        for (int k = 0; k < objects.size(); k++) {
            watch.at("overlaps", k, objects.size());
            Bounds e = bounds.get(k);
            boolean isMoving = objects.get(k).object().isMoveable();
            List<Integer> near = new ArrayList<>();
            if (isMoving || staticCount < WorldCheck.MOST_COUNTED) {
                near(fixedCursor, e, near);
            }
            near(movingCursor, e, near);
            near.sort(null);
            meter.take(near.size());
            for (int other : near) {
                boolean level = dimension == Dimension.PLANAR || haveCommonHeight(e, bounds.get(other));
                if (level) {
                    compare(
                            objects.get(other),
                            objects.get(k),
                            Math.min(e.size(), bounds.get(other).size()));
                }
            }
            (isMoving ? moving : fixed).add(k, e.minX(), e.minZ(), e.maxX(), e.maxZ());
        }
    }

    private static QuadTree tree(World world) {
        return new QuadTree(-world.width() / 2, -world.length() / 2, world.width() / 2, world.length() / 2);
    }

    private static void near(QuadCursor cursor, Bounds e, List<Integer> near) {
        cursor.startBox(e.minX(), e.minZ(), e.maxX(), e.maxZ());
        for (int other = cursor.next(); other >= 0; other = cursor.next()) {
            near.add(other);
        }
    }

    private static boolean haveCommonHeight(Bounds a, Bounds b) {
        return a.minY() <= b.maxY() && b.minY() <= a.maxY();
    }

    /** All overlaps with a moveable object, and those of two static objects up to the limit. */
    List<Overlap> found() {
        return found;
    }

    int staticCount() {
        return staticCount;
    }

    private void compare(WorldObject earlier, WorldObject later, double size) {
        boolean moves = later.object().isMoveable() && !earlier.object().isMoveable();
        WorldObject first = moves ? later : earlier;
        WorldObject second = moves ? earlier : later;
        boolean fixed = !first.object().isMoveable();
        if (fixed && staticCount >= WorldCheck.MOST_COUNTED) {
            return;
        }
        if (fixed && staticCount >= WorldCheck.MAX_STATIC_OVERLAPS) {
            staticCount += touches(first.object(), second.object()) ? 1 : 0;
            return;
        }
        if (!touches(first.object(), second.object())) {
            return;
        }
        List<Contact> contacts = ContactQuery.contacts(first.object(), second.object(), dimension, 1);
        if (contacts.isEmpty()) {
            return;
        }
        staticCount += fixed ? 1 : 0;
        Contact contact = contacts.get(0);
        found.add(new Overlap(
                first,
                second,
                contact.point(),
                contact.normal(),
                depth(first.object(), second.object(), contact.normal(), size)));
    }

    private boolean touches(GeometryObject a, GeometryObject b) {
        Verdict verdict = null;
        for (long steps = STEPS; verdict == null || verdict.answer() == Verdict.Answer.UNDECIDED; steps *= 4) {
            verdict = ContactQuery.ask(a, b, dimension, Budget.steps(steps));
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
