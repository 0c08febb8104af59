package robosim.geometry.protocol;

import java.io.Serial;
import java.util.List;
import robosim.geometry.exact.Checks;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.SenseRequest;

/**
 * Requests of several kinds, carried out in order: all beams of sensors, many poses and edges of planners, changes of the
 * world and questions about it; answered by a {@link BatchAnswerBundle} with one answer for each request, in order.
 *
 * @param requests what to find out
 */
public record BatchRequestBundle(List<BatchRequest> requests) implements Bundle {
    @Serial
    private static final long serialVersionUID = 1;

    /**
     * Refuses a list or a request that is null, and more than {@link MessageLimits#MAX_BEAMS} beams or {@link MessageLimits#MAX_POSES}
     * poses, edges and requests of other kinds, counted in every request that refers to them.
     */
    public BatchRequestBundle {
        requests = Checks.copy("requests", requests, BatchRequest.class);
        check("beams", beams(requests), MessageLimits.MAX_BEAMS);
        check("poses, edges and requests of other kinds", size(requests) - beams(requests), MessageLimits.MAX_POSES);
    }

    private static void check(String what, long count, int most) {
        if (count > most) {
            throw new IllegalArgumentException(
                    "requests must have at most " + most + " " + what + " together (got: " + count + ")");
        }
    }

    private static long beams(List<BatchRequest> requests) {
        long beams = 0;
        for (BatchRequest request : requests) {
            beams += request instanceof SenseRequest ? request.size() : 0;
        }
        return beams;
    }

    private static long size(List<BatchRequest> requests) {
        long size = 0;
        for (BatchRequest request : requests) {
            size += request.size();
        }
        return size;
    }

    /** How many beams, poses and edges there are in all, each request of another kind counted as one. */
    public int size() {
        return (int) size(requests);
    }

    /** About how many bytes of memory it takes to answer this: far more than the message has, where that describes a pattern. */
    public long workBytes() {
        long bytes = 0;
        for (BatchRequest request : requests) {
            // A beam's direction, distance, normal and object: while they are found, as an answer, and as bytes.
            boolean isSense = request instanceof SenseRequest;
            boolean hasNormals = isSense && ((SenseRequest) request).normals();
            boolean hasObjects = isSense && ((SenseRequest) request).objects();
            bytes += (isSense ? 64L : 1L) * request.size();
            bytes += (hasNormals ? 80L : 0) * request.size() + (hasObjects ? 96L : 0) * request.size();
        }
        return bytes;
    }
}
