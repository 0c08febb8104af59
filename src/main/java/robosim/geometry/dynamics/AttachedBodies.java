package robosim.geometry.dynamics;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import robosim.geometry.engine.World;
import robosim.geometry.engine.objects.Attachments;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Pose;

/**
 * Makes one body of those whose objects are attached to each other, and several again of what is detached. The world knows what is
 * attached; this follows it whenever objects have come or gone.
 */
final class AttachedBodies {
    private final World engine;
    private final Map<String, BodyState> bodies;

    /** The number of changes of the objects of the world up to which bodies have been joined; below 0 to do so again. */
    long assembledAt;

    /** Whether any body has been a part of another one. */
    private boolean hasParts;

    AttachedBodies(World engine, Map<String, BodyState> bodies) {
        this.engine = engine;
        this.bodies = bodies;
    }

    /** What moves a body: itself, or what it is attached to. */
    BodyState whole(BodyState state) {
        String root = state.root;
        BodyState whole = root == null ? null : bodies.get(root);
        return whole == null ? state : whole;
    }

    /** Takes note of what has been attached and detached since it was called last; whether that is anything. */
    boolean assemble() {
        long now = engine.objects.changes();
        if (now == assembledAt) {
            return false;
        }
        Attachments attachments = engine.registry.attachments;
        boolean isOther = assembledAt < 0;
        assembledAt = now;
        if (attachments.isEmpty() && !hasParts) {
            return false; // so that a world without attachments pays nothing
        }
        for (BodyState each : bodies.values()) {
            isOther |= each.isThere(engine) && !Objects.equals(each.root, attachments.root(each.name));
        }
        if (!isOther) {
            return false;
        }
        part();
        hasParts = true;
        for (BodyState each : List.copyOf(bodies.values())) {
            each.root = each.isThere(engine) ? attachments.root(each.name) : null;
        }
        for (BodyState each : List.copyOf(bodies.values())) {
            BodyState carrier = each.root == null ? null : bodies.get(each.root);
            if (carrier == null || !carrier.isThere(engine)) {
                each.vx = each.root == null ? each.vx : 0; // what has no body stands still
                each.vz = each.root == null ? each.vz : 0;
                each.w = each.root == null ? each.w : 0;
            } else if (!carrier.isLoaded) {
                join(carrier);
            }
        }
        return true;
    }

    /** Forgets what is attached, until the next {@link #assemble}. */
    void disband() {
        if (hasParts || !engine.registry.attachments.isEmpty()) {
            part();
            assembledAt = -1;
        }
    }

    /** Lets each part go on by itself, as fast as it went. */
    private void part() {
        for (BodyState each : bodies.values()) {
            if (each.root != null) {
                each.follow(whole(each));
            }
        }
        for (BodyState each : bodies.values()) {
            boolean isPlaced = each.isThere(engine);
            if ((each.root != null || each.isLoaded) && isPlaced) {
                Pose pose = engine.registry.attacher.part(each.name).pose();
                each.part(pose.heading(), pose.lostHeading());
            }
        }
    }

    /** Makes one body of all that is attached to one: their mass, inertia, momentum and angular momentum are its own. */
    private void join(BodyState carrier) {
        List<BodyState> parts = new ArrayList<>();
        List<Pose> poses = new ArrayList<>();
        Attachments.forEachPart(engine.objects.present(engine.objects.find(carrier.name)), (name, pose) -> {
            BodyState part = bodies.get(name);
            if (part != null && part.isThere(engine)) {
                parts.add(part);
                poses.add(pose);
            }
        });
        double mass = 0;
        double[] centre = new double[4]; // x and z, and the momentum along them
        for (int k = 0; k < parts.size(); k++) {
            BodyState each = parts.get(k);
            double m = each.body.mass();
            mass += m;
            centre[0] += m * poses.get(k).center().x();
            centre[1] += m * poses.get(k).center().z();
            centre[2] += m * each.vx;
            centre[3] += m * each.vz;
        }
        for (int k = 0; k < 4; k++) {
            centre[k] /= mass;
        }
        double inertia = 0;
        double spin = 0;
        for (int k = 0; k < parts.size(); k++) {
            BodyState each = parts.get(k);
            double m = each.body.mass();
            double own = each.body.aboutVertical(poses.get(k).rotation(), 0);
            double x = poses.get(k).center().x() - centre[0];
            double z = poses.get(k).center().z() - centre[1];
            inertia += own + m * (x * x + z * z);
            spin += own * each.w + m * (z * (each.vx - centre[2]) - x * (each.vz - centre[3]));
            double sin = Degrees.sin(poses.get(k).heading(), poses.get(k).lostHeading());
            double cos = Degrees.cos(poses.get(k).heading(), poses.get(k).lostHeading());
            each.armX = x * cos - z * sin;
            each.armZ = x * sin + z * cos;
        }
        carrier.isLoaded = true;
        carrier.vx = centre[2];
        carrier.vz = centre[3];
        carrier.w = spin / inertia;
        carrier.acting = carrier.body.with(mass, inertia);
    }

    /** Refuses bodies that carry others where they could fall. */
    void refuse() {
        if (engine.registry.attachments.isEmpty()) {
            return;
        }
        for (BodyState each : bodies.values()) {
            String other = engine.registry.attachments.root(each.name);
            if (each.isThere(engine)
                    && (other != null || Attachments.carries(engine.objects.value(engine.objects.find(each.name))))) {
                throw new IllegalArgumentException(
                        "world must be PLANAR where bodies are attached to each other; detach"
                                + " them, or take the body from \"" + each.name + "\" (got: a SPATIAL one)");
            }
        }
    }
}
