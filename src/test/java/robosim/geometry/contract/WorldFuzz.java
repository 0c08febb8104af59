package robosim.geometry.contract;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.RayHit;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SenseBuffer.Extra;
import robosim.geometry.WorldQueries;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.contract.PlainList.Free;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;

/**
 * Random questions and changes, asked of a world and of a {@link PlainList} of its objects. Each answer of the world must be
 * the list's, to the bit.
 */
final class WorldFuzz {
    private static final double INFINITE = Double.POSITIVE_INFINITY;
    private static final Accuracy[] LEVELS = Accuracy.values();

    /** So many operations are done in one world at most. */
    static final int LIFE = 250;

    private final WorldLayout layout;
    private final Dimension dimension;
    private final Accuracy accuracy;

    final List<String> divergences = new ArrayList<>();
    long operations;
    long hits;
    long refusals;
    long moves;

    /** Moves that pass others for what they stand on. */
    long standing;

    /** Shares that were less than beside each other object alone, for the place as it is stored. */
    long takenBack;

    private SplittableRandom random;
    private Geometry world;
    private PlainList list;
    private int named;

    /** A question or a change; what it finds wrong, or null. It may be asked again of fewer objects. */
    private interface Operation {
        @Nullable
        String carryOut(Geometry world, PlainList list);
    }

    WorldFuzz(WorldLayout layout, Dimension dimension, Accuracy accuracy) {
        this.layout = layout;
        this.dimension = dimension;
        this.accuracy = accuracy;
        random = new SplittableRandom(0);
        world = world();
        list = list();
    }

    private Geometry world() {
        return new Geometry(layout.extent(), layout.extent(), layout.extent(), dimension, accuracy);
    }

    private PlainList list() {
        return new PlainList(layout.extent(), dimension, accuracy);
    }

    /** Lets go of the worlds, each of which has working memory of its own. */
    void forget() {
        world = world();
        list = list();
    }

    /** The life of one world, of so many operations at most; it begins from a seed of its own, so that it can be had again. */
    void live(long seed, int most) {
        random = new SplittableRandom(seed * 1_000_003 + layout.ordinal());
        world = world();
        list.clear();
        named = 0;
        for (GeometryObject object : layout.ground(random)) {
            begin(object.named("ground " + named++));
        }
        for (int k = layout.count(); k > 0; k--) {
            begin(next());
        }
        for (int k = 0; k < Math.min(LIFE, most); k++) {
            List<GeometryObject> before = List.copyOf(list.objects());
            Operation operation = next(random.nextInt(20));
            String wrong = operation.carryOut(world, list);
            operations++;
            if (wrong != null) {
                divergences.add("%s %s %s, seed %d, operation %d: %s%s"
                        .formatted(layout, dimension, accuracy, seed, k, wrong, reduced(before, operation)));
                return; // what follows would be of two worlds
            }
        }
    }

    private void begin(GeometryObject object) {
        if (world.addObjectUnchecked(object)) {
            list.add(object);
        }
    }

    private GeometryObject next() {
        GeometryObject object = layout.next(random, list.objects());
        String name = "object " + named++;
        return layout.moveable(random) < 0.5 ? object.moveable(name) : object.named(name);
    }

    /** The least objects found of which the same is wrong, as they can be pasted into a test. */
    private String reduced(List<GeometryObject> objects, Operation operation) {
        if (wrong(objects, operation) == null) {
            return "\n  (not from the start)\n    " + Paste.of(objects);
        }
        List<GeometryObject> least = new ArrayList<>(objects);
        for (int k = least.size() - 1; k >= 0; k--) {
            GeometryObject without = least.remove(k);
            if (wrong(least, operation) == null) {
                least.add(k, without);
            }
        }
        return "\n  in the least world: " + wrong(least, operation) + "\n    " + Paste.of(least);
    }

    private @Nullable String wrong(List<GeometryObject> objects, Operation operation) {
        Geometry fresh = world();
        PlainList each = list();
        for (GeometryObject object : objects) {
            if (!fresh.addObjectUnchecked(object)) {
                return null;
            }
            each.add(object);
        }
        try {
            return operation.carryOut(fresh, each);
        } catch (IllegalArgumentException e) {
            return null; // one that it asks about is no longer there
        }
    }

    private Operation next(int kind) {
        return switch (kind) {
            case 0 -> add(next(), true);
            case 1 -> add(next(), false);
            case 2 -> remove();
            case 3, 4 -> test(next(), LEVELS[random.nextInt(LEVELS.length)]);
            case 5 -> ray(0);
            case 6 -> ray(random.nextDouble(random.nextBoolean() ? 10 : 179));
            case 7 -> random.nextInt(3) == 0 ? rays() : cast();
            case 8 -> proximity();
            case 9 -> random.nextInt(20) == 0 ? snapshot() : random.nextInt(8) == 0 ? reordered() : ignoring();
            default -> ofMover(kind);
        };
    }

    private Operation ofMover(int kind) {
        String name = mover();
        if (name == null) {
            return add(layout.next(random, list.objects()).moveable("mover " + named++), false);
        }
        Move move = move();
        double clearance = random.nextInt(3) * 0.125;
        double x = layout.step(random);
        double z = layout.step(random);
        double degrees = degrees();
        Point to = layout.place(random);
        return switch (kind) {
            case 10 -> scan(name);
            case 11 -> sonar(name);
            case 12 -> place(name, to, degrees);
            case 13, 14 ->
                quick(
                        "simpleMove %s %s".formatted(x, z),
                        name,
                        new Move(x, 0, z, 0, 0),
                        (w, n) -> Free.of(w.simpleMove(n, x, 0, z), w.getObject(n)),
                        (w, n) -> Free.of(w.move(n, new Move(x, 0, z, 0, 0)), w.getObject(n)));
            case 15 ->
                quick(
                        "simpleTurn " + degrees,
                        name,
                        new Move(),
                        (w, n) -> Free.of(w.simpleTurn(n, degrees), w.getObject(n)),
                        (w, n) -> Free.of(w.moveGlobal(n, new Move(0, 0, 0, 0, degrees)), w.getObject(n)));
            case 16, 17 -> motion("move " + move, name, 0, move, (w, n) -> Free.of(w.move(n, move), w.getObject(n)));
            case 18 -> global(move, name, (w, n) -> Free.of(w.moveGlobal(n, move), w.getObject(n)));
            default ->
                motion(
                        "contact " + clearance + " " + move,
                        name,
                        clearance,
                        move,
                        (w, n) -> Free.of(w.moveToContact(n, move, clearance), w.getObject(n)));
        };
    }

    private @Nullable String mover() {
        List<GeometryObject> movers =
                list.objects().stream().filter(GeometryObject::isMoveable).toList();
        return movers.isEmpty()
                ? null
                : movers.get(random.nextInt(movers.size())).name();
    }

    private String any() {
        return list.name(random.nextInt(list.objects().size()));
    }

    private static int find(PlainList list, String name) {
        for (int k = 0; k < list.objects().size(); k++) {
            if (list.name(k).equals(name)) {
                return k;
            }
        }
        throw new IllegalArgumentException("name must be in the list (got: " + name + ")");
    }

    private double degrees() {
        return switch (random.nextInt(4)) {
            case 0 -> 45 * random.nextInt(-8, 9);
            case 1 -> random.nextDouble(-3, 3);
            default -> random.nextDouble(-180, 180);
        };
    }

    private Move move() {
        boolean turns = random.nextBoolean();
        double ry = turns ? degrees() : 0;
        double rx = turns && random.nextInt(4) == 0 ? degrees() : 0;
        double y = random.nextInt(3) == 0 ? layout.step(random) / 4 : 0;
        boolean goes = !turns || random.nextBoolean();
        return new Move(goes ? layout.step(random) : 0, goes ? y : 0, goes ? layout.step(random) : 0, rx, ry);
    }

    private Ray line() {
        Point from = layout.place(random);
        Point to = layout.place(random);
        Point d = random.nextInt(3) == 0
                ? new Point(random.nextInt(-1, 2), random.nextInt(-1, 2), random.nextInt(-1, 2))
                : new Point(to.x() - from.x(), to.y() - from.y(), to.z() - from.z());
        return new Ray(from, d.x() == 0 && d.z() == 0 ? new Point(1, 0, 0) : d);
    }

    private double[] range() {
        double min = random.nextBoolean() ? 0 : random.nextDouble(2);
        return new double[] {min, random.nextBoolean() ? INFINITE : min + random.nextDouble(10)};
    }

    private static @Nullable String compare(String what, @Nullable Object answer, @Nullable Object truth) {
        return Objects.equals(answer, truth) ? null : what + " is " + answer + ", each alone " + truth;
    }

    private Operation add(GeometryObject object, boolean checked) {
        return (world, list) -> {
            boolean truth = list.fits(object) && !(checked && list.test(object, accuracy));
            boolean answer = checked ? world.addObject(object) : world.addObjectUnchecked(object);
            if (truth) {
                list.add(object);
            }
            return compare("adding " + Paste.of(object), answer, truth);
        };
    }

    private Operation remove() {
        if (list.objects().size() < layout.count() * 2 / 3) {
            return add(next(), false);
        }
        String name = any();
        return (world, list) -> {
            list.remove(find(list, name));
            return compare("removing " + name, world.removeObject(name), true);
        };
    }

    private Operation test(GeometryObject object, Accuracy at) {
        return (world, list) -> {
            String what = "test at " + at + " of " + Paste.of(object);
            BitSet touched = list.touched(object, at, -1);
            hits += touched.isEmpty() ? 0 : 1;
            String wrong = compare(what, world.testObject(object, at), !touched.isEmpty());
            for (int k = 0;
                    at == Accuracy.EXACT
                            && dimension == Dimension.SPATIAL
                            && wrong == null
                            && k < list.objects().size();
                    k++) {
                GeometryObject other = list.objects().get(k);
                boolean pair = list.isNear(object, other, 0) && CollisionDetection.intersects(object, other);
                wrong = compare("pair with " + list.name(k) + ", " + what, touched.get(k), pair);
            }
            return wrong;
        };
    }

    private Operation ray(double width) {
        Ray ray = line();
        double[] range = range();
        Accuracy at = LEVELS[random.nextInt(LEVELS.length)];
        return (world, list) -> compare(
                "%s from %s to %s, %s degrees, at %s".formatted(ray, range[0], range[1], width, at),
                world.getRayDistance(ray, range[0], range[1], width, at),
                list.ray(ray, range[0], range[1], width, at));
    }

    private Operation ignoring() {
        Ray ray = line();
        double width = random.nextBoolean() ? 0 : random.nextDouble(90);
        String but = any();
        return (world, list) -> compare(
                "%s, %s degrees, but %s".formatted(ray, width, but),
                world.getRayDistance(ray, 0, INFINITE, width, but),
                list.ray(ray, 0, INFINITE, width, find(list, but)));
    }

    private Operation cast() {
        Ray ray = line();
        double max = range()[1];
        return (world, list) -> {
            RayHit hit = world.castRay(ray, max);
            return compare("cast %s to %s".formatted(ray, max), hit, list.cast(ray, max));
        };
    }

    /** Many rays in one call, of the world or of a snapshot: what each hits, and whether it is free with one object ignored. */
    private Operation rays() {
        int count = random.nextInt(1, layout.count() > 50 ? 9 : 70);
        Ray[] lines = new Ray[count];
        double[] rays = new double[7 * count];
        for (int k = 0; k < count; k++) {
            Ray ray = line();
            lines[k] = ray;
            Point from = ray.start();
            Point way = ray.direction();
            double range = k % 4 == 0 ? INFINITE : k % 5 == 0 ? 0 : random.nextDouble(10);
            double[] numbers = {from.x(), from.y(), from.z(), way.x(), way.y(), way.z(), range};
            System.arraycopy(numbers, 0, rays, 7 * k, 7);
        }
        String but = any();
        boolean isCopy = random.nextBoolean();
        return (world, list) -> {
            WorldQueries asked = isCopy ? world.snapshot() : world;
            SenseBuffer out = new SenseBuffer(Extra.OBJECTS, Extra.NORMALS);
            long[] free = new long[count / 64 + 1];
            long[] ignoring = new long[count / 64 + 1];
            asked.castRays(rays, count, out);
            int found = asked.freeRays(rays, count, free);
            int others = asked.freeRays(rays, count, but, ignoring);
            BitSet isFree = BitSet.valueOf(free);
            BitSet isIgnored = BitSet.valueOf(ignoring);
            String wrong =
                    compare("free of rays", found + " " + others, isFree.cardinality() + " " + isIgnored.cardinality());
            for (int k = 0; k < count && wrong == null; k++) {
                double range = rays[7 * k + 6];
                RayHit hit = list.cast(lines[k], range);
                GeometryObject met = out.object(k);
                String answer = met == null
                        ? "nothing, " + isFree.get(k)
                        : out.distance(k) + " " + met.name() + " "
                                + new Point(out.normalX(k), out.normalY(k), out.normalZ(k)) + ", " + isFree.get(k);
                String truth = hit == null
                        ? "nothing, true"
                        : hit.distance() + " " + hit.object().name() + " " + hit.normal() + ", false";
                boolean passes = list.ray(lines[k], 0, range, 0, find(list, but)) == INFINITE;
                wrong = compare(
                        "%s to %s, but %s".formatted(lines[k], range, but),
                        answer + " " + isIgnored.get(k),
                        truth + " " + passes);
            }
            return wrong;
        };
    }

    private Operation proximity() {
        String name = any();
        double max = range()[1];
        return (world, list) -> compare(
                "proximity of %s to %s".formatted(name, max),
                world.getProximity(name, max),
                list.proximity(find(list, name), max));
    }

    private Operation snapshot() {
        return (world, list) -> {
            if (world == this.world) {
                this.world = world.snapshot().toGeometry();
            }
            return compare("objects of a snapshot", exactly(this.world.objects()), exactly(world.objects()));
        };
    }

    /** The same objects in another order: of what is met at once, another is the first from now on. */
    private Operation reordered() {
        long seed = random.nextLong();
        return (world, list) -> {
            if (world != this.world) {
                return null; // of fewer objects
            }
            list.shuffle(new SplittableRandom(seed));
            Geometry fresh = world();
            list.objects().forEach(fresh::addObjectUnchecked);
            this.world = fresh;
            return compare("objects in another order", exactly(fresh.objects()), exactly(list.objects()));
        };
    }

    private static List<String> exactly(List<GeometryObject> objects) {
        return objects.stream().map(Script::exactly).toList();
    }

    /** Whether it has no line of sight in the plane, once it is tipped. */
    private boolean isBlind(String name) {
        return dimension == Dimension.PLANAR && !world.getObject(name).pose().isUpright();
    }

    private Operation scan(String name) {
        if (isBlind(name)) {
            return proximity();
        }
        double first = degrees();
        double[] range = range();
        return (world, list) -> compare(
                "scan of %s from %s, %s".formatted(name, first, Arrays.toString(range)),
                Arrays.toString(world.scan(name, first, 24, 15, range[0], range[1])),
                Arrays.toString(list.scan(find(list, name), first, 24, 15, range[0], range[1])));
    }

    private Operation sonar(String name) {
        if (isBlind(name)) {
            return proximity();
        }
        Ray mount = new Ray(
                new Point(random.nextDouble(-1, 1), 0, random.nextDouble(-1, 1)),
                new Point(random.nextInt(-2, 3), 0, 1));
        double width = random.nextBoolean() ? 0 : random.nextDouble(120);
        double[] range = range();
        return (world, list) -> compare(
                "sonar of %s: %s, %s degrees, %s".formatted(name, mount, width, Arrays.toString(range)),
                world.getSonarDistance(name, mount, range[0], range[1], width),
                list.sonar(find(list, name), mount, range[0], range[1], width));
    }

    private Operation place(String name, Point to, double heading) {
        return (world, list) -> {
            int own = find(list, name);
            GeometryObject there = list.objects().get(own).at(Pose.of(to, heading));
            boolean truth =
                    list.fits(there) && list.touched(there, accuracy, own).isEmpty();
            boolean answer = world.placeObject(name, to, heading);
            list.replace(own, world.getObject(name));
            return compare("placing %s at %s, %s".formatted(name, to, heading), answer, truth);
        };
    }

    /** A motion that is only answered yes or no: also as by the way that finds the contact too. */
    private Operation quick(String what, String name, Move move, PlainList.Motion quick, PlainList.Motion whole) {
        Operation alone = motion(what, name, 0, move, quick);
        return (world, list) -> {
            Free truth = whole.in(world.snapshot().toGeometry(), name);
            String wrong = alone.carryOut(world, list);
            return wrong != null
                    ? wrong
                    : compare(
                            what + " of " + name + ", as a move",
                            Script.exactly(world.getObject(name)),
                            Script.exactly(truth.end()));
        };
    }

    private Operation global(Move move, String name, PlainList.Motion motion) {
        Point way = new Point(move.x(), move.y(), move.z());
        return (world, list) -> motion(world, list, "global " + move, name, way, 0, motion, (w, n) -> {
            MoveResult result = w.moveGlobal(n, move);
            double share = result.fraction();
            w.moveGlobal(n, new Move(share * move.x(), share * move.y(), share * move.z(), 0, 0));
            if (share == 1) {
                w.moveToContact(n, new Move(0, 0, 0, move.rx(), move.ry()), 0);
            }
            return Free.of(result, w.getObject(n));
        });
    }

    private Operation motion(String what, String name, double clearance, Move move, PlainList.Motion motion) {
        return (world, list) -> motion(
                world,
                list,
                what,
                name,
                list.way(find(list, name), move),
                clearance,
                motion,
                (w, n) -> Free.of(w.moveToContact(n, move, clearance), w.getObject(n)));
    }

    private @Nullable String motion(
            Geometry world,
            PlainList list,
            String what,
            String name,
            Point way,
            double clearance,
            PlainList.Motion motion,
            PlainList.Motion docking) {
        int own = find(list, name);
        GeometryObject start = list.objects().get(own);
        BitSet before = list.touched(start, accuracy, own);
        Free truth = list.move(own, way, clearance, motion);
        Free answer = motion.in(world, name);
        if (list.equals() > 1) {
            truth = truth.withContactOf(answer); // of several objects the one whose normal opposes the motion most
        }
        moves++;
        refusals += answer.allowed() ? 0 : 1;
        GeometryObject end = world.getObject(name);
        BitSet after = list.touched(end, accuracy, own);
        list.replace(own, end);
        String wrong = compare(what + " of " + name, text(answer), text(truth));
        if (wrong != null && !isTakenBack(list, start, before, docking, answer, truth)) {
            BitSet ground = (BitSet) before.clone();
            ground.or(after);
            list.replace(own, start);
            ground.or(list.touched(list.after(start, way), accuracy, own));
            Free grounded = before.isEmpty() ? truth : list.moveBeside(ground, own, way, clearance, motion);
            list.replace(own, end);
            if (!text(answer).equals(text(grounded))) {
                return wrong + (before.isEmpty() ? "" : " from contact, " + text(grounded) + " beside that");
            }
            standing++;
        }
        after.andNot(before);
        if (!after.isEmpty() && before.isEmpty()) {
            return what + " of " + name + " touches anew: " + list.name(after.nextSetBit(0)) + " " + text(answer);
        }
        return null;
    }

    /**
     * Whether a share is less than the least of those beside each other object alone because the place there, as it is
     * stored, touches what the way itself passes.
     */
    private boolean isTakenBack(
            PlainList list, GeometryObject start, BitSet before, PlainList.Motion docking, Free answer, Free truth) {
        if (answer.allowed()
                || truth.allowed()
                || answer.fraction() > truth.fraction()
                || answer.turnFraction() > truth.turnFraction()
                || !Objects.equals(answer.obstacle(), truth.obstacle())) {
            return false;
        }
        GeometryObject blocks = truth.obstacle();
        int own = find(list, String.valueOf(start.name()));
        GeometryObject now = list.objects().get(own);
        list.replace(own, start);
        Free docked = list.beside(blocks == null ? null : blocks.name(), own, docking);
        list.replace(own, now);
        BitSet touched = list.touched(docked.end(), accuracy, own);
        touched.andNot(before);
        boolean is = docked.fraction() == truth.fraction()
                && docked.turnFraction() == truth.turnFraction()
                && (!touched.isEmpty() || !list.fits(docked.end()));
        takenBack += is ? 1 : 0;
        return is;
    }

    private static String text(Free free) {
        GeometryObject obstacle = free.obstacle();
        return free.allowed() + " " + free.fraction() + " " + free.turnFraction() + " "
                + (obstacle == null ? "nothing" : obstacle.name()) + " " + free.contact() + " " + free.normal() + " "
                + Script.exactly(free.end());
    }
}
