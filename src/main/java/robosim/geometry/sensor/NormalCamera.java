package robosim.geometry.sensor;

import robosim.geometry.SenseBuffer;
import robosim.geometry.check.Checks;
import robosim.geometry.model.SenseOptions;

/**
 * A camera that sees surface normals, for training and tests.
 *
 * <pre>{@code
 * Geometry world = new Geometry(20, 4, 20);
 * world.addObject(new BoxObject(new Point(5, 0, 0), 2, 2, 2));
 * NormalFrame image = new NormalFrame();
 * NormalCamera.of(Intrinsics.fieldOfView(5, 5, 20)).read(world, image);
 * image.normalX(12); // -1: the middle pixel sees the face of the box that looks back at the camera
 * }</pre>
 *
 * <p>Unless told otherwise it sees from 0 to infinity. Noise changes its distances only.
 */
public final class NormalCamera extends RaySensor<NormalCamera, NormalFrame> {
    private final Intrinsics intrinsics;

    private NormalCamera(Setup setup, Intrinsics intrinsics) {
        super(setup);
        this.intrinsics = intrinsics;
    }

    /** A camera at the world's origin, which looks along X. */
    public static NormalCamera of(Intrinsics intrinsics) {
        Checks.present("intrinsics", intrinsics);
        return new NormalCamera(
                Setup.of(intrinsics.pattern(), SenseOptions.range(0, Double.POSITIVE_INFINITY)), intrinsics);
    }

    /** Size and lens. */
    public Intrinsics intrinsics() {
        return intrinsics;
    }

    @Override
    NormalCamera with(Setup other) {
        return new NormalCamera(other, intrinsics);
    }

    @Override
    boolean needs(SenseBuffer.Extra extra, NormalFrame out) {
        return extra == SenseBuffer.Extra.NORMALS;
    }
}
