package robosim.geometry.export;

import java.io.ByteArrayOutputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.stream.Collectors;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.viewer.playback.Replayer;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.world.World;
import robosim.geometry.world.shared.AtomicFileWriter;

/**
 * Writes a recording as one HTML file that plays it in three dimensions, in any browser with WebGL 2, without a server
 * and without a network.
 */
public final class PageWriter {
    /** The page's program, in the order in which it is run. */
    private static final List<String> SCRIPTS =
            List.of("data.js", "math.js", "shapes.js", "light.js", "view.js", "controls.js");

    /** That of a page with a server. */
    private static final List<String> LIVE_SCRIPTS =
            List.of("data.js", "math.js", "shapes.js", "light.js", "view.js", "live.js", "controls.js");

    private final StateHistory film;
    private String title = "";
    private String subtitle = "";
    private String unit = "";
    private List<GeometryObject> goals = List.of();
    private int from;
    private int to;
    private String start = "";

    /** A page of all that a history has, which is at least a frame. */
    public PageWriter(StateHistory film) {
        this.film = Checks.present("film", film);
        from = film.first();
        to = film.size();
    }

    /**
     * This with fewer steps.
     *
     * @param first the first, from 0
     * @param end   the last plus one
     */
    public PageWriter ofSteps(int first, int end) {
        if (first < film.first() || first >= end || end > film.size()) {
            throw new IllegalArgumentException("steps must be among " + film.first() + " to " + (film.size() - 1)
                    + " (got: " + first + " to " + (end - 1) + ")");
        }
        from = first;
        to = end;
        return this;
    }

    /** This with a title. */
    public PageWriter titled(String newTitle) {
        title = Checks.present("newTitle", newTitle);
        return this;
    }

    /** This with a line below the title and the symbol of the world unit; each may be empty. */
    public PageWriter described(String newSubtitle, String newUnit) {
        subtitle = Checks.present("newSubtitle", newSubtitle);
        unit = Checks.present("newUnit", newUnit);
        return this;
    }

    /** This with goals of robots, which are shown in green. */
    public PageWriter withGoals(List<GeometryObject> newGoals) {
        goals = Checks.list("newGoals", newGoals);
        return this;
    }

    /** This, opened at its last step in place of its first. */
    public PageWriter openedAtEnd() {
        start = "step=" + to;
        return this;
    }

    /**
     * Plays a conversation and writes its page, which opens at the end.
     *
     * @param world lends colours and a unit; null for none
     */
    public static void write(Scenario scenario, List<GeometryObject> goals, @Nullable World world, Path file)
            throws IOException {
        new PageWriter(Replayer.film(scenario, Colours.of(world)))
                .titled(scenario.header().title())
                .described("", Pictures.unit(world))
                .withGoals(goals)
                .openedAtEnd()
                .write(file);
    }

    /**
     * Writes the page; an existing file stays as it was until the new one is complete.
     *
     * @return what the page shows less finely than it is, in words; empty if nothing
     * @throws IOException if the file cannot be written
     */
    public List<String> write(Path file) throws IOException {
        PageData data = new PageData(film, from, to, new PageData.Labels(title, subtitle, unit), goals);
        String page = page(title, start, data.toBytes());
        AtomicFileWriter.write(file, out -> out.write(page.getBytes(StandardCharsets.UTF_8)));
        return data.coarse();
    }

    /** The page as a text. */
    public String page() throws IOException {
        return page(title, start, bytes());
    }

    /** The compressed data of the page, for a page that is {@linkplain #live live}. */
    public byte[] data() {
        return deflated(bytes());
    }

    private byte[] bytes() {
        return new PageData(film, from, to, new PageData.Labels(title, subtitle, unit), goals).toBytes();
    }

    /**
     * A page without data, which loads it from its server and follows the changes.
     *
     * @param settings what {@code live.js} needs to know of the server, as JSON
     */
    public static String live(String title, String settings) throws IOException {
        return page(title, "", LIVE_SCRIPTS, settings)
                .replace("; img-src", "; connect-src 'self'; img-src")
                .replace("%DATA%", "");
    }

    static String page(String title, String start, byte[] data) throws IOException {
        return page(title, start, SCRIPTS, "")
                .replace("%DATA%", Base64.getEncoder().encodeToString(deflated(data)));
    }

    private static String page(String title, String start, List<String> scripts, String settings) throws IOException {
        StringBuilder script = new StringBuilder();
        for (String name : scripts) {
            script.append(dense(resource(name)));
        }
        return resource("page.html")
                .replace("%STYLE%", resource("page.css"))
                .replace("%SCRIPT%", script)
                .replace("%START%", start)
                .replace("%TITLE%", title.replace("&", "&amp;").replace("<", "&lt;"))
                .replace("%LIVE%", settings.replace("<", "\\u003c"));
    }

    /** A program without the blanks beside its punctuation, other than in its strings; shaders are templates. */
    private static String dense(String program) {
        StringBuilder dense = new StringBuilder(program.length());
        boolean isQuoted = false;
        for (int k = 0; k < program.length(); k++) {
            char c = program.charAt(k);
            if (!isQuoted && c == ' ' && (isPunctuation(program, k - 1) || isPunctuation(program, k + 1))) {
                continue;
            }
            if (isQuoted && (c == '\'' || c == '\n')) {
                isQuoted = false;
            } else if (c == '\'') {
                isQuoted = true;
            }
            dense.append(c);
        }
        return dense.toString();
    }

    /** Not a sign, of which two beside each other mean something else. */
    private static boolean isPunctuation(String program, int at) {
        return at >= 0 && at < program.length() && ",;:?=<>(){}[]&|*".indexOf(program.charAt(at)) >= 0;
    }

    private static byte[] deflated(byte[] data) {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION, true);
        try (DeflaterOutputStream out = new DeflaterOutputStream(packed, deflater)) {
            out.write(data);
        } catch (IOException e) {
            throw new UncheckedIOException(e); // memory does not fail
        } finally {
            deflater.end();
        }
        return packed.toByteArray();
    }

    /** A part of the page, without what only its authors need: indentation, and lines that are comments. */
    private static String resource(String name) throws IOException {
        try (InputStream in = PageWriter.class.getResourceAsStream(name)) {
            if (in == null) {
                throw new FileNotFoundException(
                        "a part of the page is missing; use the jar as it was built (missing: " + name + ")");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .map(String::strip)
                    .filter(line -> !line.startsWith("//") && !line.startsWith("/**"))
                    .collect(Collectors.joining("\n", "", "\n"));
        }
    }
}
