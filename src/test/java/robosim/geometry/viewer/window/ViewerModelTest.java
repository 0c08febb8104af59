package robosim.geometry.viewer.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.Step;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.viewer.Talk;
import robosim.geometry.viewer.draw.Card;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.playback.Feed;
import robosim.geometry.viewer.playback.Sandbox;
import robosim.geometry.viewer.playback.StateHistory;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

@Tag("clock")
class ViewerModelTest {
    private static final long SECOND = 1_000_000_000;

    /** The wall of a file that has a colour for it. */
    private static final GeometryObject RED_WALL = Talk.WALL.withMaterial(Material.of(Color.parse("#ff0000")));

    static ViewerModel world() {
        World world = new World(
                20, 5, 10, List.of(new WorldObject(Talk.WALL, "#ff0000", List.of()), new WorldObject(Talk.DRUM)));
        ViewerModel viewing = ViewerModel.ofWorld(world, "small");
        viewing.camera.resize(1000, 600);
        return viewing;
    }

    /** All of a conversation, read and paused at its beginning. */
    static ViewerModel recording(Talk talk) throws Exception {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        talk.scenario().write(file);
        Feed feed = new Feed(StepReader.of(ScenarioReader.of(new ByteArrayInputStream(file.toByteArray()), "talk")));
        ViewerModel viewing = ViewerModel.ofRecording(feed, "talk", "");
        viewing.camera.resize(1000, 600);
        viewing.player.pause();
        while (!feed.isEnded()) {
            viewing.tick(0);
            Thread.onSpinWait();
        }
        viewing.tick(0);
        return viewing;
    }

    private static double x(ViewerModel viewing, double worldX) {
        return viewing.camera.frame().x(worldX);
    }

    private static double y(ViewerModel viewing, double worldZ) {
        return viewing.camera.frame().y(worldZ);
    }

    private static void press(ViewerModel viewing, double worldX, double worldZ) {
        viewing.press(x(viewing, worldX), y(viewing, worldZ));
    }

    private static void drag(ViewerModel viewing, double worldX, double worldZ) {
        viewing.drag(x(viewing, worldX), y(viewing, worldZ), Sandbox.Push.PLACE);
    }

    private static Point drum(ViewerModel viewing) {
        return viewing.life().things().get(0).object().center();
    }

    /** To the share of a pixel. */
    private static void assertDrumAt(ViewerModel viewing, double worldX, double worldZ) {
        assertThat(drum(viewing).x()).isCloseTo(worldX, within(1e-9));
        assertThat(drum(viewing).z()).isCloseTo(worldZ, within(1e-9));
    }

    @Test
    void aClickPicksAndTellsAllAboutIt() {
        ViewerModel viewing = world();
        assertThat(viewing.card()).isNull();
        press(viewing, 2, 1);
        viewing.release();
        assertThat(viewing.picked()).isEqualTo(RED_WALL);
        Card card = viewing.card();
        assertThat(card).isNotNull();
        assertThat(card.heading()).isEqualTo("wall");
        assertThat(card.lines())
                .containsExactly(
                        "box, cannot move", "at x 2, z 0, y 0", "heading 0 degrees", "width 1, length 4, height 1");
        assertThat(viewing.life().marks()).containsExactly(new Scene.Mark(RED_WALL, Scene.Mark.Why.PICKED));
        press(viewing, -8, 3);
        viewing.release();
        assertThat(viewing.picked()).isNull();
        press(viewing, -5, 0);
        viewing.release();
        assertThat(viewing.card().lines()).contains("cylinder, can move", "radius 0.5, height 1");
        viewing.escape();
        assertThat(viewing.picked()).isNull();
    }

    @Test
    void aRobotIsDraggedByWhereItWasTaken() {
        ViewerModel viewing = world();
        press(viewing, -5.2, 0.1);
        drag(viewing, -3.2, 2.1);
        viewing.release();
        assertDrumAt(viewing, -3, 2);
        assertThat(viewing.picked().center()).isEqualTo(drum(viewing));
    }

    @Test
    void whereARobotMayNotStandItIsSeenWhy() {
        ViewerModel viewing = world();
        press(viewing, -5, 0);
        drag(viewing, 0, 0);
        drag(viewing, 1.5, 0);
        assertDrumAt(viewing, 0, 0);
        assertThat(viewing.status()).isEqualTo("drum may not be there: wall is in the way");
        Scene life = viewing.life();
        assertThat(life.blocked()).hasSize(1);
        assertThat(life.blocked().get(0).obstacle()).isEqualTo(RED_WALL);
        assertThat(life.marks())
                .extracting(Scene.Mark::why)
                .containsExactly(Scene.Mark.Why.REFUSED, Scene.Mark.Why.PICKED);
        viewing.release();
        assertThat(viewing.life().blocked()).isEmpty();
        assertThat(viewing.status()).isEqualTo("drag what moves; H lists the keys");
    }

    @Test
    void aWayIsAskedForWithShift() {
        ViewerModel viewing = world();
        press(viewing, -5, 0);
        viewing.drag(x(viewing, 5), y(viewing, 0), Sandbox.Push.MOVE);
        assertThat(drum(viewing)).isEqualTo(new Point(-5, 0, 0));
        assertThat(viewing.status()).contains("wall is in the way");
        drag(viewing, 5, 0);
        assertDrumAt(viewing, 5, 0);
    }

    @Test
    void theGroundIsDraggedWhereNothingMoves() {
        ViewerModel viewing = world();
        viewing.wheel(500, 300, -3);
        double x = x(viewing, 2);
        press(viewing, 2, 0); // the wall cannot be dragged either
        viewing.drag(x + 30, y(viewing, 0), Sandbox.Push.PLACE);
        viewing.release();
        assertThat(x(viewing, 2)).isBetween(x + 29.999, x + 30.001);
        assertThat(viewing.picked()).isEqualTo(RED_WALL);
        // A hand that shakes drags nothing.
        viewing.press(100, 100);
        viewing.drag(102, 101, Sandbox.Push.PLACE);
        viewing.release();
        assertThat(x(viewing, 2)).isBetween(x + 29.999, x + 30.001);
    }

    @Test
    void thePickedRobotTurns() {
        ViewerModel viewing = world();
        viewing.turnPicked(15);
        press(viewing, -5, 0);
        viewing.release();
        viewing.turnPicked(15);
        GeometryObject drum = viewing.life().things().get(0).object();
        assertThat(drum.heading()).isEqualTo(15);
        press(viewing, 2, 0);
        viewing.release();
        viewing.turnPicked(15);
        assertThat(viewing.picked()).isEqualTo(RED_WALL);
    }

    @Test
    void aDragInARecordingIsInACopyOfItsMoment() throws Exception {
        ViewerModel viewing =
                recording(Talk.begun().drives(1, true).drives(1, true).drives(1, true));
        viewing.player.seek(2);
        press(viewing, -3, 0);
        viewing.release();
        assertThat(viewing.picked().name()).isEqualTo("drum");
        assertThat(viewing.status()).startsWith("step 3 of 4: 1 move");
        press(viewing, -3, 0);
        drag(viewing, -3, 3);
        viewing.release();
        assertDrumAt(viewing, -3, 3);
        assertThat(viewing.status()).startsWith("a local copy of step 3, Esc goes back");
        viewing.tick(SECOND);
        viewing.escape();
        assertThat(drum(viewing)).isEqualTo(new Point(-3, 0, 0));
        // Going on leaves the copy as well.
        press(viewing, -3, 0);
        drag(viewing, -3, 3);
        viewing.release();
        viewing.leaveCopy();
        viewing.player.step(1);
        assertThat(drum(viewing)).isEqualTo(new Point(-2, 0, 0));
    }

    @Test
    void aRecordingShowsItsStepsAndNotes() throws Exception {
        ViewerModel viewing = recording(Talk.begun().drives(9, false).looks(2.0));
        viewing.player.seek(1);
        Scene life = viewing.life();
        assertThat(life.blocked()).hasSize(1);
        assertThat(life.trails()).hasSize(1);
        assertThat(viewing.ground().things()).hasSize(1);
        viewing.player.seek(2);
        assertThat(viewing.life().pings()).hasSize(1);
        assertThat(viewing.life().farthest()).isEqualTo(2);
        viewing.layers().nextTrails();
        viewing.layers().nextTrails(); // none
        assertThat(viewing.life().refusals()).isEmpty();
    }

    @Test
    void aSessionIsFollowedUntilItIsPaused() throws Exception {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        Talk.begun().drives(1, true).drives(1, true).scenario().write(file);
        Feed feed = new Feed(StepReader.of(ScenarioReader.of(new ByteArrayInputStream(file.toByteArray()), "talk")));
        ViewerModel viewing = ViewerModel.ofLive(feed, "talk", "m");
        while (!feed.isEnded()) {
            viewing.tick(1);
        }
        viewing.tick(1);
        assertThat(viewing.player.position()).isEqualTo(2);
        assertThat(viewing.pace()).isEqualTo("live");
        assertThat(viewing.status()).isEqualTo("step 3 of 3: 1 move; the session is over");
        viewing.player.step(-1);
        assertThat(viewing.pace()).isEqualTo("paused");
        assertThat(drum(viewing)).isEqualTo(new Point(-4, 0, 0));
        assertThat(viewing.life().unit()).isEqualTo("m");
    }

    @Test
    void aWorldFileLendsItsColours() throws Exception {
        World world = new World(20, 5, 10, List.of(new WorldObject(Talk.WALL, "#ff0000", List.of())));
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        Talk.begun().scenario().write(file);
        Feed feed = new Feed(
                StepReader.of(ScenarioReader.of(new ByteArrayInputStream(file.toByteArray()), "talk")),
                Colours.of(world),
                () -> "");
        ViewerModel viewing = ViewerModel.ofRecording(feed, "talk", "");
        while (!feed.isEnded()) {
            viewing.tick(1);
        }
        viewing.tick(1);
        assertThat(viewing.ground().things()).containsExactly(new Scene.Thing(Talk.WALL, 0xff0000));
    }

    @Test
    void whatCannotBeReadIsTold() throws Exception {
        String file = "{\"type\":\"scenario\",\"version\":1,\"title\":\"t\"}\n{\"type\":\"nonsense\"}\n";
        Feed feed = new Feed(StepReader.of(ScenarioReader.of(new ByteArrayInputStream(file.getBytes("UTF-8")), "bad")));
        ViewerModel viewing = ViewerModel.ofRecording(feed, "bad", "");
        while (!feed.isEnded()) {
            Thread.onSpinWait();
        }
        viewing.tick(1);
        assertThat(viewing.status()).startsWith("nothing was recorded; bad:2: ");
        assertThat(viewing.life().things()).isEmpty();
        press(viewing, 0, 0);
        viewing.release();
        viewing.turnPicked(15);
    }

    @Test
    void aColourStaysWithItsNameWhereverThatStands() throws Exception {
        GeometryObject nameless = new BoxObject(new Point(5, 0, 3), 1, 1, 1);
        World world = new World(
                20,
                5,
                10,
                List.of(
                        new WorldObject(Talk.DRUM, "#00ff00", List.of()),
                        new WorldObject(nameless, "#0000ff", List.of())));
        Colours colours = Colours.of(world);
        assertThat(colours.of(Talk.DRUM.movedTo(new Point(1, 0, 1)))).isEqualTo(0x00ff00);
        assertThat(colours.of(nameless)).isEqualTo(0x0000ff);
        assertThat(colours.of(nameless.movedTo(new Point()))).isNull();
        assertThat(colours.of(Talk.WALL)).isNull();
    }

    @Test
    void aRobotBeyondTheBorderIsShownAndCanBeDraggedIn() {
        GeometryObject lost = new CylinderObject(new Point(12, 0, 0), 0.5, 1).moveable("lost");
        World world = new World(
                20, 5, 10, List.of(new WorldObject(Talk.WALL), new WorldObject(Talk.DRUM), new WorldObject(lost)));
        ViewerModel viewing = ViewerModel.ofWorld(world, "small");
        viewing.camera.resize(1000, 600);
        assertThat(viewing.life().things())
                .extracting(thing -> thing.object().name())
                .containsExactly("drum", "lost");
        assertThat(viewing.life().marks()).containsExactly(new Scene.Mark(lost, Scene.Mark.Why.REFUSED));
        Scene.View seen = viewing.camera.frame().visible();
        assertThat(seen.minX()).isLessThan(-10);
        assertThat(seen.maxX()).isGreaterThan(12.5);
        assertThat(viewing.status()).startsWith("drag what moves; lost is not in the world");
        press(viewing, 12, 0);
        drag(viewing, 2, 0);
        assertThat(viewing.status()).isEqualTo("lost may not be there: wall is in the way");
        viewing.release();
        viewing.turnPicked(15);
        assertThat(viewing.status()).isEqualTo("lost may not be there: the border of the world is in the way");
        press(viewing, 12, 0);
        drag(viewing, 6, 0);
        viewing.release();
        assertThat(viewing.status()).isEqualTo("drag what moves; H lists the keys");
        assertThat(viewing.life().things().get(1).object().center().x()).isCloseTo(6, within(1e-9));
        press(viewing, 6, 0);
        drag(viewing, 5, 3);
        assertThat(viewing.life().things().get(1).object().center().z()).isCloseTo(3, within(1e-9));
    }

    @Test
    void anotherServersHeaderIsHeeded() throws Exception {
        // In space the drum passes over a low wall; in the plane it does not.
        GeometryObject low = new BoxObject(new Point(0, -2, 0), 1, 1, 4).named("low");
        Bundle init = new InitBundle(List.of(low, Talk.DRUM));
        Bundle go = new MoveBundle(List.of(Talk.move(5, 0)));
        SessionOptions planar = SessionOptions.ROBOSIM;
        SessionOptions spatial = new SessionOptions(Dimension.SPATIAL, planar.accuracy(), planar.beam());
        Deque<Step> steps = new ArrayDeque<>();
        for (int k = 0; k < 2; k++) {
            steps.add(new Step(init, null));
            steps.add(new Step(go, null));
        }
        StepReader reader = new StepReader() {
            @Override
            public ScenarioHeader header() {
                return new ScenarioHeader("", steps.size() >= 2 ? planar : spatial);
            }

            @Override
            public @Nullable Step next() {
                return steps.poll();
            }

            @Override
            public void close() {}
        };
        Feed feed = new Feed(reader);
        StateHistory film = new StateHistory();
        while (!feed.isEnded()) {
            feed.drain(film, 100);
        }
        assertThat(film.size()).isEqualTo(4);
        assertThat(film.frame(1).bumps()).hasSize(1);
        assertThat(film.frame(3).bumps()).isEmpty();
    }

    @Test
    void noMoreWorldsWaitThanThereIsRoomFor() throws Exception {
        List<Point> vertices = new ArrayList<>();
        int[][] faces = new int[50_000][];
        for (int k = 0; k < faces.length; k++) {
            vertices.add(new Point(k % 200 / 100.0, 0, k / 200 / 100.0));
            faces[k] = new int[] {k, Math.floorMod(k - 1, faces.length), Math.floorMod(k - 200, faces.length)};
        }
        Bundle init = new InitBundle(List.of(new MeshObject(vertices, faces))); // 100,000 of a million
        AtomicInteger read = new AtomicInteger();
        StepReader reader = new StepReader() {
            @Override
            public ScenarioHeader header() {
                return new ScenarioHeader("", SessionOptions.ROBOSIM);
            }

            @Override
            public @Nullable Step next() {
                return read.incrementAndGet() > 30 ? null : new Step(init, null);
            }

            @Override
            public void close() {}
        };
        Feed feed = new Feed(reader);
        while (read.get() < 10) {
            Thread.sleep(1);
        }
        Thread.sleep(200); // were there no end of the room, the rest would come
        assertThat(read.get()).isBetween(10, 11);
        StateHistory film = new StateHistory();
        while (!feed.isEnded()) {
            feed.drain(film, 1);
        }
        assertThat(film.size()).isEqualTo(30);
    }
}
