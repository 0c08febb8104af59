package robosim.geometry.export;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.scenario.Step;
import robosim.geometry.viewer.playback.StateHistory;

/** A page in a real browser without a window, where there is one: Chromium draws WebGL 2 without a graphics card. */
@Tag("clock")
@Timeout(300)
class PageInBrowserTest {
    private static final Path SCRIPTS = Path.of("src/test/resources/robosim/geometry/export");

    /** All kinds of objects; a robot that sees, moves, and is refused by a drum. */
    private static StateHistory film(Dimension dimension) {
        List<Step> steps = new ArrayList<>();
        WorldSettings settings = new WorldSettings(16, 8, 16, dimension, Accuracy.EXACT);
        steps.add(new Step(new InitBundle(Pages.kinds(), settings), null));
        Beam wide = new Beam(0, 6, 0.4);
        for (int k = 0; k < 4; k++) {
            steps.add(new Step(
                    new MoveBundle(List.of(
                            new MoveRequest("robot", 0.4, 0, 0, 0, 0.5), new MoveRequest("cart", 0, 0, 0.3, 0, 0.2))),
                    null));
            steps.add(new Step(
                    new SonarRequestBundle(List.of(
                            new SonarRequest("robot", 1, 0, wide),
                            new SonarRequest("robot", 0, 1, wide),
                            new SonarRequest("cart", 1, 0, Beam.LINE))),
                    null));
        }
        steps.add(new Step(new MoveBundle(List.of(new MoveRequest("robot", 30, 0, 0, 0, 0))), null));
        steps.add(new Step(new MoveBundle(List.of(new MoveRequest("cart", 0, 0, 4, 0, 0))), null));
        return Pages.film(steps);
    }

    /** Visits a page and returns what the visitor wrote down. */
    private static Map<String, String> visit(StateHistory film, Path folder) throws Exception {
        String browser = Program.find("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
                .orElse("");
        Assumptions.assumeFalse(browser.isEmpty(), "no Chromium or Chrome on the path, which opens the page");
        Path file = folder.resolve("page.html");
        List<GeometryObject> goals = List.of(new CylinderObject(new Point(5, 0.05, 5), 1, 0.1));
        new PageWriter(film).titled("a <b>page</b> & more").withGoals(goals).write(file);
        String page = Files.readString(file);
        String before = "<script>" + Files.readString(SCRIPTS.resolve("errors.js")) + "</script>\n<style>";
        String after = "<script>" + Files.readString(SCRIPTS.resolve("visit.js")) + "</script>\n</body>";
        Files.writeString(
                file,
                page.replaceFirst("<style>", Matcher.quoteReplacement(before)).replace("</body>", after));
        Program.Said said = Program.run(
                folder,
                200,
                Map.of("HOME", folder.toString()),
                List.of(
                        browser,
                        "--headless=new",
                        "--no-sandbox",
                        "--disable-gpu",
                        "--use-angle=swiftshader",
                        "--enable-unsafe-swiftshader",
                        "--hide-scrollbars",
                        "--window-size=640,480",
                        "--user-data-dir=" + folder.resolve("profile"),
                        "--virtual-time-budget=20000",
                        "--dump-dom",
                        file.toUri().toString()));
        Matcher result = Pattern.compile("(?s)<pre id=\"result\">(.*?)</pre>").matcher(said.out());
        assertThat(result.find())
                .as("the visitor came to an end: %s", said.err())
                .isTrue();
        Map<String, String> seen = new LinkedHashMap<>();
        for (String line : result.group(1).strip().lines().toList()) {
            Matcher words = Pattern.compile("(without \\w|\\S+) (.*)").matcher(line);
            assertThat(words.matches()).as(line).isTrue();
            seen.put(words.group(1), words.group(2));
        }
        assertThat(seen)
                .as("nothing in the browser's console: %s", result.group(1))
                .doesNotContainKey("WRONG");
        assertThat(said.out()).contains("<title>a &lt;b&gt;page&lt;/b&gt; &amp; more</title>");
        return seen;
    }

    private static double number(Map<String, String> seen, String name) {
        return Double.parseDouble(seen.get(name));
    }

    @Test
    void theWorldIsDrawnAndAStepMovesARobot(@TempDir Path folder) throws Exception {
        Map<String, String> seen = visit(film(Dimension.PLANAR), folder);
        assertThat(number(seen, "colors")).as("the canvas is not blank").isGreaterThan(500);
        assertThat(number(seen, "same")).as("of two pictures of one moment").isZero();
        assertThat(seen).containsEntry("step", "3").containsEntry("moved", "true");
        assertThat(number(seen, "changed")).isBetween(0.0005, 0.5);
        for (String camera : List.of("top", "eye", "follow", "orbit")) {
            String[] words = seen.get(camera).split(" ");
            assertThat(words[1]).isEqualTo(camera);
            assertThat(Integer.parseInt(words[0])).as(camera).isGreaterThan(200);
            double differing = Double.parseDouble(words[2]);
            assertThat(differing)
                    .as(camera)
                    .isBetween(camera.equals("orbit") ? 0 : 0.1, camera.equals("orbit") ? 0 : 1.0);
        }
        for (String what : List.of("s", "t", "d")) {
            assertThat(number(seen, "without " + what)).as(what).isGreaterThan(0.0001);
        }
        assertThat(seen.get("told")).startsWith("1 refused: robot by ");
        assertThat(seen).containsEntry("picked", "cart");
        assertThat(seen).containsEntry("playing", "true").containsEntry("played", "true");
        assertThat(seen)
                .containsEntry("help", "true")
                .containsEntry("paused", "true")
                .containsEntry("frames", "11");
    }

    @Test
    void inSpaceToo(@TempDir Path folder) throws Exception {
        Map<String, String> seen = visit(film(Dimension.SPATIAL), folder);
        assertThat(number(seen, "colors")).isGreaterThan(500);
        assertThat(seen).containsEntry("moved", "true");
        assertThat(number(seen, "without s")).isGreaterThan(0.001);
    }

    /** Checker, stripes and pictures, mirrors and lights, on all kinds of objects. */
    @Test
    void materialsAreDrawn(@TempDir Path folder) throws Exception {
        List<GeometryObject> objects = new ArrayList<>(GlbMaterialsTest.dressed());
        objects.add(new CylinderObject(new Point(5, 0.5, -14), 0.4, 1)
                .withMaterial(Material.DEFAULT.withMirror(0.7).withEmission(Color.parse("#302010"))));
        WorldSettings settings = new WorldSettings(80, 8, 80, Dimension.PLANAR, Accuracy.EXACT);
        Map<String, String> seen =
                visit(Pages.film(List.of(new Step(new InitBundle(objects, settings), null))), folder);
        assertThat(number(seen, "colors")).isGreaterThan(500);
    }

    /** The program itself, without data. */
    @Test
    void thePagesProgramIsSmall() throws IOException {
        assertThat(PageWriter.page("", "", new byte[0]).length()).isBetween(20_000, 70_000);
    }

    @Test
    void aThousandObjectsAndThreeThousandStepsAreSmall(@TempDir Path folder) throws IOException {
        StateHistory film = Pages.film(Pages.wander(1000, 20, 3000, true, new SplittableRandom(6)));
        Path page = folder.resolve("page.html");
        new PageWriter(film).write(page);
        assertThat(Files.size(page)).isLessThan(2_000_000);
        assertThat(film.size()).isEqualTo(3000);
    }
}
