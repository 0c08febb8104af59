package robosim.geometry.sensor;

import robosim.geometry.check.Checks;
import robosim.geometry.model.SenseOptions;

/**
 * A depth camera: for each pixel a distance along its ray and a depth along the optical axis.
 *
 * <pre>{@code
 * DepthCamera camera = DepthCamera.of(Intrinsics.fieldOfView(320, 240, 87)).withRange(0.3, 10);
 * DepthCamera onRobot = camera.on("robot", Pose.of(new Point(0.2, 0.3, 0), 0)).withThreads(4);
 * }</pre>
 *
 * <p>Ranges, like noise, are those along the ray. Unless told otherwise the camera sees from 0 to infinity.
 */
public final class DepthCamera extends RaySensor<DepthCamera, DepthFrame> {
    private final Intrinsics intrinsics;

    private DepthCamera(Setup setup, Intrinsics intrinsics) {
        super(setup);
        this.intrinsics = intrinsics;
    }

    /** A camera at the world's origin, which looks along X. */
    public static DepthCamera of(Intrinsics intrinsics) {
        Checks.present("intrinsics", intrinsics);
        return new DepthCamera(
                Setup.of(intrinsics.pattern(), SenseOptions.range(0, Double.POSITIVE_INFINITY)), intrinsics);
    }

    /** Size and lens. */
    public Intrinsics intrinsics() {
        return intrinsics;
    }

    @Override
    DepthCamera with(Setup other) {
        return new DepthCamera(other, intrinsics);
    }

    @Override
    void finish(DepthFrame out) {
        out.finish();
    }
}
