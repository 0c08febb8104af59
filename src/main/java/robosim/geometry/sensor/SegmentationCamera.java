package robosim.geometry.sensor;

import robosim.geometry.SenseBuffer;
import robosim.geometry.check.Checks;
import robosim.geometry.model.SenseOptions;

/**
 * A camera that sees which object each pixel belongs to.
 *
 * <pre>{@code
 * Geometry world = new Geometry(20, 4, 20);
 * world.addObject(new BoxObject(new Point(5, 0, 0), 2, 2, 2).named("crate"));
 * SegmentationFrame image = new SegmentationFrame();
 * SegmentationCamera.of(Intrinsics.fieldOfView(5, 5, 90)).read(world, image);
 * image.object(12).name(); // "crate"
 * image.instance(12);      // 1: the first object that this frame has seen
 * image.instance(0);       // 0: nothing
 * }</pre>
 *
 * <p>Unless told otherwise it sees from 0 to infinity. Noise changes its distances only.
 */
public final class SegmentationCamera extends RaySensor<SegmentationCamera, SegmentationFrame> {
    private final Intrinsics intrinsics;

    private SegmentationCamera(Setup setup, Intrinsics intrinsics) {
        super(setup);
        this.intrinsics = intrinsics;
    }

    /** A camera at the world's origin, which looks along X. */
    public static SegmentationCamera of(Intrinsics intrinsics) {
        Checks.present("intrinsics", intrinsics);
        return new SegmentationCamera(
                Setup.of(intrinsics.pattern(), SenseOptions.range(0, Double.POSITIVE_INFINITY)), intrinsics);
    }

    /** Size and lens. */
    public Intrinsics intrinsics() {
        return intrinsics;
    }

    @Override
    SegmentationCamera with(Setup other) {
        return new SegmentationCamera(other, intrinsics);
    }

    @Override
    void finish(SegmentationFrame out) {
        out.finish();
    }

    @Override
    boolean needs(SenseBuffer.Extra extra, SegmentationFrame out) {
        return extra != SenseBuffer.Extra.NORMALS;
    }
}
