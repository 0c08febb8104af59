package robosim.geometry.world.sdf;

import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.world.xml.ChildNames;

/**
 * The relevant elements of SDFormat up to 1.12: which are read, which are irrelevant to solid geometry, and which are
 * relevant but not supported. Visuals, lights and scenes are read, and count as irrelevant to what is solid nevertheless.
 */
public final class SdfNames {
    /** Names here of the models, links and names within a state, which are others than those of a world. */
    private static final String MODEL_STATE = "model_state";

    private static final String LINK_STATE = "link_state";
    private static final String DELETED = "deleted";

    /** How far a light reaches, which is another range than that of a sensor. */
    static final String LIGHT_RANGE = "light_range";

    /** Of a world, without effect on anything solid; also in a model, where they have none at all. */
    private static final Set<String> OF_WORLDS = ChildNames.words(
            "atmosphere audio gravity gui joint light magnetic_field physics plugin road scene spherical_coordinates wind");

    /** By element, the children that are read. */
    private static final ChildNames READ = new ChildNames("""
            sdf: world model light
            world: model include frame state light scene
            state: model_state insertions deletions
            insertions: model
            deletions: deleted
            model_state: pose scale model_state link_state
            link_state frame: pose
            model: model include link frame joint pose static
            include: uri name pose static placement_frame
            link: pose collision visual sensor light
            light: pose diffuse intensity direction attenuation spot cast_shadows light_on
            attenuation: light_range constant linear quadratic
            spot: outer_angle
            scene: ambient background shadows sky
            sensor: pose update_rate lidar ray camera
            lidar ray: scan range noise
            scan: horizontal vertical
            horizontal vertical: samples resolution min_angle max_angle
            range: min max resolution
            camera: pose horizontal_fov image clip noise lens distortion
            lens: intrinsics projection
            intrinsics: fx fy cx cy s
            projection: p_fx p_fy p_cx p_cy tx ty
            distortion: k1 k2 k3 p1 p2 center
            image: width height
            clip: near far
            noise: type mean stddev bias_mean bias_stddev precision dynamic_bias_stddev dynamic_bias_correlation_time
            visual: pose geometry material
            material: diffuse emissive shininess specular script pbr
            pbr: metal
            metal: albedo_map metalness roughness
            script: name
            collision: pose geometry
            joint: pose child
            geometry: box capsule cone cylinder ellipsoid empty heightmap image mesh plane polyline sphere
            box: size
            capsule cylinder cone: radius length
            sphere: radius
            plane: normal size
            ellipsoid: radii
            polyline: point height
            heightmap: uri size pos sampling
            submesh: name center
            mesh: uri scale submesh
            """);

    /** By element, the children that are ignored; all others if none are named. */
    private static final ChildNames PASSED_OVER = new ChildNames("""
            sdf: light plugin
            state insertions deletions model_state link_state:
            sensor lidar ray scan horizontal vertical range camera clip lens intrinsics projection distortion noise:
            visual material pbr metal script joint empty heightmap image light attenuation spot scene sky:
            model: allow_auto_disable enable_wind gripper plugin self_collide
            include: namespace plugin
            link: audio_sink audio_source battery enable_wind frame gravity inertial kinematic light must_be_base_link
            link: particle_emitter plugin projector self_collide sensor velocity velocity_decay acceleration wrench visual
            collision: auto_inertia_params density frame laser_retro max_contacts surface
            mesh: convex_decomposition
            """);

    private SdfNames() {}

    /** The name under which a child is kept. */
    static String kept(String parent, String child) {
        boolean isInState = parent.equals("state") || parent.equals(MODEL_STATE);
        if (isInState && child.equals("model")) {
            return MODEL_STATE;
        }
        if (isInState && child.equals("link")) {
            return LINK_STATE;
        }
        if (parent.equals("attenuation") && child.equals("range")) {
            return LIGHT_RANGE;
        }
        return parent.equals("deletions") && child.equals("name") ? DELETED : child;
    }

    static boolean isRead(String parent, String child) {
        return READ.of(parent).contains(child);
    }

    /** Whether an element may have any number of these children; of all others it has at most one. */
    static boolean isRepeated(String child) {
        return switch (child) {
            case "world",
                    "model",
                    "include",
                    "link",
                    "frame",
                    "joint",
                    "collision",
                    "visual",
                    "point",
                    "sensor",
                    "light" -> true;
            case "state", MODEL_STATE, LINK_STATE, DELETED -> true;
            case "material", "script", "diffuse", "emissive", "shininess", "specular", "pbr", "metal" ->
                true; // harmless: the first one counts
            default -> false;
        };
    }

    static boolean isPassedOver(String parent, String child) {
        Set<String> names = PASSED_OVER.of(parent);
        return (PASSED_OVER.has(parent) && (names.isEmpty() || names.contains(child)))
                || (parent.equals("world") && OF_WORLDS.contains(child))
                || child.startsWith("gz:") // Gazebo's own extensions, which say nothing of shapes and places
                || child.startsWith("ignition:")
                || (parent.equals("model") && (OF_WORLDS.contains(child) || child.equals("state")));
    }

    /** Whether ignored children of an element are separate things rather than mere properties. */
    static boolean isCounted(String parent) {
        return switch (parent) {
            case "sdf", "world", "model", "include", "link", "collision" -> true;
            default -> false;
        };
    }

    /** Why a child that is neither read nor ignored is left out. */
    static String reason(String parent, String child) {
        String known = known(child);
        if (known != null) {
            return known;
        }
        return child.indexOf(':') >= 0
                ? "an extension of SDFormat of unknown meaning"
                : "SDFormat has no <" + child + "> in <" + parent + ">; check the spelling";
    }

    private static @Nullable String known(String child) {
        return switch (child) {
            case "actor" -> "an actor is moved by a script";
            case "population" -> "it places copies of a model at random";
            default -> null;
        };
    }
}
