package robosim.geometry.sensor;

import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.SenseOptions;

/**
 * A camera whose pixels are rays: one that sees depths, surface normals, or which object each pixel belongs to.
 *
 * <pre>{@code
 * Geometry world = new Geometry(20, 4, 20);
 * world.addObject(new BoxObject(new Point(5, 0, 0), 2, 2, 2).named("crate"));
 * Intrinsics lens = Intrinsics.fieldOfView(5, 5, 90);
 *
 * DepthFrame depths = new DepthFrame();
 * Camera.depth(lens).withRange(0.3, 10).read(world, depths);
 * depths.depth(12);            // 4.0: in the middle of the picture
 *
 * NormalFrame normals = new NormalFrame();
 * Camera.normals(lens).read(world, normals);
 * normals.normalX(12);         // -1: the face of the box that looks back at the camera
 *
 * SegmentationFrame objects = new SegmentationFrame();
 * Camera.segmentation(lens).read(world, objects);
 * objects.object(12).name();   // "crate"
 * objects.instance(12);        // 1: the first object that this frame has seen
 * objects.instance(0);         // 0: nothing
 * }</pre>
 *
 * <p>Ranges, like noise, are those along the ray; noise changes distances only. Unless told otherwise a camera sees from 0 to
 * infinity.
 *
 * @param <F> its images
 */
public final class Camera<F extends RayFrame> extends RaySensor<Camera<F>, F> {
    private final Intrinsics intrinsics;
    private final String kind;

    private Camera(Setup setup, Intrinsics intrinsics, String kind) {
        super(setup);
        this.intrinsics = intrinsics;
        this.kind = kind;
    }

    /** A camera at the world's origin that looks along X, with for each pixel a distance along its ray and a depth along the optical axis. */
    public static Camera<DepthFrame> depth(Intrinsics intrinsics) {
        return of(intrinsics, "DepthCamera");
    }

    /** A camera at the world's origin that looks along X and sees surface normals, for training and tests. */
    public static Camera<NormalFrame> normals(Intrinsics intrinsics) {
        return of(intrinsics, "NormalCamera");
    }

    /** A camera at the world's origin that looks along X and sees which object each pixel belongs to. */
    public static Camera<SegmentationFrame> segmentation(Intrinsics intrinsics) {
        return of(intrinsics, "SegmentationCamera");
    }

    private static <F extends RayFrame> Camera<F> of(Intrinsics intrinsics, String kind) {
        Checks.present("intrinsics", intrinsics);
        SenseOptions everything = SenseOptions.range(0, Double.POSITIVE_INFINITY);
        return new Camera<>(Setup.of(intrinsics.pattern(), everything), intrinsics, kind);
    }

    /** Size and lens. */
    public Intrinsics intrinsics() {
        return intrinsics;
    }

    @Override
    Camera<F> with(Setup other) {
        return new Camera<>(other, intrinsics, kind);
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof Camera<?> that && kind.equals(that.kind) && super.equals(other);
    }

    @Override
    public int hashCode() {
        return 31 * super.hashCode() + kind.hashCode();
    }

    @Override
    String kind() {
        return kind;
    }
}
