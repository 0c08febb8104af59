package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.WorldSettings;

/** A conversation whose answers were worked out by hand, and what the audit says where one of them is another. */
class ConversationAuditTest {
    @TempDir
    static Path compiled;

    @TempDir
    Path folder;

    private final List<Bundle> asked = new ArrayList<>();
    private final List<Bundle> answered = new ArrayList<>();

    @BeforeAll
    static void compile() throws Exception {
        assertThat(Examples.compile(List.of(Examples.FOLDER.resolve("ConversationAudit.java")), compiled))
                .isEmpty();
    }

    /** A drum of radius 0.5 at the origin, a square cart of side 1 at z = 5, a wall whose near face is at x = 2. */
    private void begin(GeometryObject... more) {
        List<GeometryObject> objects = new ArrayList<>(List.<GeometryObject>of(
                new CylinderObject(new Point(), 0.5, 1).moveable("drum"),
                new BoxObject(new Point(0, 0, 5), 1, 1, 1).moveable("cart"),
                new BoxObject(new Point(2.5, 0, 0), 1, 1, 20).named("wall")));
        objects.addAll(List.of(more));
        asked.add(new InitBundle(objects, new WorldSettings(40, 10, 40, Dimension.PLANAR, Accuracy.EXACT)));
    }

    private void move(String name, double x, double z, double ry, boolean made) {
        MoveRequest move = new MoveRequest(name, x, 0, z, 0, ry);
        asked.add(new MoveBundle(List.of(move)));
        answered.add(new MoveBundle(made ? List.of(move) : List.of()));
    }

    private void ping(String name, double x, double z, double width, double distance) {
        asked.add(new SonarRequestBundle(List.of(new SonarRequest(name, x, z, new Beam(0.1, 10, width)))));
        answered.add(new DistanceBundle(List.of(distance)));
    }

    private String audit() throws Exception {
        write("to-module.bin", asked);
        write("from-module.bin", answered);
        return Examples.audit(folder, compiled);
    }

    private void write(String name, List<Bundle> bundles) throws Exception {
        try (OutputStream out = Files.newOutputStream(folder.resolve(name))) {
            MessageWriter writer = new MessageWriter(out);
            for (Bundle bundle : bundles) {
                writer.write(bundle);
            }
        }
    }

    @Test
    void findsNothingWhereNothingIsWrong() throws Exception {
        begin();
        ping("drum", 1, 0, 0, 2);
        ping("drum", 0, 1, 0, 4.5);
        ping("drum", -1, 0, 0, Double.POSITIVE_INFINITY);
        ping("drum", 1, 1, Math.PI / 2, 2); // its edge just reaches straight ahead
        move("drum", 1, 0, 0, true);
        ping("drum", 1, 0, 0, 1);
        move("drum", 0.75, 0, 0, false);
        move("drum", 30, 0, 0, false); // through the wall and beyond
        move("drum", 0, 0, Math.PI / 2, true); // now forward is -Z
        ping("drum", 1, 0, 0, Double.POSITIVE_INFINITY);
        ping("drum", 0, 1, 0, 1); // and its right is +X
        move("drum", -1, 0, 0, true);
        ping("cart", 1, 0, 0, 2);
        move("cart", 1.49, 0, 0, true);
        move("cart", 0, 0, Math.PI / 4, false); // its corner would pass through the wall
        move("cart", -1, 0, Math.PI / 4, true);
        move("nobody", 1, 0, 0, false);
        ping("nobody", 1, 0, 0, Double.NaN);
        ping("wall", 1, 0, 0, Double.NaN);
        assertThat(audit())
                .contains("nothing is wrong", "3 refused by wall", "10 distances", "exit 0")
                .contains(" 9 moves: 5 made, 4 refused");
        assertThat(Files.readString(folder.resolve("audit.properties"))).contains("faults=0");
    }

    @Test
    void catchesAMoveIntoAWall() throws Exception {
        begin();
        move("drum", 1.75, 0, 0, true);
        assertThat(audit()).contains("deep into wall", "1 FAULTS", "exit 1");
    }

    @Test
    void catchesAMoveThroughAWall() throws Exception {
        begin();
        move("drum", 10, 0, 0, true);
        assertThat(audit()).contains("deep into wall", "exit 1");
    }

    @Test
    void catchesAMoveThroughAnotherRobot() throws Exception {
        begin();
        move("drum", 0, 4.25, 0, true);
        assertThat(audit()).contains("deep into cart", "exit 1");
    }

    @Test
    void catchesATurnThroughAWall() throws Exception {
        begin();
        move("cart", 1.4, 0, 0, true);
        // A whole quarter: its ends are free, its middle is not.
        move("cart", 0, 0, Math.PI / 2, true);
        assertThat(audit()).contains("deep into wall", "1 FAULTS", "exit 1");
    }

    @Test
    void catchesAMoveThroughTheBorder() throws Exception {
        begin();
        move("drum", -19.75, 0, 0, true);
        assertThat(audit()).contains("deep into the border", "exit 1");
    }

    @Test
    void catchesAMoveThatWasRefusedWithoutACause() throws Exception {
        begin();
        move("drum", 1.25, 0, 0, false);
        assertThat(audit()).contains("refused that is free by 0.25", "exit 1");
    }

    @Test
    void catchesAWrongDistance() throws Exception {
        begin();
        ping("drum", 1, 0, 0, 2.000001);
        assertThat(audit()).contains("should be 2.0", "1 FAULTS", "exit 1");
    }

    @Test
    void catchesADistanceThatSeesThroughThings() throws Exception {
        begin();
        ping("drum", 1, 0, 0, Double.POSITIVE_INFINITY);
        assertThat(audit()).contains("should be 2.0", "exit 1");
    }

    @Test
    void catchesAConeThatHearsOnlyItsMiddle() throws Exception {
        // A thin pole beside the middle line of a cone, which a fan of rays may miss.
        begin(new CylinderObject(new Point(-3, 0, 0.25), 0.01, 1).named("pole"));
        ping("drum", -1, 0, 0.5, Math.sqrt(9 + 0.0625) - 0.01);
        ping("drum", -1, 0, 0.5, Double.POSITIVE_INFINITY);
        assertThat(audit()).contains("1 FAULTS", "Infinity should be 3.0", "exit 1");
    }

    @Test
    void catchesAnswersThatWereNeverAsked() throws Exception {
        begin();
        move("drum", 1, 0, 0, true);
        answered.set(0, new MoveBundle(List.of(new MoveRequest("drum", 1.5, 0, 0, 0, 0))));
        assertThat(audit()).contains("not asked", "exit 1");
    }

    @Test
    void catchesADistanceForNobody() throws Exception {
        begin();
        ping("nobody", 1, 0, 0, 1);
        assertThat(audit()).contains("no moveable object", "exit 1");
    }

    @Test
    void excusesWhatOverlappedAtTheStartUntilItIsApartOnce() throws Exception {
        begin(new BoxObject(new Point(-0.75, 0, 0), 1, 1, 1).named("crate"));
        move("drum", 0.25, 0, 0, true); // still overlapping, on its way out
        move("drum", -0.1, 0, 0, false); // into it again: refused, and rightly
        move("drum", 0.75, 0, 0, true); // apart
        assertThat(audit()).contains("1 pairs overlapped at the start", "nothing is wrong");
        move("drum", -0.875, 0, 0, true); // never again
        assertThat(audit()).contains("deep into crate", "exit 1");
    }

    @Test
    void saysWhatItCannotRead() throws Exception {
        assertThat(Examples.audit(folder, compiled)).contains("cannot be read", "exit 2");
        begin();
        move("drum", 1, 0, 0, true);
        answered.clear();
        assertThat(audit()).contains("ends before the last answer", "exit 2");
        asked.clear();
        asked.add(new InitBundle(List.of(new CylinderObject(new Point(), 1, 1))));
        assertThat(audit()).contains("PLANAR", "exit 2");
    }
}
