import java.time.Duration;
import java.util.List;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.Contact;
import robosim.geometry.collision.ContactPart;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.Verdict;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

/** Two roofs that run into each other: which faces meet, and where? And how far apart are they, in a hurry? */
public final class ContactTriangles {
    private ContactTriangles() {}

    /** Run it with {@code java -cp target/classes examples/ContactTriangles.java}. */
    public static void main(String[] args) {
        MeshObject roof = roof();
        MeshObject other = roof.turned(0, 90).movedTo(new Point(3, 0.5, 0));
        for (Contact contact : ContactQuery.contacts(roof, other)) {
            System.out.println(name(contact.a()) + " meets " + name(contact.b()) + " at " + contact.point()
                    + " to within " + contact.error() + ", " + contact.certainty());
        }
        MeshObject away = other.movedTo(new Point(30, 5, 0));
        Verdict few = ContactQuery.distance(roof, away, Budget.steps(3));
        System.out.println("after 3 steps: from " + few.low() + " to " + few.high());
        Verdict all = ContactQuery.distance(roof, away, Budget.UNLIMITED);
        System.out.println("at the end:    from " + all.low() + " to " + all.high());
        Verdict soon = ContactQuery.decide(roof, other, Budget.time(Duration.ofMillis(20)));
        System.out.println("do they touch? " + soon.answer());
    }

    private static String name(ContactPart part) {
        return "face " + part.face() + (part.half() == 0 ? "a" : "b");
    }

    /** Two slopes along X, each a quad, with a ridge at a height of 2. */
    private static MeshObject roof() {
        List<Point> corners = List.of(
                new Point(-4, 0, -2),
                new Point(4, 0, -2),
                new Point(4, 2, 0),
                new Point(-4, 2, 0),
                new Point(4, 0, 2),
                new Point(-4, 0, 2));
        return new MeshObject(corners, new int[][] {{0, 1, 2, 3}, {3, 2, 4, 5}});
    }
}
