package robosim.geometry.scenario.drive;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.exact.Degrees;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.SurfaceSettings;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.body.ObjectBody;

/** The bodies of a world file as an environment asks for them. */
public final class WorldBodies {
    private WorldBodies() {}

    /** A request for each object that has a body or a surface, in their order. */
    public static List<BodyRequest> of(World world) {
        List<BodyRequest> bodies = new ArrayList<>();
        for (WorldObject object : world.objects()) {
            ObjectBody body = object.body();
            String name = object.object().name();
            if (body != null && name != null) {
                bodies.add(of(name, body));
            }
        }
        return bodies;
    }

    private static BodyRequest of(String name, ObjectBody body) {
        Drive drive = body.drive();
        return new BodyRequest(
                name,
                body.mass(),
                body.inertia(),
                SurfaceSettings.of(body.surface()),
                body.damping(),
                body.turnDamping(),
                body.maxSpeed(),
                body.maxTurn() == Double.POSITIVE_INFINITY ? body.maxTurn() : Degrees.toRadians(body.maxTurn()),
                body.floorFriction(),
                drive == null ? null : DriveSettings.of(drive),
                null,
                body.drag(),
                body.rolling(),
                List.copyOf(body.ignored()));
    }
}
