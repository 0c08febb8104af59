package robosim.geometry.viewer.playback;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.viewer.Talk;
import robosim.geometry.viewer.scene.Scene;

class ReplayerTest {
    private static Point drum(StateHistory film, int number) {
        return film.movers(number).get(0).object().center();
    }

    private static Frame.Bump onlyBump(StateHistory film, int number) {
        List<Frame.Bump> bumps = film.frame(number).bumps();
        assertThat(bumps).hasSize(1);
        return bumps.get(0);
    }

    @Test
    void placesAreThoseOfTheSession() {
        StateHistory film = Talk.begun()
                .drives(1, true)
                .turns(90, true)
                .drives(2, true)
                .drives(0.25, null)
                .film();
        assertThat(drum(film, 0)).isEqualTo(new Point(-5, 0, 0));
        assertThat(drum(film, 1)).isEqualTo(new Point(-4, 0, 0));
        assertThat(film.movers(2).get(0).object().heading()).isEqualTo(90);
        assertThat(drum(film, 3)).isEqualTo(new Point(-4, 0, -2));
        assertThat(drum(film, 4)).isEqualTo(new Point(-4, 0, -2.25));
    }

    @Test
    void whatRefusedAMoveIsFoundAnew() {
        StateHistory film =
                Talk.begun().drives(9, false).turns(180, true).drives(7, null).film();
        Frame.Bump wall = onlyBump(film, 1);
        assertThat(wall.obstacle()).isEqualTo("wall");
        assertThat(wall.mover().center()).isEqualTo(new Point(-5, 0, 0));
        assertThat(wall.heading()).isEqualTo(0);
        assertThat(film.frame(1).words()).isEqualTo("1 move, 1 refused: drum by wall");
        Frame.Bump border = onlyBump(film, 3);
        assertThat(border.obstacle()).isEqualTo("the border of the world");
        assertThat(border.heading()).isEqualTo(180);
        assertThat(drum(film, 3)).isEqualTo(new Point(-5, 0, 0));
    }

    @Test
    void theRecordIsShownWhereItTellsOtherwise() {
        // Through the wall, and stopped by nothing.
        StateHistory film =
                Talk.begun().drives(7, true).drives(1, true).drives(1, false).film();
        assertThat(drum(film, 1)).isEqualTo(new Point(2, 0, 0));
        assertThat(drum(film, 2)).isEqualTo(new Point(3, 0, 0));
        assertThat(drum(film, 3)).isEqualTo(new Point(3, 0, 0));
        assertThat(onlyBump(film, 3).obstacle()).isEqualTo("something");
        // And from there on as ever.
        StateHistory on =
                Talk.begun().drives(7, true).drives(3, true).drives(1, null).film();
        assertThat(drum(on, 3)).isEqualTo(new Point(6, 0, 0));
    }

    /** A fan of 91 beams from -45 to 45 degrees in the place of the drum, 0.5 ahead of its centre. */
    @Test
    void lasersOfABatchAreShown() {
        Mount ahead = new Mount(new Point(0.5, 0, 0));
        BeamPattern fan = new BeamPattern.Fan(-Math.PI / 4, Math.PI / 180, 91);
        SenseRequest laser =
                new SenseRequest("drum", ahead, fan, 0, 30, 0, false, false, false, ScanMotion.NONE, false, List.of());
        Numbers told = new Numbers(IntStream.range(0, 91).mapToDouble(k -> k).toArray());
        StateHistory film = Talk.begun()
                .step(new BatchRequestBundle(List.of(laser)), null)
                .turns(90, null)
                .step(
                        new BatchRequestBundle(List.of(laser)),
                        new Reply(new BatchAnswerBundle(List.of(new SenseAnswer(told, Numbers.NONE)))))
                .film();
        List<Scene.Ping> measured = film.frame(1).heard().get("drum");
        assertThat(measured).hasSize(91).allSatisfy(ping -> {
            assertThat(ping.start()).isEqualTo(new Point(-4.5, 0, 0));
            assertThat(ping.width()).isZero();
            assertThat(ping.range()).isEqualTo(30);
        });
        assertThat(measured.get(0).heading()).isCloseTo(-45, within(1e-9));
        assertThat(measured.get(90).heading()).isCloseTo(45, within(1e-9));
        // The wall's face is at x = 1.5, from z = -2 to 2.
        assertThat(measured.get(45).distance()).isEqualTo(6);
        assertThat(measured.get(45 + 10).distance()).isCloseTo(6 / Math.cos(Math.toRadians(10)), within(1e-9));
        List<Scene.Ping> recorded = film.frame(3).heard().get("drum");
        assertThat(recorded).extracting(Scene.Ping::distance).startsWith(0.0, 1.0, 2.0);
        assertThat(recorded.get(45).start().z()).isCloseTo(-0.5, within(1e-12));
        assertThat(recorded.get(45).heading()).isCloseTo(90, within(1e-9));
    }

    @Test
    void ofManyBeamsSomeLevelOnesAreShown() {
        BeamPattern lidar = new BeamPattern.Layers(Numbers.of(-0.3, 0.01, 0.3), 0, Math.PI / 900, 1800);
        StateHistory film = Talk.begun()
                .step(new BatchRequestBundle(List.of(new SenseRequest("drum", lidar))), null)
                .step(new BatchRequestBundle(List.of(new SenseRequest("nobody", lidar))), null)
                .film();
        List<Scene.Ping> level = film.frame(1).heard().get("drum");
        assertThat(level).hasSize(120);
        assertThat(level.get(1).heading() - level.get(0).heading()).isCloseTo(3, within(1e-9));
        assertThat(film.frame(2).heard()).isEmpty();
    }

    @Test
    void distancesAreThoseToldOrElseMeasured() {
        StateHistory film = Talk.begun().looks(1.5).looks((Double) null).film();
        Scene.Ping told = film.frame(1).heard().get("drum").get(0);
        assertThat(told.distance()).isEqualTo(1.5);
        assertThat(told.range()).isEqualTo(6);
        assertThat(told.width()).isBetween(20 - 1e-9, 20 + 1e-9);
        assertThat(told.heading()).isEqualTo(0);
        // The wall is 6.5 away.
        assertThat(film.frame(2).heard().get("drum").get(0).distance()).isInfinite();
        assertThat(film.frame(2).words()).isEqualTo("1 distance");
    }

    @Test
    void whoIsUnknownShowsNothing() {
        StateHistory film = Talk.begun()
                .looks("ghost", Double.NaN)
                .looks("wall", Double.NaN)
                .step(
                        new MoveBundle(List.of(new MoveRequest("ghost", 1, 0, 0, 0, 0))),
                        new Reply(new MoveBundle(List.of())))
                .film();
        assertThat(film.frame(1).heard()).isEmpty();
        assertThat(film.frame(2).heard()).isEmpty();
        assertThat(film.frame(3).bumps()).isEmpty();
    }

    @Test
    void whatASessionLeavesOutIsNotShown() {
        Talk talk = Talk.begun().world(Talk.WALL, Talk.WALL, Talk.DRUM, Talk.DRUM.movedTo(new Point(30, 0, 0)));
        assertThat(talk.film().frame(1).words()).isEqualTo("a new world of 2 objects");
        // Too far out for any world.
        InitBundle huge = new InitBundle(List.of(new BoxObject(new Point(0x1p100, 0, 0), 0x1p100, 1, 1)));
        assertThat(talk.step(huge, null).film().frame(2).words()).isEqualTo("a new world of 0 objects");
    }
}
