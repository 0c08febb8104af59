package robosim.geometry.engine.sensing;

import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.ConeCandidates;
import robosim.geometry.engine.broadphase.ObjectRegistry;
import robosim.geometry.engine.broadphase.PacketSearch;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.narrow.Scratch;

/**
 * All beams of a pattern from one place, or from a sensor that moves meanwhile. They are answered tile by tile, and what the
 * beams of a tile share is found once: rays are one {@link PacketSearch}.
 *
 * <p>In a PLANAR world sonars and level lasers measure in the plane; a sensor that looks up or down sees the objects with
 * their heights.
 */
public final class PatternSensor {
    private static final int TILE = BeamTiles.MOST;

    /** Fewer rays are answered one by one just as fast. */
    private static final int FEW = 4;

    /** The same in a world without heights, where cones are always answered one by one: its quadtree finds them as soon. */
    private static final int FEW_IN_PLANE = 8;

    private static final double[] NONE = new double[0];

    private final ObjectRegistry registry;
    private final ObjectTable objects;
    private final BeamQuery ranging;
    private final Scratch scratch;
    private final BeamTiles tiling = new BeamTiles();
    private final SensorFrame frame;

    /** Made for the first tile. */
    private @Nullable PacketSearch packets;

    private @Nullable ConeCandidates surroundings;

    private final double[] vector = new double[3];
    private final ScanDirections scans = new ScanDirections();

    /** The directions of the tile in the world, three numbers each; made for the first one, as many worlds have no sensor. */
    private double[] directions = NONE;

    /** By beam of the tile, where its answer is to stand. */
    private int[] beams = new int[0];

    /** When the beams of the tile are fired, if the sensor moves. */
    private double[] times = NONE;

    private double[] distances = NONE;

    /** What takes more than distances; null if nothing does. */
    private @Nullable BeamResults more;

    // What is asked of each beam.
    private double min;
    private double max;
    private double width;

    /** The object that does not echo; -1 for none. */
    private int ignored;

    public PatternSensor(ObjectRegistry registry, BeamQuery ranging, Scratch scratch) {
        this.registry = registry;
        objects = registry.objects;
        this.ranging = ranging;
        this.scratch = scratch;
        frame = new SensorFrame(objects);
    }

    /** Where the sensor is. */
    public SensorFrame frame() {
        return frame;
    }

    /**
     * Makes room for the answers.
     *
     * @throws IllegalArgumentException if a beam has no answer in this world, or the answers want what it has not
     */
    public void prepare(RayPattern pattern, SenseOptions options, BeamResults out) {
        if ((out.hasNormals() || out.hasParts()) && options.width() > 0) {
            throw new IllegalArgumentException("width must be 0 for a buffer with "
                    + (out.hasNormals() ? "normals" : "parts") + ", which cones have not (got: " + options.width()
                    + ")");
        }
        registry.ignore(options.ignored()); // refuses names that are not there
        objects.ignored.clear();
        reserve();
        frame.start(pattern, options);
        Dimension seen = view(pattern, options).dimension;
        if (seen == Dimension.PLANAR) {
            checkLevel(pattern);
        }
        out.clear(pattern.size(), seen);
        frame.tell(out.place());
    }

    /** Prepares, and answers all beams. */
    public void senseAll(RayPattern pattern, SenseOptions options, BeamResults out) {
        prepare(pattern, options, out);
        sense(pattern, options, out, 0, tiles(pattern, options));
        finish(pattern, out);
    }

    /** What the sensor sees of the world. */
    private AccuracyView view(RayPattern pattern, SenseOptions options) {
        if (registry.view.dimension == Dimension.SPATIAL) {
            return registry.view;
        }
        boolean isFlat = !options.seesHeights() && (options.width() > 0 || (pattern.isLevel() && frame.isUpright()));
        return isFlat ? registry.view : registry.withHeights();
    }

    private void checkLevel(RayPattern pattern) {
        for (int first = 0; first < pattern.size(); first += TILE) {
            int count = Math.min(TILE, pattern.size() - first);
            pattern.directions(first, count, directions, 0);
            for (int k = 0; k < count; k++) {
                beams[k] = first + k;
            }
            frame.turn(pattern, count, directions, beams, times);
            for (int at = 0; at < 3 * count; at += 3) {
                if (directions[at] == 0 && directions[at + 2] == 0) {
                    throw BeamQuery.vertical(
                            "direction " + (first + at / 3), directions[at], directions[at + 1], directions[at + 2]);
                }
            }
        }
    }

    /** The number of tiles in a pattern. */
    public int tiles(RayPattern pattern, SenseOptions options) {
        return tiling.cut(pattern, SensorFrame.moves(pattern, options));
    }

    /** Answers the tiles from one up to another, which is not among them. */
    public void sense(RayPattern pattern, SenseOptions options, BeamResults out, int from, int to) {
        AccuracyView view = view(pattern, options);
        min = options.min();
        max = options.max();
        width = options.width();
        ignored = options.carrier() == SenseOptions.Carrier.IGNORED ? frame.carrier() : -1;
        more = out.hasMore() ? out : null;
        distances = out.distances();
        reserve();
        frame.start(pattern, options);
        tiling.cut(pattern, frame.isMoving());
        registry.ignore(options.ignored());
        try {
            for (int tile = from; tile < to; tile++) {
                int count = tiling.take(pattern, tile, directions, beams);
                frame.turn(pattern, count, directions, beams, times);
                if (frame.isMoving()) {
                    answerMoving(view, count);
                } else {
                    answer(view, 0, count);
                }
            }
        } finally {
            objects.ignored.clear();
        }
    }

    /** Answers the beams of the tile, together those that are fired at the same time. */
    private void answerMoving(AccuracyView view, int count) {
        int to;
        for (int from = 0; from < count; from = to) {
            to = from + 1;
            while (to < count && times[to] == times[from]) {
                to++;
            }
            frame.moveTo(times[from]);
            answer(view, from, to);
        }
    }

    /**
     * A scan: single rays from a point of an object's own frame, in the plane of its own X and Z, as many as there is room
     * for.
     */
    public void scan(
            int id, Point from, double firstDegrees, double stepDegrees, double least, double most, double[] out) {
        Checks.angle("firstDegrees", firstDegrees);
        Checks.angle("stepDegrees", stepDegrees);
        Checks.range(least, most);
        Checks.present("out", out);
        frame.stand(id, from);
        AccuracyView view = frame.isUpright(id) ? registry.view : registry.withHeights();
        min = least;
        max = most;
        width = 0;
        ignored = id;
        more = null;
        distances = out;
        reserve();
        for (int first = 0; first < out.length; first += TILE) {
            int count = Math.min(TILE, out.length - first);
            for (int k = 0; k < count; k++) {
                scans.aim(firstDegrees, stepDegrees, first + k);
                objects.toWorld(id, scans.x(), 0, scans.z(), vector);
                System.arraycopy(vector, 0, directions, 3 * k, 3);
                beams[k] = first + k;
            }
            answer(view, 0, count);
        }
        distances = NONE; // the array is the caller's
    }

    private void reserve() {
        if (directions.length == 0) {
            directions = new double[3 * TILE];
            times = new double[TILE];
            beams = new int[TILE];
        }
    }

    /**
     * Answers beams of the tile that was aimed last, from one up to another, which is not among them. Rays that spread too
     * far to be searched together are parted.
     */
    private void answer(AccuracyView view, int from, int to) {
        boolean isFlat = view.dimension == Dimension.PLANAR;
        if (to - from < (isFlat ? FEW_IN_PLANE : FEW) || (width > 0 && isFlat)) {
            answerOneByOne(view, from, to, null);
            return;
        }
        if (width > 0) {
            answerOneByOne(view, from, to, around(view, from, to));
            return;
        }
        PacketSearch search = packets;
        if (search == null) {
            search = new PacketSearch(objects, scratch);
            packets = search;
        }
        if (!search.isWorthwhile(view.dimension)) {
            answerOneByOne(view, from, to, null);
            return;
        }
        if (!search.aim(view.dimension, frame.x(), frame.y(), frame.z(), directions, 3 * from, to - from)) {
            int middle = (from + to) / 2;
            answer(view, from, middle);
            answer(view, middle, to);
            return;
        }
        scratch.work.take(to - from);
        search.search(view, max, ignored);
        for (int k = from; k < to; k++) {
            int beam = beams[k];
            double nearest = search.nearest(k - from);
            distances[beam] = nearest < min ? min : nearest;
            BeamResults wanted = more;
            if (wanted != null) {
                int hit = search.hit(k - from);
                if (hit >= 0 && wanted.hasNormals()) {
                    search.normal(view, k - from, vector);
                }
                wanted.object(beam, objects, hit, vector);
                if (wanted.hasParts()) {
                    wanted.part(
                            beam,
                            hit < 0 ? -1 : ranging.part(view, hit, search.leaf(k - from)),
                            hit < 0 ? -1 : search.face(view, k - from));
                }
            }
        }
    }

    /** What is around, for some cones; null where they do not look around. */
    private @Nullable ConeCandidates around(AccuracyView view, int from, int to) {
        ConeCandidates around = surroundings;
        if (around == null) {
            around = new ConeCandidates(objects);
            surroundings = around;
        }
        if (!around.isWorthwhile()) {
            return null;
        }
        for (int k = from; k < to; k++) {
            beam(view, k);
            ranging.share(around, k, k == from);
        }
        return around.isAround() && around.open(view, max) ? around : null;
    }

    private void beam(AccuracyView view, int k) {
        int at = 3 * k;
        ranging.line(
                view.dimension,
                frame.x(),
                frame.y(),
                frame.z(),
                directions[at],
                directions[at + 1],
                directions[at + 2]);
        ranging.widen(width);
    }

    private void answerOneByOne(AccuracyView view, int from, int to, @Nullable ConeCandidates around) {
        for (int k = from; k < to; k++) {
            int beam = beams[k];
            beam(view, k);
            double nearest = around == null
                    ? ranging.nearest(view, max, ignored)
                    : ranging.nearest(view, max, ignored, around, k);
            distances[beam] = nearest < min ? min : nearest;
            BeamResults wanted = more;
            if (wanted != null) {
                ranging.tell(wanted, beam, view, nearest);
            }
        }
    }

    /** Says that all beams have been answered. */
    public static void finish(RayPattern pattern, BeamResults out) {
        out.filled(pattern.size());
    }
}
