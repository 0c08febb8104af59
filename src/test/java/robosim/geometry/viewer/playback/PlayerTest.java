package robosim.geometry.viewer.playback;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.viewer.Talk;

class PlayerTest {
    private static final long SECOND = 1_000_000_000;

    private static StateHistory film(int moves) {
        Talk talk = Talk.begun();
        for (int k = 0; k < moves; k++) {
            talk.turns(1, true);
        }
        return talk.film();
    }

    @Test
    void aRecordingPlaysAtItsSpeedAndStopsAtItsEnd() {
        Player player = Player.ofRecording(film(50));
        assertThat(player.isPlaying()).isTrue();
        assertThat(player.position()).isZero();
        assertThat(player.speed()).isEqualTo(20);
        for (int k = 0; k < 30; k++) {
            player.tick(SECOND / 30);
        }
        assertThat(player.position()).isBetween(19, 20);
        player.faster(-1);
        assertThat(player.speed()).isEqualTo(10);
        int before = player.position();
        player.tick(SECOND);
        assertThat(player.position()).isEqualTo(before + 10);
        player.tick(100 * SECOND);
        assertThat(player.position()).isEqualTo(50);
        assertThat(player.isAtEnd()).isTrue();
        // From there it begins anew.
        player.toggle();
        assertThat(player.isPlaying()).isFalse();
        player.toggle();
        assertThat(player.position()).isZero();
    }

    @Test
    void slowIsNotForgotten() {
        Player player = Player.ofRecording(film(5));
        player.faster(-100);
        assertThat(player.speed()).isEqualTo(0.5);
        for (int k = 0; k < 39; k++) {
            player.tick(SECOND / 10);
        }
        assertThat(player.position()).isEqualTo(1);
        player.tick(SECOND / 5);
        assertThat(player.position()).isEqualTo(2);
        player.faster(100);
        assertThat(player.speed()).isEqualTo(1000);
    }

    @Test
    void stepsPauseAndStayWithin() {
        Player player = Player.ofRecording(film(10));
        player.step(3);
        assertThat(player.isPlaying()).isFalse();
        assertThat(player.position()).isEqualTo(3);
        player.tick(SECOND);
        assertThat(player.position()).isEqualTo(3);
        player.step(-1);
        assertThat(player.position()).isEqualTo(2);
        player.step(Integer.MIN_VALUE);
        assertThat(player.position()).isZero();
        player.step(Integer.MAX_VALUE);
        assertThat(player.position()).isEqualTo(10);
        player.seek(7);
        assertThat(player.position()).isEqualTo(7);
    }

    @Test
    void whatIsLiveIsFollowedUntilItIsPaused() {
        StateHistory film = new StateHistory();
        Player player = Player.ofLive(film);
        player.tick(SECOND);
        assertThat(player.position()).isEqualTo(-1);
        StateHistory whole = film(20);
        for (int k = 0; k < 10; k++) {
            film.append(whole.frame(k));
        }
        player.tick(1);
        assertThat(player.position()).isEqualTo(9);
        assertThat(player.isFollowing()).isTrue();
        player.step(-2);
        for (int k = 10; k < 20; k++) {
            film.append(whole.frame(k));
        }
        player.tick(SECOND);
        assertThat(player.position()).isEqualTo(7);
        player.toggle();
        player.tick(1);
        assertThat(player.position()).isEqualTo(19);
    }

    @Test
    void whatIsLetGoCannotBeShown() {
        StateHistory film = new StateHistory(40);
        Player player = Player.ofRecording(film);
        player.pause();
        StateHistory whole = film(100);
        for (int k = 0; k <= 100; k++) {
            film.append(whole.frame(k));
        }
        assertThat(film.first()).isGreaterThan(60);
        assertThat(film.size()).isEqualTo(101);
        assertThat(player.position()).isEqualTo(film.first());
        player.step(-5);
        assertThat(player.position()).isEqualTo(film.first());
        // What is kept is as it was.
        for (int k = film.first(); k < film.size(); k++) {
            assertThat(film.movers(k)).as("frame %d", k).isEqualTo(whole.movers(k));
        }
    }
}
