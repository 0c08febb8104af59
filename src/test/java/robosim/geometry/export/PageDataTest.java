package robosim.geometry.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.Step;
import robosim.geometry.viewer.Talk;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.playback.Replayer;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.WorldReader;

/** What a page contains is what happened, to within the errors that docs/export.md states. */
@Tag("slow")
class PageDataTest {
    /** Half a step of an angle, in degrees, and what single precision adds. */
    private static final double ANGLE = 180.0 / 65536 * 1.0001;

    /** Of a rotation told by four numbers of 1/32,768: 2 * sqrt(4) * 2^-16 radians, as entries of a matrix. */
    private static final double ROTATION = 4.0 / 65536;

    static List<Path> scenarios() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("worlds", "scenarios"))) {
            return files.sorted().toList();
        }
    }

    private static byte[] data(StateHistory film) {
        return new PageData(film, film.first(), film.size(), new PageData.Labels("a title", "below", "m"), List.of())
                .toBytes();
    }

    /** The most that any coordinate is off, in steps of the page. */
    private static double compared(StateHistory film, int from, DecodedPage page) {
        double worst = 0;
        double step = page.unit / 8192;
        int chapter = -1;
        for (int n = from; n < from + page.frames; n++) {
            while (chapter + 1 < page.chapters.size() && page.chapters.get(chapter + 1).begin == n - from) {
                chapter++;
            }
            if (chapter < 0) {
                continue;
            }
            List<Scene.Thing> movers = film.movers(n);
            assertThat(page.chapters.get(chapter).movers).hasSameSizeAs(movers);
            for (int k = 0; k < movers.size(); k++) {
                GeometryObject mover = movers.get(k).object();
                double[] place = page.chapters.get(chapter).place(k, n - from);
                Point center = mover.center();
                double[] at = {center.x(), center.y(), center.z()};
                for (int axis = 0; axis < 3; axis++) {
                    worst = Math.max(worst, Math.abs(place[axis] - at[axis]) / step);
                }
                double[] rotation = mover.pose().rotation();
                double allowed = mover.pose().isUpright() ? Math.max(Math.toRadians(ANGLE), ROTATION) : ROTATION;
                for (int j = 0; j < 9; j++) {
                    assertThat(place[3 + j])
                            .as("rotation %s of %s after %s", j, k, n)
                            .isCloseTo(rotation[j], within(allowed));
                }
                int id = page.chapters.get(chapter).movers.get(k);
                assertThat(page.things.get(id).name()).isEqualTo(mover.name());
            }
        }
        return worst;
    }

    private static void comparedEvents(StateHistory film, DecodedPage page) {
        List<String> bumps = new ArrayList<>();
        List<String> scans = new ArrayList<>();
        for (DecodedPage.Chapter chapter : page.chapters) {
            for (DecodedPage.Bump bump : chapter.bumps) {
                int k = bump.obstacle() - 2;
                int id = k < 0
                        ? -1
                        : k < chapter.movers.size()
                                ? chapter.movers.get(k)
                                : chapter.statics.get(k - chapter.movers.size());
                String name = page.things.get(chapter.movers.get(bump.mover())).name();
                bumps.add(bump.frame() + " " + name + " by "
                        + (id < 0 ? bump.obstacle() : page.things.get(id).name()));
            }
            for (int k = 0; k < chapter.scans.size(); k++) {
                String name = page.things.get(chapter.movers.get(k)).name();
                for (DecodedPage.Scan scan : chapter.scans.get(k)) {
                    scans.add(scan.frame() + " " + name);
                    List<Scene.Ping> pings = film.frame(scan.frame()).heard().get(name);
                    assertThat(scan.sensors()).isEqualTo(pings.size());
                    for (int s = 0; s < scan.sensors(); s++) {
                        Scene.Ping ping = pings.get(s);
                        if (Double.isInfinite(ping.distance())) {
                            assertThat(scan.distances()[s]).isInfinite();
                        } else {
                            assertThat(scan.distances()[s])
                                    .isCloseTo(ping.distance(), within(page.unit / 4096 * 1.0001));
                        }
                        assertThat(scan.widths()[s]).isCloseTo(ping.width(), within(ANGLE));
                        assertThat((float) scan.ranges()[s]).isEqualTo((float) ping.range());
                        double heading = chapter.movers.isEmpty() ? 0 : heading(film, scan.frame(), k);
                        double off = Math.IEEEremainder(scan.bearings()[s] + heading - ping.heading(), 360);
                        assertThat(off).isCloseTo(0, within(ANGLE));
                        Pose pose = film.movers(scan.frame()).get(k).object().pose();
                        double[] place = scan.places()[s];
                        Point start = Pose.of(new Point(place[0], place[1], place[2]), 0)
                                .within(pose)
                                .center();
                        assertThat(start.x()).isCloseTo(ping.start().x(), within(1e-5));
                        assertThat(start.y()).isCloseTo(ping.start().y(), within(1e-5));
                        assertThat(start.z()).isCloseTo(ping.start().z(), within(1e-5));
                    }
                }
            }
        }
        List<String> expectedBumps = new ArrayList<>();
        List<String> expectedScans = new ArrayList<>();
        for (int n = 0; n < film.size(); n++) {
            for (Frame.Bump bump : film.frame(n).bumps()) {
                GeometryObject obstacle =
                        bump.result() == null ? null : bump.result().obstacle();
                String by = bump.result() == null
                        ? "0"
                        : obstacle == null ? "1" : obstacle.name() == null ? "" : obstacle.name();
                expectedBumps.add(n + " " + bump.mover().name() + " by " + by);
            }
            for (String name : film.frame(n).heard().keySet()) {
                expectedScans.add(n + " " + name);
            }
        }
        assertThat(bumps).containsExactlyInAnyOrderElementsOf(expectedBumps);
        assertThat(scans).containsExactlyInAnyOrderElementsOf(expectedScans);
    }

    private static double heading(StateHistory film, int frame, int mover) {
        return film.movers(frame).get(mover).object().heading();
    }

    @ParameterizedTest
    @MethodSource("scenarios")
    void everyStoredScenarioIsToldAsItWas(Path file) throws IOException {
        StateHistory film = Replayer.film(Scenario.read(file), Colours.NONE);
        DecodedPage page = DecodedPage.of(data(film));
        assertThat(page.frames).isEqualTo(film.size());
        assertThat(compared(film, 0, page)).isLessThanOrEqualTo(0.5 + 1e-6);
        comparedEvents(film, page);
    }

    /** Rounding does not add up: the last place is as good as the first, and the bound is reached. */
    @Test
    void longWaysAreToldAsWellAsShortOnes() {
        StateHistory film = Pages.film(Pages.wander(60, 12, 1000, true, new SplittableRandom(1)));
        DecodedPage page = DecodedPage.of(data(film));
        assertThat(compared(film, 0, page)).isBetween(0.45, 0.5 + 1e-6);
        comparedEvents(film, page);
        assertThat(page.chapters.get(0).bumps).hasSizeGreaterThan(25);
    }

    /** A laser that a batch asks, mounted ahead of the centre, while its robot turns and drives. */
    @Test
    void aMountedLaserMeasuresFromItsPlace() {
        SenseRequest laser = new SenseRequest(
                "drum",
                new Mount(new Point(0.4, 0.2, -0.1)),
                new BeamPattern.Fan(-1, 0.01, 201),
                0,
                6,
                0,
                false,
                false,
                false,
                ScanMotion.NONE,
                false,
                List.of());
        Talk talk = Talk.begun();
        for (int k = 0; k < 5; k++) {
            talk.step(new BatchRequestBundle(List.of(laser)), null)
                    .turns(37, null)
                    .drives(0.3, null);
        }
        StateHistory film = talk.film();
        DecodedPage page = DecodedPage.of(data(film));
        comparedEvents(film, page);
        assertThat(page.chapters.get(0).scans.get(0)).hasSize(5).allSatisfy(scan -> {
            assertThat(scan.sensors()).isBetween(60, 120);
            assertThat(scan.places()[0]).containsExactly(new double[] {0.4, 0.2, -0.1}, within(1e-6));
        });
    }

    @Test
    void whatTipsOverIsToldToo() {
        StateHistory film = Pages.film(Pages.tumble(600, new SplittableRandom(2)));
        DecodedPage page = DecodedPage.of(data(film));
        assertThat(compared(film, 0, page)).isBetween(0.4, 0.5 + 1e-6);
        comparedEvents(film, page);
        assertThat(film.movers(film.size() - 1).get(0).object().pose().isUpright())
                .isFalse();
    }

    @Test
    void aPartBeginsWhereItBegins() {
        StateHistory film = Pages.film(Pages.wander(20, 4, 300, false, new SplittableRandom(3)));
        PageData data = new PageData(film, 100, 180, new PageData.Labels("", "", ""), List.of());
        DecodedPage page = DecodedPage.of(data.toBytes());
        assertThat(page.first).isEqualTo(100);
        assertThat(page.frames).isEqualTo(80);
        assertThat(compared(film, 100, page)).isLessThanOrEqualTo(0.5 + 1e-6);
    }

    /** In one world after another: an object that all have is told once. */
    @Test
    void worldsShareTheirObjects() {
        GeometryObject other = new CylinderObject(new Point(5, 0, 3), 0.5, 1).moveable("drum");
        Talk talk = Talk.begun()
                .drives(1, null)
                .world(Talk.WALL, other)
                .drives(1, null)
                .looks(null);
        DecodedPage page = DecodedPage.of(data(talk.film()));
        assertThat(page.chapters).hasSize(2);
        assertThat(page.things).hasSize(2);
        assertThat(compared(talk.film(), 0, page)).isLessThanOrEqualTo(0.5 + 1e-6);
        assertThat(page.remarks).containsExactly("0: a new world of 2 objects", "2: a new world of 2 objects");
    }

    /** Sizes from subnormal to enormous: the unit follows, and nothing is lost in it. */
    @ParameterizedTest
    @org.junit.jupiter.params.provider.ValueSource(doubles = {1e-250, 1e-30, 1, 1024, 1e25})
    void worldsOfAnySize(double size) {
        StateHistory film = new StateHistory();
        GeometryObject robot = new CylinderObject(new Point(0.3 * size, 0, -0.1 * size), 0.1 * size, size)
                .turned(0, 12.5)
                .moveable("robot");
        Frame.Setting setting = new Frame.Setting(
                size,
                size,
                size,
                robosim.geometry.model.Dimension.SPATIAL,
                robosim.geometry.model.Accuracy.EXACT,
                List.of(),
                List.of(new Scene.Thing(robot, null)));
        film.append(opening(setting, "begins"));
        Pose there =
                robot.movedTo(new Point(-0.4 * size, 0.2 * size, 0.4 * size)).pose();
        film.append(new Frame(null, Map.of("robot", there), List.of(), Map.of(), "", List.of(), null));
        DecodedPage page = DecodedPage.of(data(film));
        assertThat(compared(film, 0, page)).isLessThanOrEqualTo(0.5 + 1e-6);
        assertThat(size / page.unit).isGreaterThan(16).isLessThanOrEqualTo(32);
    }

    private static Frame opening(Frame.Setting setting, String words) {
        return new Frame(setting, Map.of(), List.of(), Map.of(), words, List.of(), null);
    }

    @Test
    void theObjectsOfAllKinds() {
        List<GeometryObject> kinds = Pages.kinds();
        StateHistory film = new StateHistory();
        film.append(opening(
                Frame.Setting.of(new robosim.geometry.world.World(
                        20,
                        4,
                        16,
                        kinds.stream()
                                .map(robosim.geometry.world.WorldObject::new)
                                .toList())),
                "all"));
        List<GeometryObject> goals = List.of(new CylinderObject(new Point(1, 0, 1), 0.5, 0.01));
        DecodedPage page = DecodedPage.of(new PageData(film, 0, 1, new PageData.Labels("", "", ""), goals).toBytes());
        assertThat(page.goals).containsExactly(0);
        assertThat(page.things).hasSize(kinds.size() + 1);
        int[][] parts = {
            {1}, {0, 1}, {0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 0, 1}, {1, 1, 1}, {0, 0, 0, 0, 0, 1}, {0, 1}, {1}
        };
        for (int k = 0; k < parts.length; k++) {
            DecodedPage.Thing thing = page.things.get(k + 1);
            assertThat(thing.parts()).as(kinds.get(k).toString()).startsWith(parts[k]);
            assertThat(java.util.Arrays.stream(thing.parts()).sum())
                    .isEqualTo(java.util.Arrays.stream(parts[k]).sum());
            if (!kinds.get(k).isMoveable()) {
                assertThat(thing.center()[2]).isCloseTo(kinds.get(k).center().z(), within(1e-6));
            }
        }
        assertThat(page.things.get(7).rectangles()).isEqualTo(2);
        assertThat(page.meshTriangles).containsExactly(6);
    }

    /** Of its own file, with its colours; and the sonars of its robots. */
    @Test
    void aWorldShowsWhatItsSonarsMeasure() throws IOException {
        StateHistory film = StateHistory.of(WorldReader.read(Path.of("worlds", "rooms.xml")));
        DecodedPage page = DecodedPage.of(data(film));
        assertThat(page.chapters.get(0).scans)
                .hasSize(8)
                .allSatisfy(scans -> assertThat(scans).hasSize(1));
        comparedEvents(film, page);
        assertThat(page.things).extracting(DecodedPage.Thing::colour).contains(0x5b6470, 0xe08a1e);
    }

    /** The page's own program decodes to the same, where node is there to run it. */
    @Test
    void thePagesProgramAgrees(@TempDir Path folder) throws Exception {
        Assumptions.assumeTrue(Program.find("node").isPresent(), "no node on the path, which runs the page's program");
        List<StateHistory> films = List.of(
                Replayer.film(Scenario.read(Path.of("worlds", "scenarios", "wandering.scenario.jsonl")), Colours.NONE),
                Pages.film(Pages.wander(60, 12, 1000, true, new SplittableRandom(4))),
                Pages.film(Pages.tumble(300, new SplittableRandom(5))));
        Path script = Path.of("src/test/resources/robosim/geometry/export/decode.js");
        for (StateHistory film : films) {
            byte[] data = data(film);
            Path file = Files.writeString(folder.resolve("page.html"), PageWriter.page("a <title>", "", data));
            Program.Said said = Program.run(folder, 60, Map.of(), List.of("node", script.toString(), file.toString()));
            assertThat(said.err()).isEmpty();
            assertThat(said.code()).isZero();
            DecodedPage page = DecodedPage.of(data);
            int poses = 0;
            for (String line : said.out().lines().toList()) {
                String[] words = line.split(" ", -1);
                if (words[0].equals("pose")) {
                    double[] place = page.chapters
                            .get(Integer.parseInt(words[1]))
                            .place(Integer.parseInt(words[2]), Integer.parseInt(words[3]));
                    double[] told = Stream.of(words)
                            .skip(4)
                            .mapToDouble(Double::parseDouble)
                            .toArray();
                    double[] expected = {
                        place[0], place[1], place[2], place[3], place[6], place[9], place[4], place[7], place[10]
                    };
                    assertThat(told).as(line).containsExactly(expected, within(1e-9));
                    poses++;
                } else if (words[0].equals("story")) {
                    int frame = Integer.parseInt(words[1]);
                    String expected = film.frame(frame).words();
                    String story = line.substring(("story " + frame + " ").length());
                    if (film.frame(frame).bumps().isEmpty() && !expected.contains("moves")) {
                        assertThat(story).contains(expected);
                    }
                    assertThat(story.contains(" refused"))
                            .as(line)
                            .isEqualTo(!film.frame(frame).bumps().isEmpty());
                }
            }
            assertThat(poses).isGreaterThan(50);
            assertThat(said.out().lines().filter(line -> line.startsWith("object ")))
                    .hasSameSizeAs(page.things);
        }
    }

    /** Each look is told once, with its pattern; parts of a group have their own. */
    @Test
    void materialsAreTold() {
        Material tiles = Material.DEFAULT
                .withTexture(new Texture.Checker(Color.WHITE, Color.parse("#102030"), 0.5))
                .withMirror(0.2);
        Material tape = Material.DEFAULT.withTexture(new Texture.Stripes(Color.BLACK, Color.WHITE, 0.25, 45));
        ImageTexture halves = new ImageTexture(2, 1, new int[] {0xff0000, 0x000000}, 1, 1);
        ObjectGroup pair = new ObjectGroup(List.of(
                new BoxObject(new Point(0, 0, 0), 1, 1, 1),
                new SphereObject(new Point(2, 0, 0), 1).withMaterial(tape)));
        List<GeometryObject> objects = List.of(
                new BoxObject(new Point(0, 0, 0), 1, 1, 1).withMaterial(tiles).named("a"),
                new BoxObject(new Point(3, 0, 0), 1, 1, 1)
                        .withMaterial(tiles.withLabel(7))
                        .named("b"),
                pair.movedTo(new Point(0, 0, 5)).withMaterial(Material.DEFAULT.withTexture(halves)),
                new SphereObject(new Point(0, 5, 0), 1)
                        .withMaterial(Material.of(Color.parse("#445566")).withEmission(Color.parse("#778899"))));
        WorldSettings settings = new WorldSettings(20, 20, 20, Dimension.SPATIAL, Accuracy.EXACT);
        StateHistory film = Pages.film(List.of(new Step(new InitBundle(objects, settings), null)));
        DecodedPage page =
                DecodedPage.of(new PageData(film, 0, 1, new PageData.Labels("", "", ""), List.of()).toBytes());
        double gloss = Math.rint(25.5);
        assertThat(page.looks)
                .containsExactly(
                        List.of(255., 255., 255., 0., 0., 0., gloss, 51., 1., 16., 32., 48., 0.5),
                        List.of(188., 0., 0., 0., 0., 0., gloss, 0., 0.),
                        List.of(0., 0., 0., 0., 0., 0., gloss, 0., 2., 255., 255., 255., 0.25, (double)
                                (float) Math.toRadians(45)),
                        List.of(68., 85., 102., 119., 136., 153., gloss, 0., 0.));
        assertThat(page.lookOf).containsExactly(0, 0, 1, 2, 3);
    }
}
