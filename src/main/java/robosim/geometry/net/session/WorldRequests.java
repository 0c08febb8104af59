package robosim.geometry.net.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Pose;
import robosim.geometry.protocol.Text;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/** Answers requests about the world's objects, and keeps what became of the last init. */
public final class WorldRequests {
    private final List<WorldAnswer.LeftOut> leftOut = new ArrayList<>();
    private int characters;
    private int added;
    private @Nullable String failure;

    /** How many objects there are now. */
    private int present;

    /** Is told of a move that was tried. */
    @FunctionalInterface
    public interface Watcher {
        void tried(WorldRequest.Go request, MoveResult result);
    }

    /** A world with objects begins, of which none was left out. */
    public void begin(int objects) {
        leftOut.clear();
        characters = 0;
        failure = null;
        added = objects;
        present = objects;
    }

    /** The last init made no world. */
    public void failed(String reason) {
        failure = reason;
    }

    /** An object of an init was added. */
    public void added() {
        added++;
        present++;
    }

    /** An object of an init was left out. */
    public void leftOut(int index, @Nullable String name, String reason) {
        characters += (name == null ? 0 : name.length()) + reason.length();
        String told = name == null ? "" : name;
        boolean isShort = characters <= WorldAnswer.MOST_CHARACTERS;
        leftOut.add(new WorldAnswer.LeftOut(index, isShort ? told : "", isShort ? reason : ""));
    }

    /** How many objects the world has. */
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
        if (request instanceof WorldRequest.Locate locate) {
            return locate(world, locate.objectName());
        }
        if (request instanceof WorldRequest.Place place) {
            return place(world, place);
        }
        if (request instanceof WorldRequest.Add add) {
            return add(world, add, moveable);
        }
        if (request instanceof WorldRequest.Remove remove) {
            boolean isRemoved = world.removeObject(remove.objectName());
            if (isRemoved) {
                moveable.remove(remove.objectName());
                present--;
            }
            return new WorldAnswer.Changed(isRemoved, null);
        }
        WorldRequest.Go go = (WorldRequest.Go) request;
        Move move = new Move(go.x(), go.y(), go.z(), Degrees.toDegrees(go.rx()), Degrees.toDegrees(go.ry()));
        MoveResult result = world.move(go.objectName(), move);
        watcher.tried(go, result);
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

    private WorldAnswer describe(Geometry world) {
        if (failure != null) {
            throw new IllegalArgumentException(
                    "the world of the last init cannot be made, the one before it stays: " + failure);
        }
        return new WorldAnswer.Described(
                added,
                List.copyOf(leftOut),
                world.width(),
                world.height(),
                world.length(),
                world.dimension(),
                world.accuracy());
    }

    private static WorldAnswer locate(Geometry world, String name) {
        if (!world.hasObject(name)) {
            throw new IllegalArgumentException("no object " + Text.quoted(name));
        }
        Pose pose = world.getObject(name).pose();
        return new WorldAnswer.Located(pose.center(), new Numbers(pose.rotation()), Degrees.toRadians(pose.heading()));
    }

    private static WorldAnswer place(Geometry world, WorldRequest.Place place) {
        String name = place.objectName();
        double heading = Degrees.toDegrees(place.heading());
        if (world.placeObject(name, place.center(), heading)) {
            return new WorldAnswer.Changed(true, null);
        }
        return new WorldAnswer.Changed(
                false,
                world.search().fits(name, place.center(), heading)
                        ? name(world.search().firstInTheWay(name, place.center(), heading))
                        : null);
    }

    private WorldAnswer add(Geometry world, WorldRequest.Add add, Set<String> moveable) {
        GeometryObject object = add.object();
        boolean isAdded = add.overlapping() ? world.addObjectUnchecked(object) : world.addObject(object);
        if (isAdded) {
            present++;
            String name = object.name();
            if (object.isMoveable() && name != null) {
                moveable.add(name);
            }
            return new WorldAnswer.Changed(true, null);
        }
        boolean isBorder = add.overlapping() || !world.search().fits(object);
        return new WorldAnswer.Changed(
                false, isBorder ? null : name(world.search().firstTouching(object)));
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
