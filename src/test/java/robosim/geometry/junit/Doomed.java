package robosim.geometry.junit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import robosim.geometry.Geometry;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.json.JsonLines;

/** Tests that fail, each in its way; {@link WorldExtensionTest} runs them. No build finds them by their name. */
final class Doomed {
    private Doomed() {}

    @World(method = "wallAhead")
    static class Failing {
        static Geometry wallAhead() {
            return Worlds.wallAhead();
        }

        @Test
        @Seed(7)
        void blocked(RobotWorld world, RandomGenerator random) {
            world.robot("r1").drives(0.5 + random.nextDouble() * 0.5).drives(3.5);
        }

        @Test
        void compared(RobotWorld world) {
            assertEquals(4.0, world.robot("r1").range(0));
        }

        @Test
        void broken(Geometry geometry) {
            geometry.simpleMove("r1", 1, 0, 0);
            throw new IllegalStateException("out of luck");
        }

        @Test
        void lost(RobotWorld world) {
            world.robot("r1")
                    .follows(robot -> robot.triesToDrive(0.1))
                    .reaches(Goal.at(1, 0, 0.2))
                    .within(9);
            world.robot("r1").reaches(Goal.at(-30, 2, 0.25)).within(3);
        }

        @Test
        void undocked(RobotWorld world) {
            world.robot("r1")
                    .follows(robot -> robot.drives(0.1))
                    .reaches(Goal.near("r2", 0.1))
                    .within(100);
        }

        @Test
        void arrived(RobotWorld world) {
            world.robot("r1")
                    .follows(robot -> robot.triesToDrive(0.1))
                    .reaches(Goal.at(1, 0, 0.2))
                    .within(9);
            world.robot("r1").drives(3.5);
        }

        @Test
        void assumed(RobotWorld world) {
            assumeTrue(world.robots().isEmpty());
        }

        @Test
        void passes(RobotWorld world) {
            world.robot("r1").drives(1);
        }
    }

    /** The one of docs/scenario-tests.md. */
    @World("examples/scenario-tests/src/test/resources/worlds/two-rooms.xml")
    static class DoorTest {
        @Test
        @Seed(7)
        void itLeavesTheRoom(RobotWorld world) {
            world.robot("robot").drives(1).turns(10).senses(30, 10).drives(4);
        }
    }

    @World("nowhere.xml")
    static class Misplaced {
        @Test
        void unknown(RobotWorld world) {}

        @Test
        @World({"worlds/rooms.xml", "worlds/maze.xml"})
        void several(RobotWorld world) {}

        @Test
        @World(method = "missing")
        void method(RobotWorld world) {}

        @Test
        @World
        void neither(RobotWorld world) {}

        @Test
        @World("robosim/geometry/world/world.xsd")
        void schema(RobotWorld world) {}
    }

    @World({"worlds/rooms.xml", "worlds/warehouse.xml"})
    @Seed({1, 2, 3})
    static class Manifold {
        @ScenarioTest
        void each(RobotWorld world, RandomGenerator random) {
            Robot robot = world.robots().get(0);
            Point start = robot.center();
            robot.triesToTurn(random.nextDouble() * 360);
            throw new AssertionError(world.robots().size() + " robots, " + start + ", " + robot.heading());
        }
    }

    /** Asks for a server and nothing else. */
    @World
    static class Served {
        @Test
        void served(GeometryServer server) throws IOException {
            new Socket(InetAddress.getLoopbackAddress(), server.port()).close();
        }
    }

    /** The same by the extension itself. */
    @ExtendWith(WorldExtension.class)
    static class Extended {
        @Test
        void served(GeometryServer server) throws IOException {
            new Socket(InetAddress.getLoopbackAddress(), server.port()).close();
        }
    }

    @Seed(1)
    static class Talking {
        static int port;

        @Test
        void talks(GeometryServer server) throws IOException {
            port = server.port();
            List<GeometryObject> objects = Worlds.wallAhead().objects();
            try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
                Bundle sonar = new SonarRequestBundle(List.of(new SonarRequest("r1", 1, 0)));
                String lines = "{\"type\":\"hello\",\"version\":1}\n" + JsonLines.write(new InitBundle(objects)) + "\n"
                        + JsonLines.write(sonar) + "\n";
                socket.getOutputStream().write(lines.getBytes(StandardCharsets.UTF_8));
                BufferedReader in =
                        new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
                in.readLine(); // the hello
                throw new AssertionError(in.readLine());
            }
        }
    }
}
