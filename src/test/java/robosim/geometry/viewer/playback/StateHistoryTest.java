package robosim.geometry.viewer.playback;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.viewer.Talk;
import robosim.geometry.viewer.scene.Scene;

class StateHistoryTest {
    private static final StateHistory.Look WHOLE = StateHistory.Look.WHOLE;

    @Test
    void everyFrameIsWhatPlayingUpToItShows() {
        // A film of all, looked at anywhere, against a film that ends there.
        SplittableRandom random = new SplittableRandom(6);
        Talk talk = Talk.begun();
        for (int k = 0; k < 60; k++) {
            switch (random.nextInt(k % 20 == 19 ? 5 : 4)) {
                case 0 -> talk.turns(random.nextInt(-180, 181), null);
                case 1 -> talk.looks((Double) null);
                case 4 ->
                    talk.world(Talk.WALL, new CylinderObject(new Point(k / 10.0 - 8, 0, 3), 0.3, 1).moveable("drum"));
                default -> talk.drives(random.nextDouble(3), null);
            }
        }
        StateHistory all = talk.film();
        StateHistory.Look look = new StateHistory.Look(9, 5);
        StateHistory sofar = new StateHistory();
        Replayer stage = new Replayer(SessionOptions.ROBOSIM);
        int refused = 0;
        for (int k = 0; k < all.size(); k++) {
            sofar.append(stage.play(talk.steps().get(k)));
            assertThat(all.at(k, look).described("", ""))
                    .as("frame %d", k)
                    .isEqualTo(sofar.at(k, look).described("", ""));
            refused += all.frame(k).bumps().size();
        }
        assertThat(refused).isBetween(5, 30);
    }

    @Test
    void trailsAreAsLongAsAskedFor() {
        Talk talk = Talk.begun();
        for (int k = 0; k < 20; k++) {
            talk.drives(0.25, true);
        }
        StateHistory film = talk.film();
        assertThat(path(film, 20, WHOLE)).hasSize(21).startsWith(new Point(-5, 0, 0));
        // Three moves have four places.
        assertThat(path(film, 20, new StateHistory.Look(3, 3)))
                .containsExactly(
                        new Point(-0.75, 0, 0), new Point(-0.5, 0, 0), new Point(-0.25, 0, 0), new Point(0, 0, 0));
        assertThat(path(film, 20, new StateHistory.Look(0, 0))).containsExactly(new Point(0, 0, 0));
        assertThat(path(film, 0, WHOLE)).containsExactly(new Point(-5, 0, 0));
    }

    private static List<Point> path(StateHistory film, int number, StateHistory.Look look) {
        return film.at(number, look).trails().get(0).path();
    }

    @Test
    void aNewWorldForgetsTheOneBefore() {
        StateHistory film = Talk.begun()
                .drives(9, false)
                .looks(2.0)
                .world(Talk.DRUM)
                .drives(1, true)
                .film();
        Scene before = film.at(2, WHOLE);
        assertThat(before.refusals()).hasSize(1);
        assertThat(before.pings()).hasSize(1);
        assertThat(before.things()).hasSize(2);
        Scene after = film.at(4, WHOLE);
        assertThat(after.refusals()).isEmpty();
        assertThat(after.blocked()).isEmpty();
        assertThat(after.pings()).isEmpty();
        assertThat(after.things()).hasSize(1);
        assertThat(path(film, 4, WHOLE)).containsExactly(new Point(-5, 0, 0), new Point(-4, 0, 0));
    }

    @Test
    void whatRefusedFadesWithAge() {
        Talk talk = Talk.begun().drives(9, false);
        for (int k = 0; k < 10; k++) {
            talk.turns(1, true);
        }
        StateHistory film = talk.film();
        List<Double> strengths = new ArrayList<>();
        for (int k = 0; k < film.size(); k++) {
            List<Scene.Blocked> blocked = film.at(k, WHOLE).blocked();
            strengths.add(blocked.isEmpty() ? 0 : blocked.get(0).strength());
        }
        assertThat(strengths).startsWith(0.0, 1.0, 0.875).element(8).isEqualTo(0.125);
        assertThat(strengths.get(9)).isZero();
        assertThat(film.at(1, WHOLE).blocked().get(0).obstacle()).isEqualTo(Talk.WALL);
        assertThat(film.at(5, WHOLE).subtitle()).contains("before, 1 move, 1 refused: drum by wall");
        assertThat(film.at(9, WHOLE).subtitle()).doesNotContain("refused");
    }

    @Test
    void beforeTheFirstWorldThereIsNothing() {
        StateHistory film = new Talk().drives(1, false).looks(Double.NaN).film();
        assertThat(film.at(1, WHOLE).things()).isEmpty();
        assertThat(film.setting(1)).isNull();
        assertThat(film.movers(1)).isEmpty();
        assertThat(new StateHistory().at(-1, WHOLE).things()).isEmpty();
    }

    @Test
    void aLongWayIsThinnedInItsOlderPart() {
        Talk talk = Talk.begun();
        for (int k = 0; k < 300; k++) {
            talk.drives(k % 2 == 0 ? 1 : -1, true).turns(1, true);
        }
        StateHistory film = talk.film();
        StateHistory.Look look = new StateHistory.Look(Integer.MAX_VALUE, Integer.MAX_VALUE, 100);
        for (int number : new int[] {0, 50, 98, 99, 100, 101, 333, 600}) {
            List<Point> whole = path(film, number, WHOLE);
            List<Point> thinned = path(film, number, look);
            assertThat(thinned).hasSizeBetween(Math.min(whole.size(), 74), 100);
            assertThat(thinned.get(0)).isEqualTo(whole.get(0));
            int newer = Math.min(whole.size(), 50);
            assertThat(thinned)
                    .endsWith(whole.subList(whole.size() - newer, whole.size()).toArray(Point[]::new));
            int at = 0;
            for (Point place : whole) {
                at += at < thinned.size() && thinned.get(at).equals(place) ? 1 : 0;
            }
            assertThat(at).as("places of the way, in its order").isEqualTo(thinned.size());
        }
    }

    @Test
    void worldsThatComeAgainAndAgainAreLetGo() {
        GeometryObject mesh = new MeshObject(
                List.of(new Point(0, 0, 0), new Point(1, 0, 0), new Point(0, 0, 1), new Point(1, 0, 1)),
                new int[][] {{0, 1, 2}, {1, 3, 2}});
        Talk talk = new Talk();
        for (int k = 0; k < 100; k++) {
            talk.world(new ObjectGroup(List.of(mesh)), Talk.DRUM);
        }
        StateHistory film = new StateHistory(200);
        Replayer stage = new Replayer(SessionOptions.ROBOSIM);
        talk.steps().forEach(step -> film.append(stage.play(step)));
        // Each: the frame, a group, its mesh with 4 vertices and 2 triangles, and the drum.
        assertThat(film.frame(99).weight()).isEqualTo(10);
        assertThat(film.size() - film.first()).isBetween(10, 20);
        assertThat(film.world(99)).isEqualTo(99);
        assertThat(film.world(film.first())).isEqualTo(film.first());
        assertThat(film.setting(film.first() - 1)).isNull();
    }

    /** Robots that measure, one after the other and in a batch, and then move, make one step. */
    @Test
    void whatIsMeasuredAndThenDoneIsOneStep() {
        GeometryObject cart = new CylinderObject(new Point(-5, 0, 3), 0.5, 1).moveable("cart");
        Talk talk = new Talk().world(Talk.WALL, Talk.DRUM, cart);
        for (int k = 0; k < 3; k++) {
            talk.looks(null).looks("cart", null).drives(k == 1 ? 30 : 0.5, null);
        }
        talk.looks(null).looks(null).drives(0.5, null).drives(0.5, null);
        StateHistory film = new StateHistory();
        Replayer stage = new Replayer(SessionOptions.ROBOSIM);
        talk.steps().forEach(step -> film.add(stage.play(step)));
        // The world, three steps, a look, another look with a move, and a move.
        assertThat(film.size()).isEqualTo(7);
        for (int k = 1; k <= 3; k++) {
            assertThat(film.frame(k).heard()).containsOnlyKeys("drum", "cart");
            assertThat(film.frame(k).words()).startsWith("1 distance; 1 distance; 1 move");
        }
        assertThat(film.frame(2).bumps()).hasSize(1);
        assertThat(film.frame(4).placed()).isEmpty();
        assertThat(film.frame(5).placed()).containsOnlyKeys("drum");
        assertThat(film.frame(6).heard()).isEmpty();
        // At the end of a step is what message by message there is too.
        StateHistory each = talk.film();
        assertThat(film.movers(1)).isEqualTo(each.movers(3));
        assertThat(film.movers(6)).isEqualTo(each.movers(each.size() - 1));
        assertThat(film.scene(3).pings()).isEqualTo(each.scene(9).pings());
    }
}
