package robosim.geometry.viewer.playback;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.Step;
import robosim.geometry.viewer.Talk;
import robosim.geometry.viewer.draw.Painter;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.SonarRing;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;

class PicturesTest {
    @Test
    void theLastMomentsShowWhatRefusedTheLastMove(@TempDir Path folder) throws Exception {
        Scenario scenario =
                Talk.begun().drives(2, true).looks(3.5).drives(9, false).scenario();
        Path file = folder.resolve("last.svg");
        Pictures.lastMoments(scenario, List.of(), null).write(file);
        String svg = Files.readString(file);
        DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8)));
        assertThat(svg).contains("a talk", "step 3 of 3: 1 distance; 1 move, 1 refused: drum by wall");
        assertThat(svg).containsOnlyOnce("class=\"block\"").containsOnlyOnce("class=\"trail\"");
        assertThat(svg).containsOnlyOnce("class=\"ping\"");
        assertThat(svg).isEqualTo(Painter.svg(Pictures.lastMoments(scenario, Colours.NONE)));
    }

    /** In a hall of 200 by 200 a robot that went two units would be a dot. */
    @Test
    void theLastMomentsOfALargeWorldShowOnlyWhereTheyWere(@TempDir Path folder) throws Exception {
        WorldSettings hall = new WorldSettings(200, 5, 200, Dimension.PLANAR, Accuracy.EXACT);
        List<GeometryObject> objects = List.of(
                Talk.WALL,
                new BoxObject(new Point(-95, 0, -95), 1, 1, 1).named("west"),
                new BoxObject(new Point(95, 0, 95), 1, 1, 1).named("east"),
                Talk.DRUM);
        Talk talk = new Talk()
                .step(new InitBundle(objects, hall), null)
                .drives(2, true)
                .drives(9, false);
        Path file = folder.resolve("last.svg");
        Pictures.lastMoments(talk.scenario(), List.of(), null).write(file);
        assertThat(radius(file)).isGreaterThan(20);
        // A goal far away is in the picture too.
        GeometryObject goal = new BoxObject(new Point(90, 0, 90), 1, 1, 1);
        Pictures.lastMoments(talk.scenario(), List.of(goal), null).write(file);
        assertThat(radius(file)).isBetween(2.0, 10.0);
        // Nothing moved: all of it.
        Talk still = new Talk().step(new InitBundle(objects, hall), null);
        Pictures.lastMoments(still.scenario(), List.of(), null).write(file);
        assertThat(radius(file)).isBetween(2.0, 4.0);
    }

    /** That of the drum, pixels. */
    private static double radius(Path file) throws IOException {
        return Pattern.compile("<title>drum</title>\\s*<circle[^>]* r=\"([0-9.]+)\"")
                .matcher(Files.readString(file))
                .results()
                .mapToDouble(found -> Double.parseDouble(found.group(1)))
                .max()
                .orElse(0);
    }

    /** A conversation has neither; a world's file lends both. */
    @Test
    void theLastMomentsHaveTheColoursAndTheUnitOfTheFile(@TempDir Path folder) throws Exception {
        Scenario scenario = Talk.begun().drives(9, false).scenario();
        List<WorldObject> coloured = new ArrayList<>();
        for (Step step : scenario.steps()) {
            if (step.request() instanceof InitBundle init) {
                init.objects().forEach(each -> coloured.add(new WorldObject(each, "#12ab56", List.of())));
            }
        }
        World world = new World(99, 9, 99, Unit.CENTIMETRE, Dimension.SPATIAL, Accuracy.EXACT, coloured);
        Path file = folder.resolve("last.svg");
        Pictures.lastMoments(scenario, List.of(), world).write(file);
        assertThat(Files.readString(file)).contains("#12ab56", " cm<");
        Pictures.lastMoments(scenario, List.of(), null).write(file);
        assertThat(Files.readString(file)).doesNotContain("#12ab56", " cm<");
    }

    @Test
    void aStoredScenarioHasItsLastMoments() throws Exception {
        Scenario scenario = Scenario.read(Path.of("worlds/scenarios/by-hand.scenario.jsonl"));
        Scene scene = Pictures.lastMoments(scenario, Colours.NONE);
        assertThat(scene.things()).hasSizeGreaterThan(50);
        assertThat(scene.refusals()).hasSize(1);
        assertThat(scene.blocked()).hasSize(1);
    }

    @Test
    void aConversationOfNothingIsAPictureToo() {
        Scenario empty = new Scenario(new ScenarioHeader("nothing", SessionOptions.ROBOSIM), new Talk().steps());
        assertThat(Painter.svg(Pictures.lastMoments(empty, Colours.NONE))).contains("nothing");
    }

    /** One beam for each sonar of the file, as far as its world answers. */
    @Test
    void theSonarsOfAFileAreOnItsPlan() throws Exception {
        World world = WorldReader.read(Path.of("worlds/rooms.xml"));
        Geometry geometry = world.toGeometry(outside -> {});
        List<Double> expected = new ArrayList<>();
        for (WorldObject each : world.objects()) {
            for (SonarRing ring : each.sonars()) {
                for (int k = 0; k < ring.count(); k++) {
                    Point to = ring.direction(k);
                    expected.add(geometry.getSonarDistance(
                            each.object().name(), to.x(), to.z(), ring.min(), ring.max(), ring.width()));
                }
            }
        }
        assertThat(expected).hasSizeGreaterThan(50);
        assertThat(Pictures.sensed(world, "rooms").pings())
                .extracting(Scene.Ping::distance)
                .isEqualTo(expected);
        assertThat(Pictures.of(world, "rooms").pings()).isEmpty();
    }

    @Test
    void titlesAreNamesOfFiles() {
        assertThat(Pictures.title(Path.of("worlds/rooms.xml"))).isEqualTo("rooms");
        assertThat(Pictures.title(Path.of("a.b.scenario.jsonl"))).isEqualTo("a.b");
    }
}
