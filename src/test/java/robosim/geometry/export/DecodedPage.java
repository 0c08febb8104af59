package robosim.geometry.export;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.Inflater;
import java.util.zip.InflaterInputStream;
import robosim.geometry.reference.Vectors;

/**
 * What a page contains, read independently of the page's own program: worlds, places, distances, refused moves. Places
 * are in world units; a pose has its centre, and the nine numbers of its rotation.
 */
final class DecodedPage {
    /** A measurement by frame: all distances. */
    record Scan(
            int frame,
            int sensors,
            double[] distances,
            double[] bearings,
            double[] widths,
            double[] ranges,
            double[][] places) {}

    record Bump(int frame, int mover, double heading, int obstacle) {}

    /** An object: its name, 0xRRGGBB, its centre and its numbers of parts by shape. */
    record Thing(String name, int colour, double[] center, int[] parts, int rectangles) {}

    /** One world. */
    static final class Chapter {
        int begin;
        final List<Integer> statics = new ArrayList<>();
        final List<Integer> movers = new ArrayList<>();
        final List<List<double[]>> places = new ArrayList<>();
        final List<int[]> frames = new ArrayList<>();
        final List<List<Scan>> scans = new ArrayList<>();
        final List<Bump> bumps = new ArrayList<>();

        /** The pose of a mover after a frame. */
        double[] place(int mover, int frame) {
            int[] known = frames.get(mover);
            int k = 0;
            while (k + 1 < known.length && known[k + 1] <= frame) {
                k++;
            }
            return places.get(mover).get(k);
        }
    }

    final String title;
    final String subtitle;
    final String unitName;
    final double unit;
    final int first;
    final int frames;
    final double[] origin = new double[3];
    final List<String> remarks = new ArrayList<>();
    final List<Integer> goals = new ArrayList<>();
    final List<Thing> things = new ArrayList<>();
    /** Each look as numbers: two colours, two shares, the kind of a pattern, its second colour, size and angle. */
    final List<List<Double>> looks = new ArrayList<>();

    /** The number of each part's look. */
    final List<Integer> lookOf = new ArrayList<>();

    final List<Chapter> chapters = new ArrayList<>();
    final List<Integer> meshTriangles = new ArrayList<>();
    private final List<double[][]> arrangements = new ArrayList<>();

    private final ByteBuffer[] streams = new ByteBuffer[13];

    private DecodedPage(byte[] data) {
        ByteBuffer whole = ByteBuffer.wrap(data);
        int count = (int) count(whole);
        int[] sizes = new int[count];
        for (int k = 0; k < count; k++) {
            sizes[k] = (int) count(whole);
        }
        for (int k = 0; k < count; k++) {
            streams[k] = whole.slice().limit(sizes[k]).slice().order(ByteOrder.LITTLE_ENDIAN);
            whole.position(whole.position() + sizes[k]);
        }
        if (whole.hasRemaining()) {
            throw new IllegalStateException("bytes are left: " + whole.remaining());
        }
        ByteBuffer about = streams[0];
        title = text(about);
        subtitle = text(about);
        unitName = text(about);
        unit = Math.scalb(1.0, (int) signed(about));
        for (int k = 0; k < 3; k++) {
            origin[k] = about.getDouble();
        }
        about.getFloat();
        about.getFloat();
        about.getFloat();
        first = (int) count(about);
        frames = (int) count(about);
        List<String> texts = new ArrayList<>();
        for (long left = count(about); left > 0; left--) {
            texts.add(text(about));
        }
        int frame = 0;
        for (long left = count(about); left > 0; left--) {
            frame += (int) count(about);
            remarks.add(frame + ": " + texts.get((int) count(about)));
        }
        for (long left = count(about); left > 0; left--) {
            goals.add((int) count(about));
        }
        meshes(streams[3]);
        while (streams[1].hasRemaining()) {
            looks.add(look(streams[1]));
        }
        while (streams[2].hasRemaining()) {
            things.add(thing(streams[2]));
        }
        for (long left = count(streams[10]); left > 0; left--) {
            arrangements.add(arrangement(streams[10]));
        }
        for (long left = count(streams[4]); left > 0; left--) {
            chapters.add(chapter(streams[4]));
        }
        for (ByteBuffer stream : streams) {
            if (stream.hasRemaining()) {
                throw new IllegalStateException("a stream has bytes left: " + stream.remaining());
            }
        }
    }

    static DecodedPage of(byte[] data) {
        return new DecodedPage(data);
    }

    static byte[] data(String page) throws IOException {
        Matcher found =
                Pattern.compile("(?s)<script id=\"data\"[^>]*>([^<]*)</script>").matcher(page);
        if (!found.find()) {
            throw new IllegalStateException("a page has data");
        }
        byte[] packed = Base64.getDecoder().decode(found.group(1));
        return new InflaterInputStream(new ByteArrayInputStream(packed), new Inflater(true)).readAllBytes();
    }

    static DecodedPage of(String page) throws IOException {
        return of(data(page));
    }

    private static long count(ByteBuffer in) {
        long value = 0;
        int shift = 0;
        byte next;
        do {
            next = in.get();
            value |= (next & 127L) << shift;
            shift += 7;
        } while (next < 0);
        return value;
    }

    private static long signed(ByteBuffer in) {
        long value = count(in);
        return (value & 1) == 0 ? value / 2 : -(value + 1) / 2;
    }

    private static String text(ByteBuffer in) {
        byte[] bytes = new byte[(int) count(in)];
        in.get(bytes);
        return new String(bytes, StandardCharsets.UTF_8);
    }

    private void meshes(ByteBuffer in) {
        while (in.hasRemaining()) {
            int vertices = (int) count(in);
            in.position(in.position() + 12 * vertices);
            int triangles = (int) count(in);
            int vertex = 0;
            for (int k = 0; k < 3 * triangles; k++) {
                vertex += (int) signed(in);
                if (vertex < 0 || vertex >= vertices) {
                    throw new IllegalStateException("no such vertex: " + vertex);
                }
            }
            meshTriangles.add(triangles);
        }
    }

    private List<Double> look(ByteBuffer in) {
        List<Double> look = new ArrayList<>();
        for (int k = 0; k < 9; k++) {
            look.add((double) (in.get() & 255));
        }
        double kind = look.get(8);
        for (int k = 0; k < 3 && kind > 0; k++) {
            look.add((double) (in.get() & 255));
        }
        for (int k = 0; k < kind; k++) {
            look.add(in.getFloat() * (k == 0 ? unit : 1));
        }
        return look;
    }

    private Thing thing(ByteBuffer in) {
        String name = text(in);
        text(in);
        int colour = 0;
        for (int k = 0; k < 3; k++) {
            colour = colour << 8 | in.get() & 255;
        }
        double[] center = new double[3];
        for (int k = 0; k < 3; k++) {
            center[k] = in.getFloat() * unit + origin[k];
        }
        in.position(in.position() + 16);
        int[] parts = new int[6];
        int rectangles = 0;
        int[] sizes = {3, 2, 1, 2, 0, 2};
        for (long left = count(in); left > 0; left--) {
            int code = in.get();
            parts[code & 7]++;
            in.position(in.position() + 4 * sizes[code & 7]);
            if ((code & 7) == 4) {
                count(in);
            }
            if ((code & 7) == 5) {
                count(in);
                count(in);
                rectangles = (int) count(in);
                for (int k = 0; k < 4 * rectangles; k++) {
                    count(in);
                }
            }
            lookOf.add((int) count(in));
            if ((code & 8) != 0) {
                in.position(in.position() + 28);
            }
        }
        return new Thing(name, colour, center, parts, rectangles);
    }

    private double[][] arrangement(ByteBuffer in) {
        double[][] sensors = new double[(int) count(in)][6];
        for (double[] sensor : sensors) {
            sensor[0] = count(in) * 360.0 / 65536;
            sensor[1] = count(in) * 360.0 / 65536;
            sensor[2] = in.get() == 0 ? Double.POSITIVE_INFINITY : in.getFloat() * unit;
            for (int axis = 3; axis < 6; axis++) {
                sensor[axis] = in.getFloat() * unit;
            }
        }
        return sensors;
    }

    private Chapter chapter(ByteBuffer in) {
        Chapter chapter = new Chapter();
        chapter.begin = (int) count(in);
        in.position(in.position() + 13);
        int id = 0;
        for (long left = count(in); left > 0; left--) {
            id += (int) signed(in);
            chapter.statics.add(id);
        }
        for (long left = count(in); left > 0; left--) {
            id += (int) signed(in);
            chapter.movers.add(id);
        }
        for (int k = 0; k < chapter.movers.size(); k++) {
            track(chapter);
        }
        for (int k = 0; k < chapter.movers.size(); k++) {
            chapter.scans.add(scans(chapter.begin));
        }
        int frame = chapter.begin;
        for (long left = count(in); left > 0; left--) {
            frame += (int) count(in);
            chapter.bumps.add(new Bump(frame, (int) count(in), count(in) * 360.0 / 65536, (int) count(in)));
        }
        return chapter;
    }

    private void track(Chapter chapter) {
        long head = count(streams[5]);
        int[] known = new int[(int) (head / 2)];
        int frame = chapter.begin;
        for (int k = 0; k < known.length; k++) {
            frame += (int) count(streams[6]);
            known[k] = frame;
        }
        chapter.frames.add(known);
        List<double[]> places = new ArrayList<>();
        long[] now = new long[7];
        long turn = 0;
        long ahead = 0;
        long aside = 0;
        for (int k = 0; k < known.length; k++) {
            if (head % 2 == 0) {
                for (int j = 0; j < 7; j++) {
                    now[j] += signed(streams[9]);
                }
                places.add(free(now));
                continue;
            }
            int op = streams[5].get() & 255;
            int move = op & 31;
            if (move >= 10) {
                ahead = signed(streams[7]);
                aside = signed(streams[7]);
            }
            if (move == 19) {
                now[0] = signed(streams[7]);
                now[2] = signed(streams[7]);
            } else if (move > 0) {
                // By the JDK's own functions, 1e-11 from those of the page.
                double angle = turn * Math.PI / 32768;
                double x = Math.cos(angle) * ahead + Math.sin(angle) * aside;
                double z = Math.cos(angle) * aside - Math.sin(angle) * ahead;
                now[0] += (long) Math.floor(x + 0.5) + (move - 1) % 9 / 3 - 1;
                now[2] += (long) Math.floor(z + 0.5) + (move - 1) % 3 - 1;
            }
            turn += (op & 32) != 0 ? signed(streams[8]) : 0;
            now[1] += (op & 64) != 0 ? signed(streams[9]) : 0;
            places.add(upright(now, turn * Math.PI / 32768));
        }
        chapter.places.add(places);
    }

    private double[] upright(long[] now, double angle) {
        double[] place = new double[12];
        for (int k = 0; k < 3; k++) {
            place[k] = now[k] / 8192.0 * unit + origin[k];
        }
        place[3] = Math.cos(angle);
        place[5] = Math.sin(angle);
        place[7] = 1;
        place[9] = -Math.sin(angle);
        place[11] = Math.cos(angle);
        return place;
    }

    private double[] free(long[] now) {
        double[] place = upright(now, 0);
        double length = 0;
        for (int k = 3; k < 7; k++) {
            length += (double) now[k] * now[k];
        }
        double s = 1 / Math.sqrt(length);
        double[] rows = Vectors.rotation(2, now[6] * s, now[3] * s, now[4] * s, now[5] * s);
        System.arraycopy(rows, 0, place, 3, 9);
        return place;
    }

    private List<Scan> scans(int begin) {
        List<Scan> scans = new ArrayList<>();
        long[][] last = new long[arrangements.size()][];
        int frame = begin;
        for (long left = count(streams[11]); left > 0; left--) {
            frame += (int) count(streams[11]);
            int kind = (int) count(streams[11]);
            double[][] sensors = arrangements.get(kind);
            last[kind] = last[kind] == null ? new long[sensors.length] : last[kind];
            Scan scan = new Scan(
                    frame,
                    sensors.length,
                    new double[sensors.length],
                    new double[sensors.length],
                    new double[sensors.length],
                    new double[sensors.length],
                    new double[sensors.length][3]);
            for (int k = 0; k < sensors.length; k++) {
                long code = count(streams[12]);
                last[kind][k] += code == 0 ? 0 : code % 2 == 1 ? code / 2 : -code / 2;
                scan.distances[k] = code == 0 ? Double.POSITIVE_INFINITY : last[kind][k] / 2048.0 * unit;
                scan.bearings[k] = sensors[k][0];
                scan.widths[k] = sensors[k][1];
                scan.ranges[k] = sensors[k][2];
                System.arraycopy(sensors[k], 3, scan.places[k], 0, 3);
            }
            scans.add(scan);
        }
        return scans;
    }
}
