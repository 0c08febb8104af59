package robosim.geometry.net.session;

import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.SenseBuffer;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.protocol.WorldSettings;

/** The operations that a session needs of a world; angles in degrees. */
public interface World {
    /** Adds an object; returns false if it would leave the world. */
    boolean add(GeometryObject object);

    /**
     * Adds an object, unless an earlier one has its name.
     *
     * @param names those of the earlier objects
     * @return why it was not added, or null
     */
    default @Nullable String refusal(GeometryObject object, Set<String> names) {
        String name = object.name();
        if (name != null && names.contains(name)) {
            return "an earlier object has its name";
        }
        try {
            return add(object) ? null : "it would leave the world";
        } catch (IllegalArgumentException e) {
            return Reasons.of(e);
        }
    }

    MoveResult move(String name, Move move);

    double sonar(String name, double x, double z, double min, double max, double width);

    /**
     * All beams of a pattern.
     *
     * @param name  of the object that carries the sensor; empty for one that nothing carries
     * @param mount on the object, or in the world
     */
    void sense(String name, Pose mount, RayPattern pattern, SenseOptions options, SenseBuffer out);

    /** Whether an object could stand at poses. */
    void freePoses(String name, double[] poses, long[] free);

    /** Whether an object could go along edges. */
    void freeEdges(String name, double[] edges, long[] free);

    /** The geometry behind it; null if it is not one of this module's worlds. */
    default @Nullable Geometry geometry() {
        return null;
    }

    /** Creates worlds. */
    @FunctionalInterface
    interface Maker {
        World make(WorldSettings settings);
    }

    /** A new world of this module, whose settings are complete. */
    static World of(WorldSettings settings) {
        return over(new Geometry(
                settings.width(),
                settings.height(),
                settings.length(),
                Checks.present("dimension", settings.dimension()),
                Checks.present("accuracy", settings.accuracy())));
    }

    /** A world over an existing geometry. */
    static World over(Geometry geometry) {
        return new World() {
            @Override
            public boolean add(GeometryObject object) {
                return geometry.addObjectUnchecked(object);
            }

            @Override
            public MoveResult move(String name, Move move) {
                return geometry.move(name, move);
            }

            @Override
            public double sonar(String name, double x, double z, double min, double max, double width) {
                return geometry.getSonarDistance(name, x, z, min, max, width);
            }

            @Override
            public void sense(String name, Pose mount, RayPattern pattern, SenseOptions options, SenseBuffer out) {
                if (name.isEmpty()) {
                    geometry.sense(mount, pattern, options, out);
                } else {
                    geometry.sense(name, mount, pattern, options, out);
                }
            }

            @Override
            public void freePoses(String name, double[] poses, long[] free) {
                geometry.freePoses(name, poses, free);
            }

            @Override
            public void freeEdges(String name, double[] edges, long[] free) {
                geometry.freeEdges(name, edges, free);
            }

            @Override
            public Geometry geometry() {
                return geometry;
            }
        };
    }
}
