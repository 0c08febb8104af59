package robosim.geometry.world.sdf;

import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The relevant elements of SDFormat up to 1.12: which are read, which are irrelevant to solid geometry, and which are
 * relevant but not supported. Of a visual only the material is read; it counts as irrelevant nevertheless.
 */
public final class SdfNames {
    private static final Set<String> ALL = Set.of();

    /** Names here of the models, links and names within a state, which are others than those of a world. */
    private static final String MODEL_STATE = "model_state";

    private static final String LINK_STATE = "link_state";
    private static final String DELETED = "deleted";

    /** Of a world, without effect on anything solid; also in a model, where they have none at all. */
    private static final Set<String> OF_WORLDS = Set.of(
            "atmosphere",
            "audio",
            "gravity",
            "gui",
            "joint",
            "light",
            "magnetic_field",
            "physics",
            "plugin",
            "road",
            "scene",
            "spherical_coordinates",
            "wind");

    /** By element, the children that are read. */
    private static final Map<String, Set<String>> READ = Map.ofEntries(
            Map.entry("sdf", Set.of("world", "model")),
            Map.entry("world", Set.of("model", "include", "frame", "state")),
            Map.entry("state", Set.of(MODEL_STATE, "insertions", "deletions")),
            Map.entry("insertions", Set.of("model")),
            Map.entry("deletions", Set.of(DELETED)),
            Map.entry(MODEL_STATE, Set.of("pose", "scale", MODEL_STATE, LINK_STATE)),
            Map.entry(LINK_STATE, Set.of("pose")),
            Map.entry("model", Set.of("model", "include", "link", "frame", "joint", "pose", "static")),
            Map.entry("include", Set.of("uri", "name", "pose", "static", "placement_frame")),
            Map.entry("link", Set.of("pose", "collision", "visual", "sensor")),
            Map.entry("sensor", Set.of("pose", "update_rate", "lidar", "ray", "camera")),
            Map.entry("lidar", Set.of("scan", "range", "noise")),
            Map.entry("ray", Set.of("scan", "range", "noise")),
            Map.entry("scan", Set.of("horizontal", "vertical")),
            Map.entry("horizontal", Set.of("samples", "resolution", "min_angle", "max_angle")),
            Map.entry("vertical", Set.of("samples", "resolution", "min_angle", "max_angle")),
            Map.entry("range", Set.of("min", "max", "resolution")),
            Map.entry("camera", Set.of("pose", "horizontal_fov", "image", "clip", "noise", "lens", "distortion")),
            Map.entry("lens", Set.of("intrinsics", "projection")),
            Map.entry("intrinsics", Set.of("fx", "fy", "cx", "cy", "s")),
            Map.entry("projection", Set.of("p_fx", "p_fy", "p_cx", "p_cy", "tx", "ty")),
            Map.entry("distortion", Set.of("k1", "k2", "k3", "p1", "p2")),
            Map.entry("image", Set.of("width", "height")),
            Map.entry("clip", Set.of("near", "far")),
            Map.entry(
                    "noise",
                    Set.of(
                            "type",
                            "mean",
                            "stddev",
                            "bias_mean",
                            "bias_stddev",
                            "precision",
                            "dynamic_bias_stddev",
                            "dynamic_bias_correlation_time")),
            Map.entry("visual", Set.of("material")),
            Map.entry("material", Set.of("diffuse", "emissive", "shininess", "specular")),
            Map.entry("collision", Set.of("pose", "geometry")),
            Map.entry("frame", Set.of("pose")),
            Map.entry("joint", Set.of("pose", "child")),
            Map.entry(
                    "geometry",
                    Set.of(
                            "box",
                            "capsule",
                            "cone",
                            "cylinder",
                            "ellipsoid",
                            "empty",
                            "heightmap",
                            "image",
                            "mesh",
                            "plane",
                            "polyline",
                            "sphere")),
            Map.entry("box", Set.of("size")),
            Map.entry("capsule", Set.of("radius", "length")),
            Map.entry("cylinder", Set.of("radius", "length")),
            Map.entry("sphere", Set.of("radius")),
            Map.entry("plane", Set.of("normal", "size")),
            Map.entry("cone", Set.of("radius", "length")),
            Map.entry("ellipsoid", Set.of("radii")),
            Map.entry("polyline", Set.of("point", "height")),
            Map.entry("heightmap", Set.of("uri", "size", "pos", "sampling")),
            Map.entry("submesh", Set.of("name", "center")),
            Map.entry("mesh", Set.of("uri", "scale", "submesh")));

    /** By element, the children that are ignored; all others if the set is {@link #ALL}. */
    private static final Map<String, Set<String>> PASSED_OVER = Map.ofEntries(
            Map.entry("sdf", Set.of("light", "plugin")),
            Map.entry("world", OF_WORLDS),
            Map.entry("state", ALL),
            Map.entry("insertions", ALL),
            Map.entry("deletions", ALL),
            Map.entry(MODEL_STATE, ALL),
            Map.entry(LINK_STATE, ALL),
            Map.entry("model", Set.of("allow_auto_disable", "enable_wind", "gripper", "plugin", "self_collide")),
            Map.entry("include", Set.of("namespace", "plugin")),
            Map.entry(
                    "link",
                    Set.of(
                            "audio_sink",
                            "audio_source",
                            "battery",
                            "enable_wind",
                            "frame",
                            "gravity",
                            "inertial",
                            "kinematic",
                            "light",
                            "must_be_base_link",
                            "particle_emitter",
                            "plugin",
                            "projector",
                            "self_collide",
                            "sensor",
                            "velocity",
                            "velocity_decay",
                            "acceleration",
                            "wrench",
                            "visual")),
            Map.entry(
                    "collision",
                    Set.of("auto_inertia_params", "density", "frame", "laser_retro", "max_contacts", "surface")),
            Map.entry("sensor", ALL),
            Map.entry("lidar", ALL),
            Map.entry("ray", ALL),
            Map.entry("scan", ALL),
            Map.entry("horizontal", ALL),
            Map.entry("vertical", ALL),
            Map.entry("range", ALL),
            Map.entry("camera", ALL),
            Map.entry("clip", ALL),
            Map.entry("lens", ALL),
            Map.entry("intrinsics", ALL),
            Map.entry("projection", ALL),
            Map.entry("distortion", ALL),
            Map.entry("noise", ALL),
            Map.entry("visual", ALL),
            Map.entry("material", ALL),
            Map.entry("mesh", Set.of("convex_decomposition")),
            Map.entry("joint", ALL),
            Map.entry("empty", ALL),
            Map.entry("heightmap", ALL),
            Map.entry("image", ALL));

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
        return parent.equals("deletions") && child.equals("name") ? DELETED : child;
    }

    static boolean isRead(String parent, String child) {
        return READ.getOrDefault(parent, Set.of()).contains(child);
    }

    /** Whether an element may have any number of these children; of all others it has at most one. */
    static boolean isRepeated(String child) {
        return switch (child) {
            case "world", "model", "include", "link", "frame", "joint", "collision", "visual", "point", "sensor" ->
                true;
            case "state", MODEL_STATE, LINK_STATE, DELETED -> true;
            case "material", "diffuse", "emissive", "shininess", "specular" -> true; // harmless: the first one counts
            default -> false;
        };
    }

    static boolean isPassedOver(String parent, String child) {
        Set<String> names = PASSED_OVER.get(parent);
        return (names != null && (names.isEmpty() || names.contains(child)))
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
