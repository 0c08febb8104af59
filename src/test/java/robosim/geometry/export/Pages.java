package robosim.geometry.export;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.scenario.Step;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.playback.Replayer;
import robosim.geometry.viewer.playback.StateHistory;

/** Recordings to make pages of. */
public final class Pages {
    private Pages() {}

    /** An object of each kind, on the floor at 0, some of them turned; the group has another one, and a capsule. */
    static List<GeometryObject> kinds() {
        BitSet walls = new BitSet();
        walls.set(0, 12); // a wall of one rectangle, and a cell
        walls.set(30);
        MeshObject pyramid = new MeshObject(
                List.of(
                        new Point(-1, 0, -1),
                        new Point(1, 0, -1),
                        new Point(1, 0, 1),
                        new Point(-1, 0, 1),
                        new Point(0, 1.5, 0)),
                new int[][] {{0, 1, 2, 3}, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}});
        ObjectGroup lamp = new ObjectGroup(List.of(
                new CylinderObject(new Point(0, 0.05, 0), 0.5, 0.1),
                new ObjectGroup(List.of(
                                new BoxObject(new Point(0, 0.75, 0), 0.1, 1.4, 0.1),
                                new SphereObject(new Point(0, 1.7, 0), 0.3)))
                        .turned(0, 45)));
        return List.of(
                new BoxObject(new Point(-4, 0.5, -3), 2, 1, 1).turned(0, 30).named("crate"),
                new CylinderObject(new Point(0, 0.75, -3), 0.6, 1.5).named("drum"),
                new SphereObject(new Point(4, 0.8, -3), 0.8),
                new CapsuleObject(new Point(-4, 0.3, 2), 0.3, 1.6).turned(90, 0).named("pill"),
                pyramid.movedTo(new Point(0, 0, 3)).named("tent"),
                lamp.movedTo(new Point(4, 0, 2)).turned(0, 20).named("lamp"),
                new GridObject(new Point(0, 0.4, -6), 0.5, 0.8, 12, 3, walls).named("map"),
                new CylinderObject(new Point(-1.5, 0.25, 0), 0.3, 0.5).moveable("robot"),
                new BoxObject(new Point(2, 0.2, 0), 0.7, 0.4, 0.5).moveable("cart"));
    }

    /**
     * Boxes in rows, and robots that drive straight on, 0.1 a step, until something blocks them, and then turn by
     * any angle; each has two sonars, which all measure every second step.
     *
     * @param turning whether all turn a little in every step
     */
    public static List<Step> wander(int objects, int robots, int steps, boolean turning, SplittableRandom random) {
        int side = (int) Math.ceil(Math.sqrt(objects));
        double world = 2.0 * side + 2;
        List<GeometryObject> all = new ArrayList<>();
        for (int k = 0; k < objects; k++) {
            Point at = new Point(2 * (k % side) - side + 1, 0.25, 2 * (k / side) - side + 1);
            boolean isRobot = k * robots / objects != (k + 1) * robots / objects;
            all.add(
                    isRobot
                            ? new CylinderObject(at, 0.3, 0.5)
                                    .turned(0, random.nextInt(360))
                                    .moveable("robot " + k)
                            : new BoxObject(at, 0.8, 0.5, 0.8)
                                    .turned(0, random.nextInt(90))
                                    .named("box " + k));
        }
        List<String> names = all.stream()
                .filter(GeometryObject::isMoveable)
                .map(GeometryObject::name)
                .toList();
        StateBuilder told = new StateBuilder();
        WorldSettings settings = new WorldSettings(world, 3, world, Dimension.PLANAR, Accuracy.EXACT);
        told.step(new InitBundle(all, settings));
        List<Boolean> blocked = new ArrayList<>();
        names.forEach(name -> blocked.add(false));
        for (int k = 1; k < steps; k++) {
            if (k % 2 == 0) {
                List<SonarRequest> sonars = new ArrayList<>();
                for (String name : names) {
                    sonars.add(new SonarRequest(name, 1, 0, new Beam(0, 5, 0.3)));
                    sonars.add(new SonarRequest(name, 0, 1, new Beam(0, 5, 0.3)));
                }
                told.step(new SonarRequestBundle(sonars));
                continue;
            }
            List<MoveRequest> moves = new ArrayList<>();
            for (int r = 0; r < names.size(); r++) {
                double turn = blocked.get(r) ? random.nextDouble(-3, 3) : turning ? random.nextDouble(-0.1, 0.1) : 0;
                moves.add(new MoveRequest(names.get(r), blocked.get(r) ? 0 : 0.1, 0, 0, 0, turn));
            }
            told.step(new MoveBundle(moves));
            for (int r = 0; r < names.size(); r++) {
                blocked.set(r, told.refused(names.get(r)));
            }
        }
        return told.steps;
    }

    /** A robot in space that rises, tips over and comes back. */
    static List<Step> tumble(int steps, SplittableRandom random) {
        StateBuilder told = new StateBuilder();
        WorldSettings settings = new WorldSettings(20, 20, 20, Dimension.SPATIAL, Accuracy.EXACT);
        told.step(new InitBundle(
                List.of(
                        new BoxObject(new Point(3, 4, 0), 1, 1, 1).named("block"),
                        new BoxObject(new Point(0, 0, 0), 1, 0.5, 0.4).moveable("drone"),
                        new SphereObject(new Point(-4, 1, 0), 0.5).moveable("ball")),
                settings));
        for (int k = 1; k < steps; k++) {
            double far = random.nextDouble(-0.5, 0.5);
            told.step(
                    switch (k % 3) {
                        case 0 ->
                            new SonarRequestBundle(
                                    List.of(new SonarRequest("drone", 1, 0, new Beam(0, Double.POSITIVE_INFINITY, 0))));
                        case 1 ->
                            new MoveBundle(List.of(new MoveRequest(
                                    "drone", far, far / 2, 0, random.nextDouble(), random.nextDouble())));
                        default ->
                            new MoveBundle(List.of(
                                    new MoveRequest("ball", far, -far, far, 0, 0),
                                    new MoveRequest("drone", 0, 0, 0.1, 0, -0.3)));
                    });
        }
        return told.steps;
    }

    public static StateHistory film(List<Step> steps) {
        StateHistory film = new StateHistory();
        Replayer stage = new Replayer(SessionOptions.ROBOSIM);
        steps.forEach(step -> film.append(stage.play(step)));
        return film;
    }

    /** Steps, carried out as they are told. */
    private static final class StateBuilder {
        final List<Step> steps = new ArrayList<>();
        private final Replayer stage = new Replayer(SessionOptions.ROBOSIM);
        private Frame last = stage.play(new Step(new MoveBundle(List.of()), null));

        void step(Bundle request) {
            Step step = new Step(request, null);
            last = stage.play(step);
            steps.add(step);
        }

        boolean refused(String name) {
            return last.bumps().stream()
                    .anyMatch(bump -> name.equals(bump.mover().name()));
        }
    }
}
