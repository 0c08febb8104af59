package robosim.geometry.net.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.ObjectSearch;
import robosim.geometry.SlideOptions;
import robosim.geometry.SlideResult;
import robosim.geometry.check.Text;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Twist;
import robosim.geometry.protocol.batch.ListedObject;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.Obstacle;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** Answers requests about the world's objects, and keeps what became of the last init. */
public final class WorldRequests {
    private static final WorldAnswer.Changed DONE = new WorldAnswer.Changed(true, null);

    private final List<WorldAnswer.LeftOut> leftOut = new ArrayList<>();
    private int characters;
    private int added;
    private final ObjectNumbers numbers = new ObjectNumbers();
    private final ProofTexts proofs = new ProofTexts();

    /** How many objects there are now, of groups their members. */
    private int present;

    private int presentBefore;

    /** Is told of a move that was tried. */
    @FunctionalInterface
    public interface Watcher {
        void tried(WorldRequest.Go request, MoveResult result);
    }

    /** A world begins, to which objects are added one by one. */
    public void begin(List<GeometryObject> objects) {
        leftOut.clear();
        characters = 0;
        added = 0;
        present = 0;
        numbers.begin(objects);
    }

    /** A world begins that has all these objects. */
    public void beginWith(List<GeometryObject> objects) {
        begin(objects);
        added = objects.size();
        present = count(objects);
    }

    /** How many objects these are, where a group counts as its members. */
    public static int count(List<? extends GeometryObject> objects) {
        int count = 0;
        for (GeometryObject object : objects) {
            count += object instanceof ObjectGroup group ? count(group.members()) : 1;
        }
        return count;
    }

    /** An object of an init was added. */
    public void added(GeometryObject object) {
        added++;
        present += count(List.of(object));
    }

    /** An object of an init was left out. */
    public void leftOut(int index, @Nullable String name, String reason) {
        characters += (name == null ? 0 : name.length()) + reason.length();
        String told = name == null ? "" : name;
        boolean isShort = characters <= WorldAnswer.MOST_CHARACTERS;
        numbers.leftOut(index);
        leftOut.add(new WorldAnswer.LeftOut(index, isShort ? told : "", isShort ? reason : ""));
    }

    /** Begins what may be taken back. */
    public void keep() {
        numbers.keep();
        presentBefore = present;
    }

    /**
     * Takes back what was added and removed since; the world itself does so too.
     *
     * @param moveable the names of all moveable objects, brought up to date
     */
    public void undo(Set<String> moveable) {
        present = presentBefore;
        numbers.undo(moveable);
    }

    /** How many objects the world has, of groups their members. */
    public int present() {
        return present;
    }

    /**
     * Answers a request.
     *
     * @param moveable the names of all moveable objects, kept up to date
     * @throws IllegalArgumentException if the world refuses it
     */
    public WorldAnswer answer(Geometry world, WorldRequest request, Set<String> moveable, Watcher watcher) {
        if (request instanceof WorldRequest.Describe) {
            return describe(world);
        }
        if (request instanceof WorldRequest.ListObjects list) {
            return list(world, list);
        }
        if (request instanceof WorldRequest.Locate locate) {
            return locate(world, locate.objectName());
        }
        if (request instanceof WorldRequest.Remove remove) {
            return remove(world, remove.objectName(), moveable);
        }
        if (request instanceof WorldRequest.Attach attach) {
            return attach(world, attach);
        }
        if (request instanceof WorldRequest.Detach detach) {
            world.detach(detach.objectName());
            renumber(world, detach.objectName());
            return DONE;
        }
        if (request instanceof WorldRequest.Place place) {
            return isPlaced(world, place) ? DONE : new WorldAnswer.Changed(false, first(world, place));
        }
        if (request instanceof WorldRequest.Add add) {
            return isAdded(world, add, moveable) ? DONE : new WorldAnswer.Changed(false, first(world, add));
        }
        if (request instanceof WorldRequest.Go go) {
            return went(go(world, go, watcher));
        }
        if (request instanceof WorldRequest.GoToContact go) {
            Move move = move(go.x(), go.y(), go.z(), go.rx(), go.ry());
            return identified(world.moveToContact(go.objectName(), move, go.clearance()));
        }
        if (request instanceof WorldRequest.Drive drive) {
            return identified(drive(world, drive));
        }
        if (request instanceof WorldRequest.DescribeScene) {
            return proofs.scene(world);
        }
        if (request instanceof WorldRequest.Prove asked) {
            return proofs.of(world, asked.request());
        }
        if (request instanceof WorldRequest.Separate free) {
            Point displacement = world.separate(free.objectName(), free.max());
            return displacement == null
                    ? new WorldAnswer.Changed(false, null)
                    : new WorldAnswer.Separated(displacement);
        }
        return request instanceof WorldRequest.GoAndSlide go
                ? slide(world, go)
                : identify(world, ((WorldRequest.Identify) request).request(), moveable, watcher);
    }

    private WorldAnswer describe(Geometry world) {
        return new WorldAnswer.Described(
                added,
                List.copyOf(leftOut),
                world.width(),
                world.height(),
                world.length(),
                world.dimension(),
                world.accuracy());
    }

    private WorldAnswer list(Geometry world, WorldRequest.ListObjects list) {
        List<ListedObject> listed = new ArrayList<>();
        int characters = 0;
        for (ObjectNumbers.Numbered each : numbers.page(world.objects(), list.first(), list.count() + 1)) {
            GeometryObject object = each.object();
            String name = Objects.requireNonNull(name(object));
            characters += name.length();
            if (listed.size() == list.count() || (characters > WorldAnswer.MOST_CHARACTERS && !listed.isEmpty())) {
                return new WorldAnswer.Listed(listed, each.number());
            }
            Bounds box = object.bounds();
            listed.add(new ListedObject(
                    each.number(),
                    name,
                    object.kind(),
                    object.center(),
                    Degrees.toRadians(object.heading()),
                    object.isMoveable(),
                    new Point(box.minX(), box.minY(), box.minZ()),
                    new Point(box.maxX(), box.maxY(), box.maxZ())));
        }
        return new WorldAnswer.Listed(listed, -1);
    }

    private static WorldAnswer locate(Geometry world, String name) {
        if (!world.hasObject(name)) {
            throw new IllegalArgumentException("no object " + Text.quoted(name));
        }
        Pose pose = world.getObject(name).pose();
        return new WorldAnswer.Located(pose.center(), new Numbers(pose.rotation()), Degrees.toRadians(pose.heading()));
    }

    private WorldAnswer remove(Geometry world, String name, Set<String> moveable) {
        GeometryObject object = world.hasObject(name) ? world.getObject(name) : null;
        int members = object == null ? 0 : count(List.of(ObjectGroup.withoutLoads(object)));
        boolean isRemoved = world.removeObject(name);
        if (isRemoved) {
            if (object instanceof ObjectGroup group) {
                group.loads().forEach(load -> renumber(world, String.valueOf(load.name())));
            }
            numbers.removed(name, moveable.remove(name));
            present -= members;
        }
        return new WorldAnswer.Changed(isRemoved, null);
    }

    private static WorldAnswer attach(Geometry world, WorldRequest.Attach attach) {
        String load = attach.objectName();
        Mount mount = attach.mount();
        if (mount == null) {
            world.attach(attach.carrier(), load);
            return DONE;
        }
        if (world.attach(attach.carrier(), load, mount.pose())) {
            return DONE;
        }
        Pose at = mount.pose().within(world.getObject(attach.carrier()).pose());
        GeometryObject held = world.getObject(load).at(at);
        ObjectSearch search = world.search();
        List<GeometryObject> touched = search.fits(held) ? search.touching(held) : List.of();
        Optional<GeometryObject> first = touched.stream()
                .filter(each -> !load.equals(each.name()) && !isWithin(each, attach.carrier()))
                .findFirst();
        return new WorldAnswer.Changed(false, name(first));
    }

    /** Whether an object of the world has a part of a name. */
    private static boolean isWithin(GeometryObject object, String name) {
        return name.equals(object.name())
                || (object instanceof ObjectGroup group
                        && group.loads().stream().anyMatch(load -> isWithin(load, name)));
    }

    /** An object that has been detached counts as added now. */
    private void renumber(Geometry world, String load) {
        numbers.removed(load, true);
        numbers.added(world.getObject(load));
    }

    private static boolean isPlaced(Geometry world, WorldRequest.Place place) {
        return world.placeObject(place.objectName(), place.center(), Degrees.toDegrees(place.heading()));
    }

    private boolean isAdded(Geometry world, WorldRequest.Add add, Set<String> moveable) {
        GeometryObject object = add.object();
        boolean isAdded = add.overlapping() ? world.addObjectUnchecked(object) : world.addObject(object);
        if (isAdded) {
            present += count(List.of(object));
            numbers.added(object);
            addMovers(object, moveable);
        }
        return isAdded;
    }

    /** Adds the names of an object that may be moved, and of what is attached to it. */
    public static void addMovers(GeometryObject object, Set<String> moveable) {
        String name = object.name();
        if (object.isMoveable() && name != null) {
            moveable.add(name);
        }
        if (object instanceof ObjectGroup group) {
            group.loads().forEach(load -> addMovers(load, moveable));
        }
    }

    private static MoveResult go(Geometry world, WorldRequest.Go go, Watcher watcher) {
        MoveResult result = world.move(go.objectName(), move(go.x(), go.y(), go.z(), go.rx(), go.ry()));
        watcher.tried(go, result);
        return result;
    }

    private static MoveResult drive(Geometry world, WorldRequest.Drive drive) {
        Twist twist = new Twist(drive.x(), drive.y(), drive.z(), Degrees.toDegrees(drive.ry()));
        Double clearance = drive.clearance();
        return clearance == null
                ? world.move(drive.objectName(), twist, drive.seconds())
                : world.moveToContact(drive.objectName(), twist, drive.seconds(), clearance);
    }

    private static Move move(double x, double y, double z, double rx, double ry) {
        return new Move(x, y, z, Degrees.toDegrees(rx), Degrees.toDegrees(ry));
    }

    private WorldAnswer slide(Geometry world, WorldRequest.GoAndSlide go) {
        Move move = move(go.x(), go.y(), go.z(), go.rx(), go.ry());
        SlideResult result = world.moveAndSlide(go.objectName(), move, options(go));
        List<WorldAnswer.Contact> contacts = new ArrayList<>(result.contacts().size());
        for (SlideResult.SlideContact contact : result.contacts()) {
            GeometryObject met = contact.obstacle();
            contacts.add(
                    new WorldAnswer.Contact(met == null ? null : obstacle(met), contact.point(), contact.normal()));
        }
        return new WorldAnswer.Slid(result.made(), result.length(), result.left(), result.turnFraction(), contacts);
    }

    private static SlideOptions options(WorldRequest.GoAndSlide go) {
        WorldRequest.Walk walk = go.walk() == null ? WorldRequest.Walk.NONE : go.walk();
        double maxSlope = Degrees.toDegrees(walk.maxSlope());
        return new SlideOptions(go.clearance(), go.bends(), walk.stepHeight(), maxSlope, walk.snap());
    }

    private WorldAnswer identify(Geometry world, WorldRequest request, Set<String> moveable, Watcher watcher) {
        if (request instanceof WorldRequest.Place place) {
            return isPlaced(world, place)
                    ? new WorldAnswer.Identified(DONE, List.of())
                    : identified(inTheWay(world.search(), place));
        }
        if (request instanceof WorldRequest.Add add) {
            return isAdded(world, add, moveable)
                    ? new WorldAnswer.Identified(DONE, List.of())
                    : identified(inTheWay(world.search(), add));
        }
        return identified(go(world, (WorldRequest.Go) request, watcher));
    }

    /** The answer to a change that is not made, with what is in the way. */
    private WorldAnswer identified(List<GeometryObject> inTheWay) {
        List<Obstacle> obstacles = new ArrayList<>();
        for (int k = 0; k < Math.min(inTheWay.size(), WorldAnswer.Identified.MOST_OBSTACLES); k++) {
            obstacles.add(obstacle(inTheWay.get(k)));
        }
        String first = obstacles.isEmpty() ? null : obstacles.get(0).name();
        return new WorldAnswer.Identified(new WorldAnswer.Changed(false, first), obstacles);
    }

    private WorldAnswer identified(MoveResult result) {
        GeometryObject obstacle = result.obstacle();
        return new WorldAnswer.Identified(went(result), obstacle == null ? List.of() : List.of(obstacle(obstacle)));
    }

    private static WorldAnswer.Went went(MoveResult result) {
        return result.allowed()
                ? WorldAnswer.Went.MADE
                : new WorldAnswer.Went(
                        false,
                        result.fraction(),
                        result.turnFraction(),
                        name(result.obstacle()),
                        result.contact(),
                        result.normal());
    }

    private Obstacle obstacle(GeometryObject object) {
        return new Obstacle(numbers.of(object), Objects.requireNonNull(name(object)), object.kind(), object.center());
    }

    private static List<GeometryObject> inTheWay(ObjectSearch search, WorldRequest.Place place) {
        double heading = Degrees.toDegrees(place.heading());
        return search.fits(place.objectName(), place.center(), heading)
                ? search.inTheWay(place.objectName(), place.center(), heading)
                : List.of();
    }

    private static List<GeometryObject> inTheWay(ObjectSearch search, WorldRequest.Add add) {
        return isBorder(search, add) ? List.of() : search.touching(add.object());
    }

    /** The name of the first object in the way; null for the border. */
    private static @Nullable String first(Geometry world, WorldRequest.Place place) {
        double heading = Degrees.toDegrees(place.heading());
        ObjectSearch search = world.search();
        return search.fits(place.objectName(), place.center(), heading)
                ? name(search.firstInTheWay(place.objectName(), place.center(), heading))
                : null;
    }

    private static @Nullable String first(Geometry world, WorldRequest.Add add) {
        ObjectSearch search = world.search();
        return isBorder(search, add) ? null : name(search.firstTouching(add.object()));
    }

    /** Of an object that may overlap others nothing but the border can be in the way. */
    private static boolean isBorder(ObjectSearch search, WorldRequest.Add add) {
        return add.overlapping() || !search.fits(add.object());
    }

    private static @Nullable String name(Optional<GeometryObject> object) {
        return object.isEmpty() ? null : name(object.get());
    }

    /** The name of what is in the way: empty for an object without one, null for the border. */
    private static @Nullable String name(@Nullable GeometryObject object) {
        if (object == null) {
            return null;
        }
        return object.name() == null ? "" : object.name();
    }
}
