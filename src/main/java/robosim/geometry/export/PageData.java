package robosim.geometry.export;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Material;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Pose;
import robosim.geometry.viewer.draw.Palette;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.viewer.scene.Scene;

/** A recording as the bytes that the page decodes; {@code data.js} reads what is written here, in the same order. */
final class PageData {
    private static final int GOAL = 0x1e7a34;

    private final StateHistory film;
    private final int from;
    private final int to;
    private final PageQuantization quanta;
    private final PageStreams out = new PageStreams();
    private final PageObjects objects;
    private final Scans scans;
    private final Map<String, Integer> texts = new LinkedHashMap<>();

    /** Of the frames from one on to before another, of which {@code film} has all. */
    PageData(StateHistory film, int from, int to, Labels labels, List<GeometryObject> goals) {
        this.film = film;
        this.from = from;
        this.to = to;
        Scene.View view = view(goals);
        quanta = new PageQuantization(space(view, goals));
        objects = new PageObjects(quanta, out);
        scans = new Scans(quanta, out);
        write(labels, view, goals);
    }

    /**
     * What the page says about itself.
     *
     * @param subtitle below the title; may be empty
     * @param unit     symbol of the world unit; empty if unspecified
     */
    record Labels(String title, String subtitle, String unit) {}

    byte[] toBytes() {
        return out.toBytes();
    }

    /** What is shown less finely than it is, in words. */
    List<String> coarse() {
        return objects.coarse();
    }

    /** Where each chapter begins. */
    private List<Integer> begins() {
        List<Integer> begins = new ArrayList<>();
        for (int n = from; n < to; n++) {
            int world = film.world(n);
            if (world >= 0 && (begins.isEmpty() || film.world(n - 1) != world)) {
                begins.add(n);
            }
        }
        return begins;
    }

    private Frame.Setting setting(int number) {
        Frame.Setting setting = film.setting(number);
        if (setting == null) {
            throw new IllegalStateException("a chapter begins with its world (got: none at " + number + ")");
        }
        return setting;
    }

    /** The part of the floor to look at first. */
    private Scene.View view(List<GeometryObject> goals) {
        Scene.@Nullable View all = null;
        for (int begin : begins()) {
            Frame.Setting setting = setting(begin);
            Scene.View view = Scene.View.of(setting.width(), setting.length(), setting.things());
            if (all == null) {
                all = view;
            } else {
                Bounds both = all.bounds().and(view.bounds());
                all = new Scene.View(both.minX(), both.minZ(), both.maxX(), both.maxZ(), false);
            }
        }
        Scene.View found = all == null ? new Scene.View(-0.5, -0.5, 0.5, 0.5, false) : all;
        for (GeometryObject goal : goals) {
            found = found.with(goal);
        }
        return found;
    }

    /** The view with the heights of what stands in it. */
    private Bounds space(Scene.View view, List<GeometryObject> goals) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        List<GeometryObject> all = new ArrayList<>(goals);
        for (int begin : begins()) {
            setting(begin).things().forEach(thing -> all.add(thing.object()));
        }
        for (GeometryObject object : all) {
            low = Math.min(low, object.bounds().minY());
            high = Math.max(high, object.bounds().maxY());
        }
        if (low > high) {
            low = 0;
            high = 0;
        }
        return new Bounds(view.minX(), low, view.minZ(), view.maxX(), high, view.maxZ());
    }

    private void write(Labels labels, Scene.View view, List<GeometryObject> goals) {
        Bounds space = space(view, goals);
        out.about.text(labels.title);
        out.about.text(labels.subtitle);
        out.about.text(labels.unit);
        out.about.signed(quanta.exponent());
        out.about.exact(quanta.origin().x());
        out.about.exact(quanta.origin().y());
        out.about.exact(quanta.origin().z());
        out.about.real(quanta.length(space.width()));
        out.about.real(quanta.length(space.height()));
        out.about.real(quanta.length(space.length()));
        out.about.count(from);
        out.about.count(to - from);
        writeRemarks();
        out.about.count(goals.size());
        for (GeometryObject goal : goals) {
            out.about.count(objects.number(goal, GOAL));
        }
        List<Integer> begins = begins();
        out.chapters.count(begins.size());
        for (int k = 0; k < begins.size(); k++) {
            writeChapter(begins.get(k), k + 1 < begins.size() ? begins.get(k + 1) : to);
        }
        scans.finish();
    }

    /** What people wrote, and what neither a place nor a distance tells, by frame. */
    private void writeRemarks() {
        PackedStream remarks = new PackedStream();
        int count = 0;
        int before = from;
        for (int n = from; n < to; n++) {
            Frame frame = film.frame(n);
            List<String> said = new ArrayList<>(frame.notes());
            if (frame.placed().isEmpty()
                    && frame.bumps().isEmpty()
                    && frame.heard().isEmpty()) {
                said.add(frame.words());
            }
            for (String text : said) {
                Integer number = texts.get(text);
                if (number == null) {
                    number = texts.size();
                    texts.put(text, number);
                }
                remarks.count(n - before);
                remarks.count(number);
                before = n;
                count++;
            }
        }
        out.about.count(texts.size());
        texts.keySet().forEach(out.about::text);
        out.about.count(count);
        out.about.append(remarks.toBytes());
    }

    private void writeChapter(int begin, int end) {
        Frame.Setting setting = setting(begin);
        out.chapters.count(begin - from);
        out.chapters.real(quanta.length(setting.width()));
        out.chapters.real(quanta.length(setting.height()));
        out.chapters.real(quanta.length(setting.length()));
        out.chapters.octet(setting.dimension() == Dimension.PLANAR ? 0 : 1);
        out.chapters.count(setting.statics().size());
        int before = 0;
        for (Scene.Thing thing : setting.statics()) {
            GeometryObject object = thing.object();
            int usual = Palette.of(object.kind()).in(Theme.LIGHT);
            int number = objects.number(object, colour(thing, usual));
            out.chapters.signed(number - before);
            before = number;
        }
        List<Scene.Thing> movers = film.movers(begin);
        out.chapters.count(movers.size());
        for (int k = 0; k < movers.size(); k++) {
            int usual = Palette.robot(k).in(Theme.LIGHT);
            int number = objects.number(movers.get(k).object(), colour(movers.get(k), usual));
            out.chapters.signed(number - before);
            before = number;
        }
        writeLife(begin, end, setting, movers);
    }

    /** That of a world file, or else of the material, or else the usual one. */
    private static int colour(Scene.Thing thing, int usual) {
        Integer told = thing.colour();
        Material material = thing.object().material();
        return told != null
                ? told
                : material.isDefault() ? usual : material.color().packed();
    }

    /** What happened from one frame to before another. */
    private void writeLife(int begin, int end, Frame.Setting setting, List<Scene.Thing> movers) {
        PagePlaces places = new PagePlaces(movers, setting.statics());
        List<Track> tracks = new ArrayList<>();
        List<List<Scans.Scan>> heard = new ArrayList<>();
        List<Pose> now = new ArrayList<>();
        for (Scene.Thing mover : movers) {
            Track track = new Track();
            track.add(begin, mover.object().pose());
            tracks.add(track);
            heard.add(new ArrayList<>());
            now.add(mover.object().pose());
        }
        PackedStream bumps = new PackedStream();
        int count = 0;
        int before = begin;
        for (int n = begin; n < end; n++) {
            Frame frame = film.frame(n);
            for (Map.Entry<String, Pose> placed : frame.placed().entrySet()) {
                int mover = places.mover(placed.getKey());
                if (mover >= 0 && n > begin) {
                    tracks.get(mover).add(n, placed.getValue());
                    now.set(mover, placed.getValue());
                }
            }
            for (Map.Entry<String, List<Scene.Ping>> pings : frame.heard().entrySet()) {
                int mover = places.mover(pings.getKey());
                if (mover >= 0) {
                    heard.get(mover).add(new Scans.Scan(n, now.get(mover), pings.getValue()));
                }
            }
            for (Frame.Bump bump : frame.bumps()) {
                int mover = places.mover(String.valueOf(bump.mover().name()));
                if (mover >= 0) {
                    bumps.count(n - before);
                    bumps.count(mover);
                    bumps.count(PageQuantization.turn(bump.heading()));
                    bumps.count(places.obstacle(bump));
                    before = n;
                    count++;
                }
            }
        }
        for (Track track : tracks) {
            track.write(begin, quanta, out);
        }
        for (List<Scans.Scan> each : heard) {
            scans.write(begin, each);
        }
        out.chapters.count(count);
        out.chapters.append(bumps.toBytes());
    }
}
