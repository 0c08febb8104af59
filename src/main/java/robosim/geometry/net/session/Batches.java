package robosim.geometry.net.session;

import java.util.List;
import robosim.geometry.Avoidance;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SenseBuffer.Extra;
import robosim.geometry.check.Checks;
import robosim.geometry.collision.SignedDistance;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.FreeAnswer;
import robosim.geometry.protocol.batch.FreeEdgesRequest;
import robosim.geometry.protocol.batch.FreePosesRequest;
import robosim.geometry.protocol.batch.MeasureRequest;
import robosim.geometry.protocol.batch.MeasureRequest.Question;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.PictureRequest;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;

/** Carries out requests with packed numbers, a part at a time, so that one message cannot keep others waiting. */
public final class Batches {
    /** Beams, poses or edges between two breaths: a word of bits, and a tile of a pattern, whose beams share work. */
    private static final int PART = 64;

    private final RayPatterns patterns = new RayPatterns();
    private final SenseBuffer distances = new SenseBuffer();
    private final SenseBuffer normals = new SenseBuffer(Extra.NORMALS);
    private final SenseBuffer objects = new SenseBuffer(Extra.OBJECTS, Extra.PARTS);
    private final SenseBuffer all = new SenseBuffer(Extra.OBJECTS, Extra.PARTS, Extra.NORMALS);
    private final Pictures pictures = new Pictures();
    private final long[] word = new long[1];

    /**
     * Answers a request that names a moveable object, or needs none.
     *
     * @param breath runs before each part of the work
     * @throws IllegalArgumentException if the world refuses the request
     */
    public BatchAnswer answer(Geometry world, BatchRequest request, Runnable breath) {
        if (request instanceof SenseRequest sense) {
            return sense(world, sense, breath);
        }
        if (request instanceof PictureRequest picture) {
            return pictures.take(world, picture, breath);
        }
        if (request instanceof MeasureRequest measure) {
            return measure(world, measure, breath);
        }
        boolean isPoses = request instanceof FreePosesRequest;
        Numbers places = isPoses ? ((FreePosesRequest) request).poses() : ((FreeEdgesRequest) request).edges();
        return free(world, request, places, isPoses, breath);
    }

    /** Forgets what only the last bundle needed. */
    public void rest() {
        patterns.trim();
        pictures.rest();
    }

    /** Forgets the world. */
    public void forget() {
        pictures.forget();
    }

    private SenseAnswer sense(Geometry world, SenseRequest request, Runnable breath) {
        breath.run();
        RayPattern pattern = patterns.of(request.pattern());
        Pose mount = request.mount().pose();
        // An echo at the blind range differs from a nearer one only where all are measured.
        double min = request.rep117() ? 0 : request.min();
        SenseOptions options = SenseOptions.range(min, request.max())
                .withWidth(Degrees.toDegrees(request.width()))
                .withCarrier(request.seesCarrier() ? SenseOptions.Carrier.SEEN : SenseOptions.Carrier.IGNORED)
                .ignoring(request.ignored().toArray(String[]::new));
        ScanMotion motion = request.motion();
        if (!motion.equals(ScanMotion.NONE)) {
            options = options.withMotion(motion.twist(Degrees.toDegrees(motion.ry())));
            pattern = pattern.withDuration(motion.duration());
        }
        if (options.width() == 0 && !pattern.isLevel()) { // which a part of it may be alone
            options = options.withHeights();
        }
        SenseBuffer buffer =
                request.objects() ? request.normals() ? all : objects : request.normals() ? normals : distances;
        int size = pattern.size();
        double[] measured = new double[size];
        double[] faces = new double[request.normals() ? 3 * size : 0];
        SeenObjects seen = new SeenObjects(request.objects() ? size : 0);
        for (int first = 0; first < size; first += PART) {
            breath.run();
            int count = Math.min(PART, size - first);
            sense(world, request.objectName(), mount, part(pattern, first, count), first, options, buffer);
            System.arraycopy(buffer.distances(), 0, measured, first, count);
            if (request.rep117()) {
                markNearer(measured, first, count, request.min());
            }
            if (request.normals()) {
                System.arraycopy(buffer.normals(), 0, faces, 3 * first, 3 * count);
            }
            if (request.objects()) {
                seen.take(buffer, first);
            }
        }
        return new SenseAnswer(new Numbers(measured), new Numbers(faces), seen.names(), seen.objects(), seen.labels());
    }

    private static void markNearer(double[] measured, int first, int count, double min) {
        for (int k = first; k < first + count; k++) {
            if (measured[k] < min) {
                measured[k] = SenseAnswer.NEARER;
            }
        }
    }

    private static RayPattern part(RayPattern pattern, int first, int count) {
        if (count == pattern.size()) {
            return pattern;
        }
        double[] directions = new double[3 * count];
        pattern.directions(first, count, directions, 0);
        RayPattern part = RayPattern.of(directions);
        if (!pattern.hasTimes()) {
            return part;
        }
        double[] times = new double[count];
        for (int k = 0; k < count; k++) {
            times[k] = pattern.time(first + k);
        }
        return part.withTimes(times);
    }

    private static void sense(
            Geometry world,
            String name,
            Pose mount,
            RayPattern part,
            int first,
            SenseOptions options,
            SenseBuffer out) {
        try {
            if (name.isEmpty()) {
                world.sense(mount, part, options, out);
            } else {
                world.sense(name, mount, part, options, out);
            }
        } catch (IllegalArgumentException e) {
            throw first == 0 ? e : new IllegalArgumentException("from beam " + first + " on, " + e.getMessage(), e);
        }
    }

    private FreeAnswer free(Geometry world, BatchRequest request, Numbers places, boolean isPoses, Runnable breath) {
        int stride = isPoses ? FreePosesRequest.STRIDE : FreeEdgesRequest.STRIDE;
        int size = request.size();
        long[] free = new long[(size + PART - 1) / PART];
        double[] part = new double[0];
        for (int first = 0; first < size; first += PART) {
            breath.run();
            int numbers = stride * Math.min(PART, size - first);
            part = part.length == numbers ? part : new double[numbers];
            places.copy(stride * first, numbers, part);
            for (int k = FreePosesRequest.STRIDE - 1; k < numbers; k += FreePosesRequest.STRIDE) {
                part[k] = Degrees.toDegrees(part[k]);
            }
            if (isPoses) {
                world.freePoses(request.objectName(), part, word);
            } else {
                world.freeEdges(request.objectName(), part, word);
            }
            free[first / PART] = word[0];
        }
        return FreeAnswer.of(size, free);
    }

    private static MeasureRequest.Answer measure(Geometry world, MeasureRequest request, Runnable breath) {
        Question question = request.question();
        Avoidance avoid = Avoidance.margin(request.margin()).andIgnoring(request.ignored());
        int size = request.size();
        double[] numbers = new double[question.answered * size];
        for (int first = 0; first < size; first += PART) {
            breath.run();
            int count = Math.min(PART, size - first);
            double[] given = new double[question.given * count];
            double[] found = new double[question.answered * count];
            request.numbers().copy(question.given * first, given.length, given);
            for (int k = 0; k < given.length; k++) {
                int of = k % question.given;
                // The heading of each pose, and a drive's speed of turning.
                given[k] = of == 3 || of == 7 ? Degrees.toDegrees(given[k]) : given[k];
            }
            String name = request.objectName();
            switch (question) {
                case DISTANCES, CLEARANCES -> world.clearances(name, given, request.max(), avoid, found);
                case EDGES -> world.edgeFractions(name, given, avoid, found);
                case DRIVES -> world.driveFractions(name, given, avoid, found);
                case SIGNED -> write(world.signedDistance(name, Checks.present("other", request.other())), found);
            }
            System.arraycopy(found, 0, numbers, question.answered * first, found.length);
        }
        return new MeasureRequest.Answer(new Numbers(numbers));
    }

    private static void write(SignedDistance signed, double[] out) {
        out[0] = signed.low();
        out[1] = signed.high();
        int at = 2;
        for (Point point : List.of(signed.onA(), signed.onB(), signed.direction())) {
            out[at++] = point.x();
            out[at++] = point.y();
            out[at++] = point.z();
        }
    }
}
