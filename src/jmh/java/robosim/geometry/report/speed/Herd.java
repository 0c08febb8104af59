package robosim.geometry.report.speed;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.Socket;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/**
 * Robots in the warehouse: drums of radius 0.25 that stand anywhere free, each with 16 sonars all around. In a step every
 * robot goes 0.05 forward, or turns by a radian where it was refused before, and then hears its 16 cones.
 */
final class Herd {
    static final int SONARS = 16;
    private static final double STEP = 0.05;
    private static final double RADIANS = 1;

    private final World world;
    private final List<GeometryObject> objects = new ArrayList<>();
    private final String[] names;

    Herd(Place place, int robots) {
        world = place.world();
        Geometry geometry = new Geometry(world.width(), world.height(), world.length());
        double height = 0;
        int own = 0;
        for (WorldObject object : world.objects()) {
            if (object.object().isMoveable()) {
                height += object.object().center().y();
                own++;
            } else {
                objects.add(object.object());
                geometry.addObjectUnchecked(object.object());
            }
        }
        names = new String[robots];
        SplittableRandom random = new SplittableRandom(Form.SEED + robots);
        for (int k = 0; k < robots; ) {
            Point at = new Point(
                    random.nextDouble(-0.49, 0.49) * world.width(),
                    height / own,
                    random.nextDouble(-0.49, 0.49) * world.length());
            GeometryObject robot = new CylinderObject(at, 0.25, 0.4)
                    .turned(0, random.nextDouble(-180, 180))
                    .moveable("robot " + k);
            if (geometry.addObject(robot)) {
                objects.add(robot);
                names[k++] = "robot " + (k - 1);
            }
        }
    }

    /** Steps through the calls of a program that embeds the module. */
    InTurn.Batch inProcess(Dimension dimension, Accuracy level) {
        Geometry geometry = new Geometry(world.width(), world.height(), world.length(), dimension, level);
        objects.forEach(geometry::addObjectUnchecked);
        boolean[] refused = new boolean[names.length];
        return (from, count) -> {
            double sum = 0;
            for (int step = 0; step < count; step++) {
                sum += step(geometry, refused);
            }
            return sum;
        };
    }

    private double step(Geometry geometry, boolean[] refused) {
        for (int k = 0; k < names.length; k++) {
            refused[k] = refused[k]
                    ? !geometry.simpleTurn(names[k], Math.toDegrees(RADIANS))
                    : !geometry.simpleMove(names[k], STEP, 0, 0);
        }
        double sum = 0;
        for (String name : names) {
            for (int k = 0; k < SONARS; k++) {
                double x = StrictMath.cos(k * Math.PI / 8);
                double z = StrictMath.sin(k * Math.PI / 8);
                sum += Math.min(Place.RANGE, geometry.getSonarDistance(name, x, z, 0, Place.RANGE, Place.CONE_DEGREES));
            }
        }
        return sum;
    }

    /** Steps over a connection: one bundle of moves and one of sonar requests a step, each awaited. */
    Wire overTcp(Dimension dimension, Accuracy level) throws IOException {
        return new Wire(new WorldSettings(world.width(), world.height(), world.length(), dimension, level));
    }

    /** A connection to a server of its own. */
    final class Wire implements InTurn.Batch, AutoCloseable {
        private final GeometryServer server = new GeometryServer(0);
        private final Socket socket = new Socket(server.address().getAddress(), server.port());
        private final MessageWriter writer;
        private final MessageReader reader;
        private final SonarRequestBundle sonars;
        private final Set<String> refused = new HashSet<>();

        private Wire(WorldSettings settings) throws IOException {
            socket.setTcpNoDelay(true);
            writer = new MessageWriter(new BufferedOutputStream(socket.getOutputStream(), 1 << 16));
            reader = new MessageReader(socket.getInputStream());
            writer.write(new InitBundle(objects, settings));
            Beam beam = new Beam(0, Place.RANGE, Math.toRadians(Place.CONE_DEGREES));
            List<SonarRequest> requests = new ArrayList<>();
            for (String name : names) {
                for (int k = 0; k < SONARS; k++) {
                    double angle = k * Math.PI / 8;
                    requests.add(new SonarRequest(name, StrictMath.cos(angle), StrictMath.sin(angle), beam));
                }
            }
            sonars = new SonarRequestBundle(requests);
        }

        @Override
        public double ask(int from, int count) {
            try {
                double sum = 0;
                for (int step = 0; step < count; step++) {
                    sum += step();
                }
                return sum;
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        private double step() throws IOException {
            List<MoveRequest> moves = new ArrayList<>();
            for (String name : names) {
                moves.add(
                        refused.contains(name)
                                ? new MoveRequest(name, 0, 0, 0, 0, RADIANS)
                                : new MoveRequest(name, STEP, 0, 0, 0, 0));
            }
            writer.write(new MoveBundle(moves));
            MoveBundle made = (MoveBundle) reader.read();
            refused.clear();
            moves.forEach(move -> refused.add(move.objectName()));
            made.moves().forEach(move -> refused.remove(move.objectName()));
            writer.write(sonars);
            DistanceBundle heard = (DistanceBundle) reader.read();
            if (heard.distances().size() != sonars.requests().size()) {
                throw new IOException("every sonar must be answered (got: "
                        + heard.distances().size() + ")");
            }
            return heard.distances().get(0);
        }

        @Override
        public void close() throws IOException {
            socket.close();
            server.close();
        }
    }
}
