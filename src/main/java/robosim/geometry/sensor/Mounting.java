package robosim.geometry.sensor;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.Snapshot;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;

/** Where a sensor is: on a moveable object, in that object's own frame, or in the world. */
final class Mounting {
    /** At the world's origin, carried by nothing. */
    static final Mounting ORIGIN = new Mounting(null, Pose.ORIGIN);

    private final @Nullable String carrier;
    private final Pose pose;

    private Mounting(@Nullable String carrier, Pose pose) {
        this.carrier = carrier;
        this.pose = pose;
    }

    static Mounting on(String carrier, Pose mount) {
        return new Mounting(Checks.name(carrier), Checks.present("mount", mount));
    }

    static Mounting at(Pose sensor) {
        return new Mounting(null, Checks.present("sensor", sensor));
    }

    @Nullable
    String carrier() {
        return carrier;
    }

    Pose pose() {
        return pose;
    }

    void sense(Geometry world, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        if (carrier == null) {
            world.sense(pose, pattern, options, out);
        } else {
            world.sense(carrier, pose, pattern, options, out);
        }
    }

    void sense(Snapshot world, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        if (carrier == null) {
            world.sense(pose, pattern, options, out);
        } else {
            world.sense(carrier, pose, pattern, options, out);
        }
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Mounting that && Objects.equals(carrier, that.carrier) && pose.equals(that.pose);
    }

    @Override
    public int hashCode() {
        return 31 * Objects.hashCode(carrier) + pose.hashCode();
    }

    @Override
    public String toString() {
        return carrier == null ? "at " + pose : "on \"" + carrier + "\" at " + pose;
    }
}
