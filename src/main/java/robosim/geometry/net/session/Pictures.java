package robosim.geometry.net.session;

import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SenseOptions.Carrier;
import robosim.geometry.protocol.batch.PictureAnswer;
import robosim.geometry.protocol.batch.PictureRequest;
import robosim.geometry.protocol.batch.SceneLight;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.ColorFrame;
import robosim.geometry.render.Light;
import robosim.geometry.render.Lighting;
import robosim.geometry.render.Sky;

/** Takes the pictures that a session is asked for, radians to degrees. */
final class Pictures {
    /** The samples of a camera that is kept between two bundles, 24 bytes each: 320 x 240 pixels have 76,800. */
    private static final int MOST_KEPT = 1 << 17;

    private ColorFrame frame = new ColorFrame();

    // The last camera: a robot asks for the same again.
    private @Nullable PictureRequest asked;
    private @Nullable ColorCamera camera;

    /**
     * Takes a picture.
     *
     * @param breath runs before each block of it
     */
    PictureAnswer take(Geometry world, PictureRequest request, Runnable breath) {
        breath.run();
        ColorCamera by = camera;
        if (by == null || !request.equals(asked)) {
            by = made(request);
            camera = by;
            asked = request;
        }
        by.render(world, frame, percent -> breath.run());
        return PictureAnswer.of(frame.width(), frame.height(), frame.pixels());
    }

    /** Forgets what takes much memory. */
    void rest() {
        PictureRequest last = asked;
        if (last != null && (long) last.size() * last.samples() * last.samples() > MOST_KEPT) {
            forget();
        }
    }

    /** Forgets the world too. */
    void forget() {
        frame = new ColorFrame();
        camera = null;
        asked = null;
    }

    private static ColorCamera made(PictureRequest request) {
        Pose mount = request.mount().pose();
        ColorCamera free = ColorCamera.of(
                        request.camera().width(),
                        request.camera().height(),
                        Degrees.toDegrees(request.camera().fieldOfView()))
                .withSamples(request.samples())
                .withMirrors(request.mirrors())
                .withCarrier(request.seesCarrier() ? Carrier.SEEN : Carrier.IGNORED);
        SceneLight light = request.light();
        ColorCamera lit = light == null ? free : free.withLighting(lighting(light));
        return request.isCarried() ? lit.on(request.objectName(), mount) : lit.at(mount);
    }

    private static Lighting lighting(SceneLight light) {
        return new Lighting(
                new Sky(light.zenith(), light.horizon(), light.ground(), light.strength()),
                light.sources().stream().map(Pictures::source).toList());
    }

    private static Light source(SceneLight.Source source) {
        if (source instanceof SceneLight.Sun sun) {
            return new Light.Sun(sun.direction(), sun.color(), sun.strength());
        }
        if (source instanceof SceneLight.Lamp lamp) {
            return new Light.Lamp(lamp.place(), lamp.color(), lamp.strength());
        }
        SceneLight.Spot spot = (SceneLight.Spot) source;
        return new Light.Spot(
                spot.place(), spot.direction(), Degrees.toDegrees(spot.angle()), spot.color(), spot.strength());
    }
}
