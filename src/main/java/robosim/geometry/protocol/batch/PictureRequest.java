package robosim.geometry.protocol.batch;

import java.io.Serial;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;

/**
 * A request for a picture in colour, in a SPATIAL world; answered by a {@link PictureAnswer}. The optical axis is the
 * camera's own X, and Y is up in the picture.
 *
 * @param objectName  the name of the moveable object that carries the camera; empty for one that nothing carries
 * @param mount       where on the object the camera is, and which way it faces; in the world if nothing carries it
 * @param camera      its pixels and its field of view
 * @param samples     of each pixel, along each axis, from 1 to {@link #MOST_SAMPLES}
 * @param mirrors     how many mirrors a ray may meet one after the other, from 0 to {@link #MOST_MIRRORS}
 * @param seesCarrier whether the object that carries the camera is seen like any other
 * @param light       null for a clear day
 */
public record PictureRequest(
        String objectName,
        Mount mount,
        BeamPattern.Pinhole camera,
        int samples,
        int mirrors,
        boolean seesCarrier,
        @Nullable SceneLight light)
        implements BatchRequest {
    @Serial
    private static final long serialVersionUID = 1;

    /** The most samples of a pixel along each axis. */
    public static final int MOST_SAMPLES = 16;

    /** The most mirrors on the way of a sample. A hall of mirrors is dark after about eight. */
    public static final int MOST_MIRRORS = 16;

    /** How many mirrors there are unless a request says so. */
    public static final int USUAL_MIRRORS = 3;

    /** Refuses null and numbers out of range. */
    public PictureRequest {
        Checks.present("objectName", objectName);
        Checks.present("mount", mount);
        Checks.present("camera", camera);
        check("samples", samples, 1, MOST_SAMPLES);
        check("mirrors", mirrors, 0, MOST_MIRRORS);
    }

    /** A picture on a clear day, one sample for each pixel. */
    public PictureRequest(String objectName, Mount mount, BeamPattern.Pinhole camera) {
        this(objectName, mount, camera, 1, USUAL_MIRRORS, false, null);
    }

    private static void check(String argument, int value, int least, int most) {
        if (value < least || value > most) {
            throw new IllegalArgumentException(
                    argument + " must be from " + least + " to " + most + " (got: " + value + ")");
        }
    }

    /** Whether an object carries the camera. */
    public boolean isCarried() {
        return !objectName.isEmpty();
    }

    @Override
    public boolean isAboutMover() {
        return isCarried();
    }

    @Override
    public int size() {
        return camera.size();
    }

    /** The most rays that it takes: for each sample one, and one to each source of light; and as many for each mirror. */
    public long rays() {
        long sources = light == null ? 1 : light.sources().size();
        return (long) size() * samples * samples * (1 + sources) * (1 + mirrors);
    }
}
