package robosim.geometry.viewer.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.Effort;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.viewer.Talk;
import robosim.geometry.viewer.playback.Replayer;

/** The page in a real browser with WebGL in software, where Chromium is installed: what it draws, not only what it computes. */
@Tag("clock")
@Timeout(180)
class ChromiumTest {
    private static final int WIDTH = 800;
    private static final int HEIGHT = 600;

    private final LiveFilm film = new LiveFilm("talk", "");
    private final Replayer stage = new Replayer(SessionOptions.ROBOSIM);
    private final Talk talk = Talk.begun();
    private final List<Map<?, ?>> commands = new CopyOnWriteArrayList<>();
    private int played;

    private PageServer server;

    @TempDir(cleanup = CleanupMode.ON_SUCCESS)
    private static Path folder;

    /** One for all tests, each of which opens a page of its own. */
    private static Chromium browser;

    @BeforeAll
    static void start() throws Exception {
        Assumptions.assumeTrue(Chromium.program().isPresent(), "no Chromium on the path");
        browser = Chromium.start(folder, WIDTH, HEIGHT);
    }

    @AfterAll
    static void end() {
        if (browser != null) {
            browser.close();
        }
    }

    @BeforeEach
    void open() throws Exception {
        Control control = new Control() {
            @Override
            public List<String> commands() {
                return List.of("pause", "run", "step", "drag", "turn");
            }

            @Override
            public String carryOut(Map<?, ?> command) {
                commands.add(command);
                return "carried out";
            }

            @Override
            public Map<String, Object> state() {
                return Map.of("paused", false);
            }
        };
        server = PageServer.live(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), film, control);
        play();
        browser.open(server.page());
        browser.until("document.documentElement.dataset.state === 'ready'");
    }

    @AfterEach
    void close() throws Exception {
        browser.open(URI.create("about:blank"));
        server.close();
    }

    private void play() {
        for (; played < talk.steps().size(); played++) {
            film.add(stage.play(talk.steps().get(played)));
        }
    }

    /** The picture, drawn after the page's last change. */
    private BufferedImage picture() throws Exception {
        browser.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))).then(() => 0)");
        return ImageIO.read(new ByteArrayInputStream(browser.picture()));
    }

    private static int differences(BufferedImage a, BufferedImage b) {
        int count = 0;
        for (int y = 0; y < a.getHeight(); y++) {
            for (int x = 0; x < a.getWidth(); x++) {
                count += a.getRGB(x, y) == b.getRGB(x, y) ? 0 : 1;
            }
        }
        return count;
    }

    @Test
    void aMoveIsSeen() throws Exception {
        BufferedImage before = picture();
        assertThat(differences(before, picture())).as("nothing moves yet").isZero();
        talk.drives(0.5, null);
        play();
        browser.until("robosim.view.frame === 1");
        assertThat(differences(before, picture())).isBetween(50, WIDTH * HEIGHT / 4);
        BufferedImage moved = picture();
        talk.drives(30, null);
        play();
        browser.until("robosim.view.red.length === 1");
        assertThat(differences(moved, picture())).as("what blocks is red").isGreaterThan(50);
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void everyButtonAndKeyWorksWithoutComplaint() throws Exception {
        talk.drives(0.5, null).looks(null);
        play();
        browser.until("robosim.view.frame === 2");
        List<?> names =
                (List<?>) browser.run("[...document.querySelectorAll('button')].map(b => b.id || b.dataset.camera"
                        + " || b.dataset.do).filter(name => name !== 'picture')");
        assertThat(names).hasSizeGreaterThan(15);
        Map<Object, Integer> changed = new LinkedHashMap<>();
        BufferedImage last = picture();
        for (Object name : names) {
            browser.run("(b => { if (!b.hidden && !b.disabled) b.click(); })([...document.querySelectorAll('button')]"
                    + ".find(b => (b.id || b.dataset.camera || b.dataset.do) === '" + name + "'))");
            BufferedImage now = picture();
            changed.put(name, differences(last, now));
            last = now;
        }
        for (String camera : List.of("top", "eye", "follow")) {
            assertThat(changed.get(camera)).as(camera).isGreaterThan(WIDTH * HEIGHT / 20);
        }
        for (String key : "1 2 3 4 f s t b n d g c c c m r R x X + - ? h".split(" ")) {
            browser.key(key);
            picture();
        }
        assertThat(browser.complaints()).isEmpty();
        assertThat(browser.run("document.getElementById('problem').hidden")).isEqualTo(true);
    }

    @Test
    void aRobotIsDraggedByTheMouse() throws Exception {
        browser.key("2");
        picture();
        String pixel = "(x => { const p = robosim, d = p.data, q = project(p.matrix, [(x - d.origin[0]) / d.unit,"
                + " p.view.poses[0][1], -d.origin[2] / d.unit]), c = document.querySelector('canvas')"
                + ".getBoundingClientRect(); return [c.left + (q[0] + 1) / 2 * c.width, c.top + (1 - q[1]) / 2 *"
                + " c.height]; })";
        List<?> from = (List<?>) browser.run(pixel + "(-5)");
        List<?> to = (List<?>) browser.run(pixel + "(-2)");
        browser.mouse("mousePressed", number(from.get(0)), number(from.get(1)));
        browser.mouse("mouseMoved", number(to.get(0)), number(to.get(1)));
        browser.mouse("mouseReleased", number(to.get(0)), number(to.get(1)));
        browser.until("document.getElementById('said').textContent === 'carried out'");
        assertThat(commands)
                .isNotEmpty()
                .allSatisfy(each -> assertThat(each.get("name")).isEqualTo("drum"));
        Map<?, ?> last = commands.get(commands.size() - 1);
        assertThat(last.get("do")).isEqualTo("drag");
        assertThat(number(last.get("x"))).isCloseTo(-2, within(0.1));
        assertThat(browser.complaints()).isEmpty();
    }

    private static double number(Object value) {
        return ((Number) value).doubleValue();
    }

    /**
     * Some 580,000 steps are eight hours at 20 a second; an ordinary build makes a quarter. What a page keeps of them ends growing
     * after 20,000.
     */
    @Test
    void aPageStaysAsLargeAsItIs() throws Exception {
        String grow =
                "(n => { const p = robosim, first = p.data.frames; for (let k = first; k < first + n; k++) grow(p.data,"
                        + " { frame: k, placed: [[0, -5 + (k %% 100) * 1e-2, 0, 0, 0, 0, 0, 1]], heard: [[0, [[0, 0.1, 6, 0, 0, 0]],"
                        + " [k %% 5]]], refused: k %% 10 ? [] : [[0, 0, 3]], words: [''] }); p.dirty = true; })(%d)";
        browser.run(grow.formatted(40_000));
        picture();
        double early = browser.heap();
        int more = Effort.cases(540_000);
        browser.run(grow.formatted(more));
        picture();
        assertThat(browser.run("robosim.data.frames"))
                .satisfies(frames -> assertThat(number(frames)).isGreaterThan(40_000 + more));
        assertThat(browser.heap()).isLessThan(early * 1.5 + 1e6);
        assertThat(browser.complaints()).isEmpty();
    }
}
