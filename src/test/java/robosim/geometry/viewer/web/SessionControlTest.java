package robosim.geometry.viewer.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.viewer.Talk;

/** A session that is held, slowed and changed from outside. */
@Tag("clock")
@Timeout(60)
class SessionControlTest {
    private static final Bundle FORWARD = new MoveBundle(List.of(Talk.move(0.5, 0)));

    private final LiveFilm film = new LiveFilm("", "");
    private final SessionControl control = new SessionControl(film);
    private final ExecutorService environment = Executors.newSingleThreadExecutor();

    /** All requests that other listeners are told. */
    private final List<Bundle> told = new CopyOnWriteArrayList<>();

    private Session session;

    @BeforeEach
    void begin() throws Exception {
        film.join();
        SessionListener others = new SessionListener() {
            @Override
            public void requested(Bundle request) {
                told.add(request);
            }
        };
        session = environment
                .submit(() ->
                        new Session(SessionOptions.ROBOSIM, control.apply("one").and(others), "one"))
                .get();
        GeometryObject cart = new CylinderObject(new Point(-5, 0, 3), 0.5, 1).moveable("cart");
        ask(Talk.begun().world(Talk.WALL, Talk.DRUM, cart).steps().get(1).request());
        control.show("one");
    }

    @AfterEach
    void end() {
        control.close();
        environment.shutdownNow();
    }

    private Future<Bundle> send(Bundle request) {
        return environment.submit(() -> session.answer(request));
    }

    private Bundle ask(Bundle request) throws Exception {
        return send(request).get();
    }

    private String command(Object... fields) throws InterruptedException {
        Map<String, Object> command = new HashMap<>();
        for (int k = 0; k < fields.length; k += 2) {
            command.put(String.valueOf(fields[k]), fields[k + 1]);
        }
        return control.carryOut(command);
    }

    private Point drum() {
        return session.world().getObject("drum").center();
    }

    private static void assertHeld(Future<Bundle> answer) {
        assertThatThrownBy(() -> answer.get(50, TimeUnit.MILLISECONDS)).isInstanceOf(TimeoutException.class);
    }

    @Test
    void aHeldSessionMovesOneByOne() throws Exception {
        assertThat(command("do", "pause")).isEmpty();
        assertThat(ask(Talk.begun().looks(null).steps().get(1).request()))
                .as("it may measure")
                .isInstanceOf(DistanceBundle.class);
        int before = told.size();
        Future<Bundle> first = send(FORWARD);
        Future<Bundle> second = send(FORWARD);
        assertHeld(first);
        assertThat(told).as("others are told when it is carried out").hasSize(before);
        assertThat(control.state()).containsEntry("paused", true);
        command("do", "step");
        assertThat(first.get()).isEqualTo(FORWARD);
        assertHeld(second);
        command("do", "run");
        assertThat(second.get()).isEqualTo(FORWARD);
        assertThat(ask(FORWARD)).isEqualTo(FORWARD);
    }

    @Test
    void aHeldRobotIsDraggedByCheckedMoves() throws Exception {
        command("do", "pause");
        Future<Bundle> held = send(FORWARD);
        assertThat(command("do", "drag", "name", "drum", "x", -2.0, "z", 1.0)).isEmpty();
        assertThat(command("do", "drag", "name", "drum", "x", 8.0, "z", 1.0)).isEqualTo("blocked by wall");
        assertThat(command("do", "drag", "name", "drum", "x", 8.0, "z", 1.0, "lift", true))
                .isEmpty();
        assertThat(command("do", "drag", "name", "drum", "x", 50.0, "z", 1.0, "lift", true))
                .isEqualTo("blocked by the border of the world");
        assertThat(command("do", "turn", "name", "drum", "degrees", 90.0)).isEmpty();
        assertThatThrownBy(() -> command("do", "fly"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("(got: fly)");
        assertThat(command("do", "drag", "name", "wall", "x", 0.0, "z", 0.0)).contains("(got: wall)");
        command("do", "run");
        held.get();
        assertThat(drum().x()).isEqualTo(8);
        assertThat(drum().z()).as("forward is another way now").isEqualTo(0.5);
        assertThat(told.stream().map(Bundle::getClass).map(Class::getSimpleName))
                .containsExactly(
                        "InitBundle",
                        "BatchRequestBundle",
                        "BatchRequestBundle",
                        "BatchRequestBundle",
                        "BatchRequestBundle",
                        "BatchRequestBundle",
                        "MoveBundle");
    }

    @Test
    void allGoBackToWhereTheyBegan() throws Exception {
        ask(FORWARD);
        command("do", "pause");
        Future<Bundle> held = send(FORWARD);
        // The cart stands where the drum began, and is in its way until it has gone back too.
        assertThat(command("do", "drag", "name", "drum", "x", -2.0, "z", 2.0)).isEmpty();
        assertThat(command("do", "drag", "name", "cart", "x", -5.0, "z", 0.0)).isEmpty();
        assertThat(command("do", "reset")).isEmpty();
        command("do", "run");
        held.get();
        assertThat(drum()).isEqualTo(new Point(-4.5, 0, 0));
        assertThat(session.world().getObject("cart").center()).isEqualTo(new Point(-5, 0, 3));
    }

    @Test
    void whatMovesTooOftenIsSlowed() throws Exception {
        command("do", "pace", "value", 20.0);
        long start = System.nanoTime();
        for (int k = 0; k < 5; k++) {
            ask(FORWARD);
        }
        assertThat(System.nanoTime() - start).isGreaterThan(4 * 50_000_000L);
        assertThatThrownBy(() -> command("do", "pace", "value", -1.0)).hasMessageContaining("(got: -1.0)");
    }

    @Test
    void onlyTheSessionThatIsShownIsHeld() throws Exception {
        control.show("another");
        command("do", "pause");
        assertThat(ask(FORWARD)).isEqualTo(FORWARD);
        assertThat(command("do", "reset")).isEqualTo("there is no session");
    }

    @Test
    void anEnvironmentThatAsksNothingIsNotWaitedForForever() throws Exception {
        assertThat(command("do", "drag", "name", "drum", "x", -3.0, "z", 0.0)).contains("no request for 3 s");
        ask(FORWARD);
        assertThat(drum()).as("it was given up").isEqualTo(new Point(-4.5, 0, 0));
    }

    @Test
    void closingLetsItGoOn() throws Exception {
        command("do", "pause");
        Future<Bundle> held = send(FORWARD);
        assertHeld(held);
        control.close();
        assertThat(held.get()).isEqualTo(FORWARD);
    }
}
