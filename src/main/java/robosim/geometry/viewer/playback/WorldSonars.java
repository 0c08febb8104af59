package robosim.geometry.viewer.playback;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import robosim.geometry.Geometry;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.SonarRing;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** The sonars that a world file gives its robots, by the names of these. */
public final class WorldSonars {
    public static final WorldSonars NONE = new WorldSonars(Map.of());

    private final Map<String, List<SonarRing>> rings;

    private WorldSonars(Map<String, List<SonarRing>> rings) {
        this.rings = rings;
    }

    public static WorldSonars of(World world) {
        Checks.present("world", world);
        Map<String, List<SonarRing>> rings = new LinkedHashMap<>();
        for (WorldObject each : world.objects()) {
            String name = each.object().name();
            if (name != null && !each.sonars().isEmpty()) {
                rings.put(name, each.sonars());
            }
        }
        return new WorldSonars(rings);
    }

    /** What they measure where the robots are now, by name; a robot that is not in the world measures nothing. */
    public Map<String, List<Scene.Ping>> measure(Geometry world) {
        Map<String, List<Scene.Ping>> heard = new LinkedHashMap<>();
        rings.forEach((name, own) -> {
            if (world.hasObject(name)) {
                GeometryObject robot = world.getObject(name);
                List<Scene.Ping> pings = new ArrayList<>();
                own.forEach(ring -> measure(world, robot, name, ring, pings));
                heard.put(name, pings);
            }
        });
        return heard;
    }

    private static void measure(
            Geometry world, GeometryObject robot, String name, SonarRing ring, List<Scene.Ping> pings) {
        for (int k = 0; k < ring.count(); k++) {
            Point towards = ring.direction(k);
            double distance =
                    world.getSonarDistance(name, towards.x(), towards.z(), ring.min(), ring.max(), ring.width());
            double heading = robot.heading() + ring.first() + k * ring.step();
            pings.add(new Scene.Ping(robot.center(), heading, ring.width(), ring.max(), distance));
        }
    }
}
