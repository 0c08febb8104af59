package robosim.geometry.viewer.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.viewer.Talk;
import robosim.geometry.viewer.playback.Replayer;
import robosim.geometry.world.shared.JsonText;

/** The page's own program against its server, where node is there to run it: without a screen, but with everything else. */
@Tag("clock")
@Timeout(120)
class BrowsedPageTest {
    private static final String SCRIPT = "src/test/resources/robosim/geometry/viewer/web/browse.js";

    private final LiveFilm film = new LiveFilm("talk", "");
    private final Replayer stage = new Replayer(SessionOptions.ROBOSIM);
    private final Talk talk = Talk.begun();
    private int played;

    private PageServer server;
    private Process browser;
    private BufferedReader answers;

    @TempDir
    private Path folder;

    @BeforeEach
    void open() throws IOException {
        String path = System.getenv("PATH");
        boolean hasNode = path != null
                && Arrays.stream(path.split(File.pathSeparator))
                        .anyMatch(each -> Files.isExecutable(Path.of(each, "node")));
        Assumptions.assumeTrue(hasNode, "no node on the path, which runs the page's program");
        Control control = new Control() {
            @Override
            public List<String> commands() {
                return List.of("pause", "run", "step", "drag", "turn");
            }

            @Override
            public String carryOut(Map<?, ?> command) {
                asked.add(command.toString());
                return "said";
            }

            @Override
            public Map<String, Object> state() {
                return Map.of("paused", false);
            }
        };
        server = PageServer.live(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), film, control);
        browser = new ProcessBuilder("node", SCRIPT, server.page().toString())
                .redirectError(folder.resolve("errors").toFile())
                .start();
        answers = browser.inputReader(StandardCharsets.UTF_8);
    }

    private final List<String> asked = new CopyOnWriteArrayList<>();

    @AfterEach
    void close() {
        if (browser != null) {
            browser.destroyForcibly();
            server.close();
        }
    }

    /** Plays what was added to the talk. */
    private void play() {
        for (; played < talk.steps().size(); played++) {
            film.add(stage.play(talk.steps().get(played)));
        }
    }

    /** What a program of the page returns. */
    private Object run(String program) throws Exception {
        OutputStream out = browser.getOutputStream();
        out.write((program + "\n").getBytes(StandardCharsets.UTF_8));
        out.flush();
        String line = answers.readLine();
        assertThat(line).as("%s: %s", program, errors()).isNotNull().doesNotStartWith("\"WRONG");
        return line.equals("undefined") ? null : JsonText.parse(line, program);
    }

    private String errors() throws IOException {
        return Files.readString(folder.resolve("errors"));
    }

    private List<?> place() throws Exception {
        return (List<?>) run("toWorld(page.window.robosim.data, page.window.robosim.view.poses[0].slice(0, 3))");
    }

    private static void assertNear(List<?> place, double x, double z) {
        assertThat(((Number) place.get(0)).doubleValue()).isCloseTo(x, within(1e-3));
        assertThat(((Number) place.get(2)).doubleValue()).isCloseTo(z, within(1e-3));
    }

    @Test
    void thePageFollowsTheSession() throws Exception {
        assertThat(run("page.element('said').textContent")).isIn("", "waiting for a session");
        play();
        run("until(() => page.window.robosim)");
        assertThat(run("document.documentElement.dataset.state")).isEqualTo("ready");
        assertNear(place(), -5, 0);
        talk.drives(0.5, null).drives(30, null);
        play();
        run("until(() => page.window.robosim.view.frame === 2)");
        assertNear(place(), -4.5, 0);
        assertThat(run("story(page.window.robosim.data, 2)")).isEqualTo("1 refused: drum by wall");
        run("until(() => page.window.robosim.view.red.length === 1)");
        talk.looks(null);
        play();
        run("until(() => page.window.robosim.view.frame === 3)");
        assertThat(run("page.window.robosim.data.sensors.length")).isEqualTo(1.0);
        // Back in its past, while the session goes on; and forward again.
        run("page.key('Home')");
        talk.drives(0.25, null);
        play();
        run("until(() => page.window.robosim.data.chapters[0].tracks[0].frames.length === 3)");
        run("until(() => page.window.robosim.view.frame === 0)");
        assertThat(run("page.window.robosim.data.frames"))
                .as("it looked and moved, which is one step")
                .isEqualTo(4.0);
        assertNear(place(), -5, 0);
        run("page.key('End')");
        run("until(() => page.window.robosim.view.frame === 3)");
        assertNear(place(), -4.25, 0);
        // Another world.
        talk.world(Talk.DRUM);
        play();
        run("until(() => page.window.robosim.view.chapter.statics.length === 0 && page.window.robosim.view.frame"
                + " === 0)");
        assertNear(place(), -5, 0);
        assertThat(run("page.element('problem').textContent")).isEqualTo("");
        assertThat(errors()).isEmpty();
    }

    @Test
    void everyKeyDoesWhatItSays() throws Exception {
        play();
        run("until(() => page.window.robosim)");
        for (String key : "1 2 3 4 f s t b n d g c c c m p r R x X + - ? h".split(" ")) {
            run("page.key('" + key + "')");
            run("page.window.robosim.draw(0.01)");
        }
        run("page.key('2')");
        run("page.key('c'), page.window.robosim.draw(), 0");
        assertThat(run("page.window.robosim.panes.map(p => p.camera.kind)")).isEqualTo(List.of("orbit", "eye"));
        run("page.key('c'), page.window.robosim.draw(), 0");
        assertThat(run("page.window.robosim.panes.map(p => p.camera.kind)"))
                .isEqualTo(List.of("top", "orbit", "eye", "follow"));
        // The middle of the plan, the upper left of four, is the middle of the page; and a place leads back to its
        // pixel.
        run("page.window.robosim.settled = null, page.window.robosim.draw(), 0");
        List<?> there = (List<?>) run("page.window.robosim.levelAt(200, 150, 0)");
        List<?> pixel = (List<?>) run("project(page.window.robosim.matrix, page.window.robosim.levelAt(300, 100, 0))");
        assertThat(((Number) there.get(0)).doubleValue()).isCloseTo(0, within(0.01));
        assertThat(((Number) pixel.get(0)).doubleValue()).isCloseTo(0.5, within(1e-3));
        assertThat(((Number) pixel.get(1)).doubleValue()).isCloseTo(1.0 / 3, within(1e-3));
        // From a place to 5 units beside it.
        run("page.window.robosim.view.rulers = []");
        String at =
                "(x => { const p = page.window.robosim, d = p.data, q = project(p.matrix, [x / d.unit, p.view.floorAt,"
                        + " 0]); p.measureAt((q[0] + 1) * 200, (1 - q[1]) * 150); })";
        run(at + "(-3)");
        run(at + "(2)");
        Object measured = run("(p => Math.hypot(...sub(...p.view.rulers[0])) * p.data.unit)(page.window.robosim)");
        assertThat((Double) measured).isCloseTo(5, within(0.01));
        assertThat(errors()).isEmpty();
    }

    @Test
    void aRobotIsDragged() throws Exception {
        play();
        run("until(() => page.window.robosim)");
        run("page.key('2'), page.window.robosim.settled = null, page.window.robosim.draw(), 0");
        // Where the drum is on the canvas, and 3 units to its right.
        String pixel = "(x => { const p = page.window.robosim, d = p.data, at = project(p.matrix, [(x - d.origin[0]) /"
                + " d.unit, p.view.poses[0][1], -d.origin[2] / d.unit]); return { offsetX: (at[0] + 1) * 400,"
                + " offsetY: (1 - at[1]) * 300, clientX: (at[0] + 1) * 400, clientY: (1 - at[1]) * 300 }; })";
        run("page.element('canvas').fire('pointerdown', " + pixel + "(-5))");
        run("page.element('canvas').fire('pointermove', " + pixel + "(-2))");
        run("page.element('canvas').fire('pointerup', " + pixel + "(-2))");
        run("until(() => page.element('said').textContent === 'said')");
        assertThat(asked).hasSize(1);
        assertThat(asked.get(0)).matches("\\{do=drag, name=drum, x=-(2\\.0|1\\.9999)\\d*, z=-?\\d\\S*, lift=false}");
        run("page.key('q')");
        run("until(() => !page.window.robosim.live.asking)");
        assertThat(errors()).isEmpty();
    }

    @Test
    void aPageKeepsNoMoreThanItsShare() throws Exception {
        play();
        run("until(() => page.window.robosim)");
        assertThat(run("(p => { for (let k = 1; k <= 60000; k++) grow(p.data, { frame: k, placed: [[0, -5 + k * 1e-5,"
                        + " 0, 0, 0, 0, 0, 1]], heard: k % 2 ? [[0, [[0, 0.1, 6, 0, 0, 0]], [k % 5]]] : [],"
                        + " refused: k % 10 ? [] : [[0, 0, 3]], words: [] }); const c = p.data.chapters[0]; return"
                        + " [c.tracks[0].frames.length < 26000, c.scans[0].distances.length < 13000,"
                        + " c.scans[0].starts[c.scans[0].starts.length - 1] === c.scans[0].distances.length - 1,"
                        + " c.bumps.length < 2600, p.data.sensors.length]; })(page.window.robosim)"))
                .isEqualTo(List.of(true, true, true, true, 1.0));
        run("page.key('Home')");
        run("page.window.robosim.draw(), 0");
        assertThat((Double) run("page.window.robosim.step")).isGreaterThan(34_000);
        assertThat(errors()).isEmpty();
    }
}
