package robosim.geometry.sensor;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.check.Checks;
import robosim.geometry.collision.Contact;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.dynamics.BodyContact;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;

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
 * the refused move. Robots that were placed touching something, and things that others pushed, do. Bodies that
 * {@link robosim.geometry.dynamics.Dynamics} steps stop just before contact: ask the result of the step.
 *
 * <pre>{@code
 * Geometry arena = new Geometry(20, 4, 20, Dimension.PLANAR, Accuracy.EXACT);
 * arena.addObject(new BoxObject(new Point(2, 0, 0), 1, 1, 1).named("crate"));
 * arena.addObject(new CylinderObject(new Point(0, 0, 0), 0.5, 1).moveable("cart"));
 * Dynamics dynamics = new Dynamics(arena, Surface.SMOOTH);
 * dynamics.add("cart", Body.of(20, 1));
 * dynamics.drive("cart", new DifferentialDrive(0.8, 1, 2).driving(0.5, 0));
 * Bumper ring = Bumper.on("cart");
 * ring.isPressed(arena, dynamics.step(1));              // false: it still drives
 * StepResult step = dynamics.step(2);
 * BodyContact contact = ring.contacts(arena, step).get(0);
 * contact.other();                                      // "crate"
 * ring.bearing(arena, contact);                         // 0.0: straight ahead
 * }</pre>
 *
 * @param name  of the object that has the bumper
 * @param shape of the bumper, in the object's own frame; null for the object itself
 */
public record Bumper(String name, @Nullable GeometryObject shape) {
    /** The cosine of the angle to the vertical within which a contact is below or above an object. */
    private static final double BELOW = 0.5;

    /** Refuses a name that no object can have. */
    public Bumper {
        Checks.name(name);
    }

    /** A bumper all over an object: its own surface. */
    public static Bumper on(String name) {
        return new Bumper(name, null);
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
        return bearing(pose, opposite(normal));
    }

    /** Whether anything pressed the bumper in a step. */
    public boolean isPressed(Geometry world, StepResult step) {
        return !contacts(world, step).isEmpty();
    }

    /**
     * The contacts of a step that press the bumper: those of its object that have begun or last, as seen from it, so that it is
     * the {@link BodyContact#body} of each. Of a bumper with a shape of its own, those whose point or whose other object touches
     * that shape where the object is now: it should stick out a little, and steps should be short.
     */
    public List<BodyContact> contacts(Geometry world, StepResult step) {
        GeometryObject body = body(world);
        GeometryObject bumper = shape == null ? null : shape.at(shape.pose().within(body.pose()));
        List<BodyContact> found = new ArrayList<>();
        for (BodyContact contact : Checks.present("step", step).contacts()) {
            if (contact.phase() == BodyContact.Phase.END || !isOf(contact)) {
                continue;
            }
            BodyContact own = own(contact);
            if (bumper == null || touches(world, bumper, own)) {
                found.add(own);
            }
        }
        return found;
    }

    private static boolean touches(Geometry world, GeometryObject bumper, BodyContact own) {
        String other = own.other();
        return touches(world, bumper, new SphereObject(own.point(), 0))
                || (other != null && world.hasObject(other) && touches(world, bumper, world.getObject(other)));
    }

    private static boolean touches(Geometry world, GeometryObject bumper, GeometryObject other) {
        return !ContactQuery.contacts(bumper, other, world.dimension(), 1).isEmpty();
    }

    private boolean isOf(BodyContact contact) {
        return name.equals(contact.body()) || name.equals(contact.other());
    }

    /** A contact as the object sees it. */
    private BodyContact own(BodyContact contact) {
        if (name.equals(contact.body())) {
            return contact;
        }
        return new BodyContact(
                name, contact.body(), contact.point(), opposite(contact.normal()), contact.impulse(), contact.phase());
    }

    private static Point opposite(Point direction) {
        return new Point(-direction.x(), -direction.y(), -direction.z());
    }

    /**
     * The side from which what was touched in a step pushes back, as {@link #bearing(Geometry, Contact)} has it; NaN if it is
     * below or above the object, as a floor is: if it pushes within 60 degrees of the object's own vertical.
     *
     * @param contact one of the object
     * @throws IllegalArgumentException if it is not
     */
    public double bearing(Geometry world, BodyContact contact) {
        if (!isOf(Checks.present("contact", contact))) {
            throw new IllegalArgumentException("contact must be one of \"" + name + "\" (got: \"" + contact.body()
                    + "\" and \"" + contact.other() + "\")");
        }
        Pose pose = body(world).pose();
        Point push = opposite(own(contact).normal());
        return Math.abs(along(pose, 1, push)) > BELOW ? Double.NaN : bearing(pose, push);
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
    public String toString() {
        return "Bumper on \"" + name + "\"" + (shape == null ? "" : ", " + shape);
    }
}
