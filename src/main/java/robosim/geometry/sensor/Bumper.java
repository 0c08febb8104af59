package robosim.geometry.sensor;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.collision.Contact;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.exact.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/**
 * A bumper: tells which objects a robot touches and on which side of it. What it touches is decided by the objects' exact
 * shapes, whatever the accuracy of the world; as everywhere, touching is enough. Immutable.
 *
 * <pre>{@code
 * Geometry world = new Geometry(20, 4, 20);
 * world.addObject(new BoxObject(new Point(2, 0, 0), 1, 1, 1).named("crate"));
 * world.addObject(new CylinderObject(new Point(0.5, 0, 0), 0.5, 1).moveable("robot"));
 * Bumper bumper = Bumper.on("robot");
 * bumper.isPressed(world);                              // false
 * MoveResult refused = world.move("robot", new Move(1, 0, 0, 0, 0));
 * bumper.bearing(world, refused);                       // 0.0: it would have hit the crate straight ahead
 * world.addObjectUnchecked(new BoxObject(new Point(0, 0, 1), 1, 1, 1).named("intruder"));
 * bumper.touching(world).get(0).name();                 // "intruder"
 * bumper.bearing(world, bumper.contacts(world).get(0)) < 0; // true: on the right
 * }</pre>
 *
 * <p>A move that would touch something is refused, so a robot that only moves never presses its bumper: ask the result of
 * the refused move. Robots that were placed touching something, and things that others pushed, do.
 */
public final class Bumper {
    private final String name;

    /** In the object's own frame; null for the object itself. */
    private final @Nullable GeometryObject shape;

    private Bumper(String name, @Nullable GeometryObject shape) {
        this.name = name;
        this.shape = shape;
    }

    /** A bumper all over an object: its own surface. */
    public static Bumper on(String name) {
        return new Bumper(Checks.name(name), null);
    }

    /**
     * This bumper with a shape of its own, such as a strip around the robot: what touches the robot elsewhere, like the floor
     * that it stands on, is none of it. The shape is no part of the robot where it moves.
     *
     * @param ownShape in the object's own frame
     */
    public Bumper shaped(GeometryObject ownShape) {
        return new Bumper(name, Checks.present("ownShape", ownShape));
    }

    /** Whether anything touches the bumper. */
    public boolean isPressed(Geometry world) {
        return !find(world, 1).isEmpty();
    }

    /** The objects that touch the bumper, in the order in which they were added to the world, at their present places. */
    public List<GeometryObject> touching(Geometry world) {
        List<GeometryObject> touching = new ArrayList<>();
        for (Touch touch : find(world, Integer.MAX_VALUE)) {
            touching.add(touch.other);
        }
        return touching;
    }

    /** All contacts of the bumper, object by object in that order; {@code a} is the piece of the bumper. */
    public List<Contact> contacts(Geometry world) {
        List<Contact> contacts = new ArrayList<>();
        for (Touch touch : find(world, Integer.MAX_VALUE)) {
            contacts.addAll(touch.contacts);
        }
        return contacts;
    }

    private record Touch(GeometryObject other, List<Contact> contacts) {}

    private List<Touch> find(Geometry world, int limit) {
        List<Touch> found = new ArrayList<>();
        GeometryObject body = body(world);
        // No enclosure of a coarser accuracy is farther away than what is in it.
        if (shape == null && world.getProximity(name, 0) > 0) {
            return found;
        }
        GeometryObject bumper = shape == null ? body : shape.at(shape.pose().within(body.pose()));
        for (GeometryObject other : world.objects()) {
            if (!name.equals(other.name()) && found.size() < limit) {
                List<Contact> contacts = ContactQuery.contacts(bumper, other, world.dimension(), Integer.MAX_VALUE);
                if (!contacts.isEmpty()) {
                    found.add(new Touch(other, contacts));
                }
            }
        }
        return found;
    }

    private GeometryObject body(Geometry world) {
        return Checks.present("world", world).getObject(name);
    }

    /**
     * The side on which a contact is, in degrees counter-clockwise from forward in the object's own frame, above -180 and up
     * to 180; NaN straight above or below its centre.
     */
    public double bearing(Geometry world, Contact contact) {
        Pose pose = body(world).pose();
        return bearing(pose, from(pose, Checks.present("contact", contact).point()));
    }

    /**
     * The side on which a move was stopped, as {@link #bearing(Geometry, Contact)} has it: the side from which what blocks
     * pushes back. NaN if the move was allowed, or if what blocks pushes straight up or down.
     *
     * @param world  has the object where it was before the move, as after any refused one
     * @param result of a move of the bumper's object
     */
    public double bearing(Geometry world, MoveResult result) {
        Point normal = Checks.present("result", result).normal();
        if (normal == null) {
            return Double.NaN;
        }
        Pose pose = body(world).pose();
        return bearing(pose, new Point(-normal.x(), -normal.y(), -normal.z()));
    }

    private static double bearing(Pose pose, Point direction) {
        double forward = along(pose, 0, direction);
        double right = along(pose, 2, direction);
        return forward == 0 && right == 0 ? Double.NaN : Degrees.headingOf(forward, right);
    }

    private static Point from(Pose pose, Point point) {
        Point center = pose.center();
        return new Point(point.x() - center.x(), point.y() - center.y(), point.z() - center.z());
    }

    /** A component of a vector along one of the object's own axes. */
    private static double along(Pose pose, int axis, Point vector) {
        return pose.rotation(axis) * vector.x()
                + pose.rotation(3 + axis) * vector.y()
                + pose.rotation(6 + axis) * vector.z();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Bumper that && name.equals(that.name) && Objects.equals(shape, that.shape);
    }

    @Override
    public int hashCode() {
        return 31 * name.hashCode() + Objects.hashCode(shape);
    }

    @Override
    public String toString() {
        return "Bumper on \"" + name + "\"" + (shape == null ? "" : ", " + shape);
    }
}
