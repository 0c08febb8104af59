package robosim.geometry.engine.sensing;

import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.PacketSearch;
import robosim.geometry.engine.broadphase.Surroundings;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Checks;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.narrow.Scratch;

/**
 * All beams of a pattern from one place. They are answered tile by tile, and what the beams of a tile share is found once:
 * rays in a world with heights are one {@link PacketSearch}.
 */
public final class PatternSensor {
    private static final int TILE = Tiling.MOST;

    /** Fewer rays are answered one by one just as fast. */
    private static final int FEW = 4;

    private static final double[] NO_NORMAL = new double[3];
    private static final double[] NONE = new double[0];

    private final Dimension dimension;
    private final ObjectTable objects;
    private final BeamQuery ranging;
    private final Scratch scratch;
    private final Tiling tiling = new Tiling();

    /** Made for the first tile. */
    private @Nullable PacketSearch packets;

    private @Nullable Surroundings surroundings;

    private final double[] vector = new double[3];
    private final double[] mount = new double[9];
    private final ScanDirections scans = new ScanDirections();

    /** The directions of the tile in the world, three numbers each; made for the first one, as many worlds have no sensor. */
    private double[] directions = NONE;

    /** By beam of the tile, where its answer is to stand. */
    private int[] beams = new int[0];

    private double[] distances = NONE;

    /** What takes more than distances; null if nothing does. */
    private @Nullable Echoes more;

    /** Where all beams begin. */
    private double ox;

    private double oy;
    private double oz;

    /** The object that carries the sensor; -1 for none. */
    private int carrier = -1;

    // What is asked of each beam.
    private double min;
    private double max;
    private double width;

    /** The object that does not echo; -1 for none. */
    private int ignored;

    public PatternSensor(Dimension dimension, ObjectTable objects, BeamQuery ranging, Scratch scratch) {
        this.dimension = dimension;
        this.objects = objects;
        this.ranging = ranging;
        this.scratch = scratch;
    }

    /** Takes a sensor that is mounted on a moveable object, in its own frame. */
    public void mounted(int id, Pose on) {
        carrier = id;
        on.rotation(mount, 0);
        stand(id, on.center());
    }

    /** Takes a point of an object's own frame for where all beams begin. */
    private void stand(int id, Point at) {
        double[] places = objects.places();
        int place = objects.place(id);
        objects.toWorld(id, at.x(), at.y(), at.z(), vector);
        ox = places[place] + vector[0];
        oy = places[place + 1] + vector[1];
        oz = places[place + 2] + vector[2];
    }

    /** Takes a sensor in the world that nothing carries. */
    public void at(Pose pose) {
        carrier = -1;
        pose.rotation(mount, 0);
        Point at = pose.center();
        ox = at.x();
        oy = at.y();
        oz = at.z();
    }

    /**
     * Makes room for the answers.
     *
     * @throws IllegalArgumentException if a beam has no answer in this world, or the answers want what it has not
     */
    public void prepare(RayPattern pattern, SenseOptions options, Echoes out) {
        if (out.hasNormals() && options.width() > 0) {
            throw new IllegalArgumentException(
                    "width must be 0 for a buffer with normals, which cones have not (got: " + options.width() + ")");
        }
        if (dimension == Dimension.PLANAR) {
            checkLevel(pattern);
        }
        out.clear(pattern.size());
        tellPlace(out.place());
    }

    /** Writes where the sensor is: its origin, and its axes as the columns of a rotation. */
    private void tellPlace(double[] place) {
        place[0] = ox;
        place[1] = oy;
        place[2] = oz;
        for (int axis = 0; axis < 3; axis++) {
            vector[0] = mount[axis];
            vector[1] = mount[3 + axis];
            vector[2] = mount[6 + axis];
            if (carrier >= 0) {
                objects.toWorld(carrier, vector[0], vector[1], vector[2], vector);
            }
            for (int row = 0; row < 3; row++) {
                place[3 + 3 * row + axis] = vector[row] + 0.0;
            }
        }
    }

    private void checkLevel(RayPattern pattern) {
        for (int first = 0; first < pattern.size(); first += TILE) {
            int count = Math.min(TILE, pattern.size() - first);
            reserve();
            pattern.directions(first, count, directions, 0);
            turn(count);
            for (int at = 0; at < 3 * count; at += 3) {
                if (directions[at] == 0 && directions[at + 2] == 0) {
                    throw Beams.vertical(
                            "direction " + (first + at / 3), directions[at], directions[at + 1], directions[at + 2]);
                }
            }
        }
    }

    /** The number of tiles in a pattern. */
    public int tiles(RayPattern pattern) {
        return tiling.cut(pattern);
    }

    /** Answers the tiles from one up to another, which is not among them. */
    public void sense(AccuracyView view, RayPattern pattern, SenseOptions options, Echoes out, int from, int to) {
        min = options.min();
        max = options.max();
        width = options.width();
        ignored = options.carrier() == SenseOptions.Carrier.IGNORED ? carrier : -1;
        more = out.hasObjects() || out.hasNormals() ? out : null;
        distances = out.distances();
        reserve();
        tiling.cut(pattern);
        for (int tile = from; tile < to; tile++) {
            int count = tiling.take(pattern, tile, directions, beams);
            turn(count);
            answer(view, 0, count);
        }
    }

    /**
     * A scan: single rays from a point of an object's own frame, in the plane of its own X and Z, as many as there is room
     * for.
     */
    public void scan(
            AccuracyView view,
            int id,
            Point from,
            double firstDegrees,
            double stepDegrees,
            double least,
            double most,
            double[] out) {
        Checks.angle("firstDegrees", firstDegrees);
        Checks.angle("stepDegrees", stepDegrees);
        Checks.range(least, most);
        Checks.present("out", out);
        stand(id, from);
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
                Beams.checkLevel(dimension, vector[0], vector[1], vector[2]);
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
            beams = new int[TILE];
        }
    }

    /** Turns the directions of a tile to the world's axes. */
    private void turn(int count) {
        for (int at = 0; at < 3 * count; at += 3) {
            double x = directions[at];
            double y = directions[at + 1];
            double z = directions[at + 2];
            // As a point has them, which has no -0.0.
            double ownX = mount[0] * x + mount[1] * y + mount[2] * z + 0.0;
            double ownY = mount[3] * x + mount[4] * y + mount[5] * z + 0.0;
            double ownZ = mount[6] * x + mount[7] * y + mount[8] * z + 0.0;
            if (carrier >= 0) {
                objects.toWorld(carrier, ownX, ownY, ownZ, vector);
                directions[at] = vector[0];
                directions[at + 1] = vector[1];
                directions[at + 2] = vector[2];
            } else {
                directions[at] = ownX;
                directions[at + 1] = ownY;
                directions[at + 2] = ownZ;
            }
        }
    }

    /**
     * Answers beams of the tile that was aimed last, from one up to another, which is not among them. Rays that spread too
     * far to be searched together are parted.
     */
    private void answer(AccuracyView view, int from, int to) {
        if (to - from < FEW || (width == 0 && !PacketSearch.isFor(view))) {
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
        if (!search.aim(ox, oy, oz, directions, 3 * from, to - from)) {
            int middle = (from + to) / 2;
            answer(view, from, middle);
            answer(view, middle, to);
            return;
        }
        search.search(view, max, ignored);
        for (int k = from; k < to; k++) {
            int beam = beams[k];
            double nearest = search.nearest(k - from);
            distances[beam] = nearest < min ? min : nearest;
            Echoes wanted = more;
            if (wanted != null) {
                int hit = search.hit(k - from);
                if (hit >= 0 && wanted.hasNormals()) {
                    search.normal(view, k - from, vector);
                }
                note(wanted, beam, hit);
            }
        }
    }

    /** What is around, for some cones; null where they do not look around. */
    private @Nullable Surroundings around(AccuracyView view, int from, int to) {
        Surroundings around = surroundings;
        if (around == null) {
            around = new Surroundings(objects);
            surroundings = around;
        }
        for (int k = from; k < to; k++) {
            beam(k);
            ranging.share(around, k, k == from);
        }
        return around.isAround() && around.open(view, max) ? around : null;
    }

    private void beam(int k) {
        int at = 3 * k;
        ranging.beam(dimension, ox, oy, oz, directions[at], directions[at + 1], directions[at + 2], width);
    }

    private void answerOneByOne(AccuracyView view, int from, int to, @Nullable Surroundings around) {
        for (int k = from; k < to; k++) {
            int beam = beams[k];
            beam(k);
            double nearest = around == null
                    ? ranging.nearest(view, max, ignored)
                    : ranging.nearest(view, max, ignored, around, k);
            distances[beam] = nearest < min ? min : nearest;
            Echoes wanted = more;
            if (wanted != null) {
                int hit = ranging.hit();
                if (hit >= 0 && wanted.hasNormals()) {
                    ranging.normal(view, nearest, vector);
                }
                note(wanted, beam, hit);
            }
        }
    }

    /** Notes what was hit, and the normal at hand. */
    private void note(Echoes out, int beam, int hit) {
        if (out.hasObjects()) {
            out.object(beam, objects, hit);
        }
        if (out.hasNormals()) {
            out.normal(beam, hit >= 0 ? vector : NO_NORMAL);
        }
    }

    /** Says that all beams have been answered. */
    public static void finish(RayPattern pattern, Echoes out) {
        out.filled(pattern.size());
    }
}
