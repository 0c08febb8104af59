package robosim.geometry.protocol;

import java.io.Serial;
import java.util.List;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.CopyRequest;
import robosim.geometry.protocol.batch.MeasureRequest;
import robosim.geometry.protocol.batch.PictureRequest;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.WorldRequest;

/**
 * Requests of several kinds, carried out in order: all beams of sensors, many poses and edges of planners, pictures,
 * changes of the world and questions about it; answered by a {@link BatchAnswerBundle} with one answer for each request, in
 * order.
 *
 * @param requests what to find out
 */
public record BatchRequestBundle(List<BatchRequest> requests) implements Bundle {
    @Serial
    private static final long serialVersionUID = 1;

    /**
     * Refuses a list or a request that is null, and more than {@link MessageLimits#MAX_BEAMS} beams, {@link MessageLimits#MAX_POSES}
     * poses, edges and requests of other kinds, {@link MessageLimits#MAX_PICTURE_PIXELS} pixels or {@link MessageLimits#MAX_PICTURE_RAYS} rays for
     * them, counted in every request that refers to them.
     */
    public BatchRequestBundle {
        requests = Checks.copy("requests", requests, BatchRequest.class);
        long beams = 0;
        long places = 0;
        long pixels = 0;
        long rays = 0;
        for (BatchRequest request : requests) {
            if (request instanceof SenseRequest || request instanceof CopyRequest.Tick) {
                beams += request.size();
            } else if (request instanceof PictureRequest picture) {
                pixels += picture.size();
                rays += picture.rays(); // one has fewer than 2^42, and a list fewer than 2^21 items
            } else {
                places += request.size();
            }
        }
        check("beams", beams, MessageLimits.MAX_BEAMS);
        check("poses, edges and requests of other kinds", places, MessageLimits.MAX_POSES);
        check("pixels", pixels, MessageLimits.MAX_PICTURE_PIXELS);
        check(
                "rays for pictures (pixels times samples times sources of light and one times mirrors and one)",
                rays,
                MessageLimits.MAX_PICTURE_RAYS);
    }

    private static void check(String what, long count, int most) {
        if (count > most) {
            throw new IllegalArgumentException(
                    "requests must have at most " + most + " " + what + " together (got: " + count + ")");
        }
    }

    /** How many beams, poses, edges and pixels there are in all. */
    public int size() {
        int size = 0;
        for (BatchRequest request : requests) {
            size += request.size();
        }
        return size;
    }

    /** About how many bytes of memory it takes to answer this: far more than the message has, where that describes a pattern. */
    public long workBytes() {
        long bytes = 0;
        for (BatchRequest request : requests) {
            bytes +=
                    request instanceof WorldRequest about ? about.answerBytes() : bytesOfItem(request) * request.size();
        }
        return bytes;
    }

    private static long bytesOfItem(BatchRequest request) {
        if (request instanceof CopyRequest) {
            return 64L; // a beam, or a body's state
        }
        if (request instanceof SenseRequest sense) {
            // A beam's direction, distance, normal and object: while they are found, as an answer, and as bytes.
            return 64L + (sense.normals() ? 80L : 0) + (sense.objects() ? 96L : 0);
        }
        if (request instanceof MeasureRequest measure) {
            // A number: while it is found, as an answer, and as bytes.
            return 32L * measure.question().answered;
        }
        // A pixel: as a number, and as three bytes in the answer, on the way, and in base64.
        return request instanceof PictureRequest picture ? 16L + 24L * picture.samples() * picture.samples() : 1L;
    }
}
