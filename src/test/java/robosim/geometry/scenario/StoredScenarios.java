package robosim.geometry.scenario;

import static robosim.geometry.scenario.Conversation.move;
import static robosim.geometry.scenario.Conversation.sonar;
import static robosim.geometry.scenario.Conversation.turn;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldReader;

/**
 * The conversations behind {@code worlds/scenarios}, by the names of their files. {@link #main} records them anew: after a
 * change that makes an answer better, never to make a test pass.
 */
final class StoredScenarios {
    static final Path FOLDER = Path.of("worlds", "scenarios");

    private StoredScenarios() {}

    public static void main(String[] arguments) throws IOException {
        Files.createDirectories(FOLDER);
        for (Map.Entry<String, Conversation> entry : all().entrySet()) {
            Files.write(file(entry.getKey()), entry.getValue().recorded());
        }
    }

    static Path file(String name) {
        return FOLDER.resolve(name + ScenarioReader.ENDING);
    }

    static Map<String, Conversation> all() throws IOException {
        Map<String, Conversation> all = new LinkedHashMap<>();
        all.put("wandering", wandering());
        all.put("overlapping-walls", overlappingWalls());
        all.put("unknown-names", unknownNames());
        all.put("vertical-sonar", verticalSonar());
        all.put("quarter-turns", quarterTurns());
        all.putAll(FoundOnce.all());
        return all;
    }

    private static Conversation wandering() throws IOException {
        World world = WorldReader.read(Path.of("worlds", "rooms.xml"));
        List<GeometryObject> objects = new ArrayList<>();
        List<String> robots = new ArrayList<>();
        world.objects().forEach(object -> {
            objects.add(object.object());
            if (object.object().isMoveable()) {
                robots.add(object.object().name());
            }
        });
        Conversation talk = new Conversation("Eight robots wander through rooms.xml for eight rounds");
        talk.ask(new InitBundle(
                objects,
                new WorldSettings(world.width(), world.height(), world.length(), world.dimension(), world.accuracy())));
        SplittableRandom random = new SplittableRandom(1);
        for (int round = 0; round < 8; round++) {
            List<SonarRequest> sonars = new ArrayList<>();
            List<MoveRequest> moves = new ArrayList<>();
            for (String robot : robots) {
                sonars.add(sonar(robot, 1, 0, 0.05, 4, 0.25));
                sonars.add(sonar(robot, 1, round - 4));
                double turn = random.nextDouble() - 0.5;
                moves.add(new MoveRequest(robot, 3 * random.nextDouble(), 0, 0, 0, turn));
            }
            talk.ask(new SonarRequestBundle(sonars)).ask(new MoveBundle(moves));
        }
        return talk;
    }

    private static Conversation overlappingWalls() {
        return new Conversation("Walls overlap in a corner, and a robot stands in one of them at the start")
                .world(
                        Dimension.PLANAR,
                        20,
                        new BoxObject(new Point(0, 0, 0), 0.5, 2, 10).named("wall along z"),
                        new BoxObject(new Point(4, 0, -5), 8, 2, 0.5).named("wall along x"),
                        new CylinderObject(new Point(0.5, 0, 0), 0.5, 1).moveable("stuck"),
                        new BoxObject(new Point(3, 0, 0), 1, 1, 1).moveable("free"))
                .note("deeper into the wall is refused, along it and away from it is free")
                .moves(move("stuck", -0.125, 0))
                .moves(move("stuck", 0, 1), move("stuck", 0, -1), move("stuck", 0.125, 0))
                .note("once the two have come apart the wall blocks as any other")
                .moves(move("stuck", 0.5, 0), move("stuck", -0.5, 0))
                .sonars(sonar("stuck", -1, 0), sonar("stuck", 1, 0), sonar("free", -1, 0), sonar("free", 0, -1));
    }

    private static Conversation unknownNames() {
        return new Conversation("Names that are unknown, static, or taken")
                .note("before there is a world every name is unknown")
                .moves(move("robot", 1, 0))
                .sonars(sonar("robot", 1, 0))
                .world(
                        Dimension.PLANAR,
                        20,
                        new BoxObject(new Point(5, 0, 0), 1, 1, 4).named("wall"),
                        new CylinderObject(new Point(), 0.5, 1).moveable("robot"),
                        new CylinderObject(new Point(0, 0, 3), 0.5, 1).moveable("robot"),
                        new CylinderObject(new Point(30, 0, 0), 0.5, 1).moveable("outside"))
                .moves(move("robot", 1, 0), move("wall", 1, 0), move("nobody", 1, 0), move("outside", 1, 0))
                .sonars(sonar("robot", 1, 0), sonar("wall", 1, 0), sonar("Robot", 1, 0), sonar("robot", 0, 1))
                .note("a new world forgets the old one's names")
                .world(Dimension.PLANAR, 20, new CylinderObject(new Point(), 0.5, 1).moveable("other"))
                .moves(move("robot", 1, 0), move("other", 1, 0));
    }

    private static Conversation verticalSonar() {
        CylinderObject lying = new CylinderObject(new Point(), 0.5, 1)
                .oriented(new double[] {0, -1, 0, 1, 0, 0, 0, 0, 1})
                .moveable("climber");
        BoxObject wall = new BoxObject(new Point(0, 0, 4), 10, 1, 1);
        BoxObject roof = new BoxObject(new Point(0, 4, 0), 10, 1, 20);
        return new Conversation("A robot whose forward is straight up: seen from above its sonar has no direction")
                .world(Dimension.PLANAR, 40, wall, lying)
                .sonars(sonar("climber", 1, 0), sonar("climber", 0, 1), sonar("climber", 1, 1))
                .note("in space it looks at the roof")
                .world(Dimension.SPATIAL, 40, wall, roof, lying)
                .sonars(sonar("climber", 1, 0), sonar("climber", 0, 1), sonar("climber", 1, 1));
    }

    private static Conversation quarterTurns() {
        double quarter = Math.PI / 2;
        Conversation talk = new Conversation("Quarter turns are exact: distances are whole numbers after any of them")
                .world(
                        Dimension.SPATIAL,
                        40,
                        new BoxObject(new Point(6, 0, 0), 2, 2, 2).named("east"),
                        new BoxObject(new Point(0, 0, -9), 2, 2, 2).named("north"),
                        new SphereObject(new Point(-12, 0, 0), 1).named("west"),
                        new BoxObject(new Point(0, 12, 0), 2, 2, 2).named("above"),
                        new BoxObject(new Point(), 2, 2, 2).moveable("cube"));
        for (int k = 0; k < 4; k++) {
            talk.moves(turn("cube", quarter)).sonars(sonar("cube", 1, 0), sonar("cube", 0, 1), sonar("cube", -1, 0));
        }
        return talk.note("about its own X, then many quarters at once")
                .moves(new MoveRequest("cube", 0, 0, 0, quarter, 0))
                .sonars(sonar("cube", 0, 1), sonar("cube", 0, -1))
                .moves(new MoveRequest("cube", 0, 0, 0, -quarter, 1001 * quarter))
                .sonars(sonar("cube", 1, 0), sonar("cube", 0, 1), sonar("cube", -1, 0), sonar("cube", 0, -1));
    }
}
