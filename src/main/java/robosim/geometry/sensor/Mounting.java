package robosim.geometry.sensor;

import org.jspecify.annotations.Nullable;
import robosim.geometry.SenseBuffer;
import robosim.geometry.WorldQueries;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;

/** Where a sensor is: on a moveable object, in that object's own frame, or in the world if there is no carrier. */
record Mounting(@Nullable String carrier, Pose pose) {
    /** At the world's origin, carried by nothing. */
    static final Mounting ORIGIN = new Mounting(null, Pose.ORIGIN);

    static Mounting on(String carrier, Pose mount) {
        return new Mounting(Checks.name(carrier), Checks.present("mount", mount));
    }

    static Mounting at(Pose sensor) {
        return new Mounting(null, Checks.present("sensor", sensor));
    }

    void sense(WorldQueries world, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        if (carrier == null) {
            world.sense(pose, pattern, options, out);
        } else {
            world.sense(carrier, pose, pattern, options, out);
        }
    }

    @Override
    public String toString() {
        return carrier == null ? "at " + pose : "on \"" + carrier + "\" at " + pose;
    }
}
