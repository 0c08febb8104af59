package robosim.geometry.cli;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.viewer.Scene;

/** What happened in a recorded conversation, for a picture: places to the pixel, not to the bit. */
final class Playback {
    private final Map<String, Pose> places = new LinkedHashMap<>();
    private final Map<String, List<Point>> trails = new LinkedHashMap<>();
    private final List<Scene.Refusal> refusals = new ArrayList<>();
    private List<Scene.Ping> pings = List.of();

    private Playback() {}

    /** Reads the two files of a recording. */
    static Playback read(Path toModule, Path fromModule) throws IOException {
        Playback playback = new Playback();
        try (var asked = new BufferedInputStream(Files.newInputStream(toModule));
                var answered = new BufferedInputStream(Files.newInputStream(fromModule))) {
            MessageReader requests = new MessageReader(asked);
            MessageReader answers = new MessageReader(answered);
            for (Bundle request = requests.read(); request != null; request = requests.read()) {
                if (request instanceof InitBundle init) {
                    playback.begin(init);
                } else if (request instanceof MoveBundle moves && answers.read() instanceof MoveBundle made) {
                    playback.move(moves.moves(), made.moves());
                } else if (request instanceof SonarRequestBundle sonar
                        && answers.read() instanceof DistanceBundle distances) {
                    playback.range(sonar.requests(), distances.distances());
                } else {
                    throw new IOException("the recording has no answer of the right kind for " + request);
                }
            }
        }
        return playback;
    }

    private void begin(InitBundle init) {
        places.clear();
        trails.clear();
        refusals.clear();
        for (GeometryObject object : init.objects()) {
            String name = object.name();
            if (object.isMoveable() && name != null) {
                places.put(name, object.pose());
                trails.put(name, new ArrayList<>(List.of(object.center())));
            }
        }
    }

    private void move(List<MoveRequest> asked, List<MoveRequest> made) {
        int next = 0;
        for (MoveRequest move : asked) {
            boolean allowed = next < made.size() && made.get(next).equals(move);
            next += allowed ? 1 : 0;
            Pose pose = places.get(move.objectName());
            if (pose == null) {
                continue;
            }
            double dx = along(pose, 0, move);
            double dy = along(pose, 3, move);
            double dz = along(pose, 6, move);
            if (allowed) {
                Point c = pose.center();
                Point place = new Point(c.x() + dx, c.y() + dy, c.z() + dz);
                Objects.requireNonNull(trails.get(move.objectName())).add(place);
                places.put(
                        move.objectName(),
                        pose.movedTo(place).turned(Math.toDegrees(move.rx()), Math.toDegrees(move.ry())));
            } else {
                refusals.add(new Scene.Refusal(pose.center(), degrees(dx, dz)));
            }
        }
    }

    private static double along(Pose pose, int row, MoveRequest move) {
        return pose.rotation(row) * move.x() + pose.rotation(row + 1) * move.y() + pose.rotation(row + 2) * move.z();
    }

    /** The heading of a direction in the world. */
    private static double degrees(double dx, double dz) {
        return StrictMath.toDegrees(StrictMath.atan2(-dz, dx));
    }

    private void range(List<SonarRequest> requests, List<Double> distances) {
        List<Scene.Ping> round = new ArrayList<>();
        for (int k = 0; k < requests.size() && k < distances.size(); k++) {
            SonarRequest request = requests.get(k);
            Pose pose = places.get(request.objectName());
            if (pose == null) {
                continue;
            }
            Beam beam = request.beam() == null ? Beam.LINE : request.beam();
            double heading = pose.heading() + degrees(request.xOffset(), request.zOffset());
            round.add(
                    new Scene.Ping(pose.center(), heading, Math.toDegrees(beam.width()), beam.max(), distances.get(k)));
        }
        pings = round;
    }

    /** The world at the end of the conversation, with all that happened in it. */
    Scene over(Scene world) {
        List<Scene.Thing> things = new ArrayList<>();
        for (Scene.Thing thing : world.things()) {
            String name = thing.object().name();
            Pose pose = name == null ? null : places.get(name);
            things.add(pose == null ? thing : new Scene.Thing(thing.object().at(pose), thing.colour()));
        }
        List<Scene.Trail> paths = new ArrayList<>();
        trails.forEach((name, path) -> paths.add(new Scene.Trail(name, path)));
        return Scene.of(world.title(), world.view(), things)
                .described(world.subtitle(), world.unit())
                .with(paths, pings, refusals);
    }
}
