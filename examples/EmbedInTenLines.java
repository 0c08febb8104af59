import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;

/** A robot in front of a wall: may it be here, how far may it move, what does it hear? */
public final class EmbedInTenLines {
    private EmbedInTenLines() {}

    /** Run it with {@code java -cp target/classes examples/EmbedInTenLines.java}. */
    public static void main(String[] args) {
        Geometry geometry = new Geometry(20, 5, 20);
        geometry.addObject(new BoxObject(new Point(4, 0, 0), 0.2, 2, 6));
        geometry.addObject(new CylinderObject(new Point(0, 0, 0), 0.3, 1).moveable("robot"));
        System.out.println("sonar hears:   " + geometry.getSonarDistance("robot", 1, 0, 0, 10, 15));
        System.out.println("moves forward: " + geometry.simpleMove("robot", 2, 0, 0));
        System.out.println("through walls: " + geometry.simpleMove("robot", 5, 0, 0));
        System.out.println("up to it:      " + geometry.moveToContact("robot", new Move(5, 0, 0, 0, 0), 0.05));
        System.out.println("gap left:      " + geometry.getProximity("robot", 10));
    }
}
