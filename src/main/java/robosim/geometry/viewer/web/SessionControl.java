package robosim.geometry.viewer.web;

import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.net.SessionListener;
import robosim.geometry.world.shared.JsonText;

/**
 * Holds, slows and changes the session that is shown, on the session's own thread and between two of its requests. What it
 * changes are requests like those of the environment, so recordings and watchers have them too; the environment is not told. A
 * held session goes on when there has been no page for 10 seconds, or when this is closed.
 */
public final class SessionControl implements Control, Function<String, SessionListener>, AutoCloseable {
    /** How long a command waits for the environment to send a request; held sessions carry it out at once. */
    private static final long PATIENCE_MILLIS = 3000;

    static final long ALONE_SECONDS = 10;

    /** The slowest pace, moving requests a second. */
    private static final double SLOWEST = 0.01;

    private final LiveFilm film;
    private final Map<String, HeldSession> sessions = new ConcurrentHashMap<>();
    private volatile String shown = "";
    private volatile boolean closed;

    // Guarded by this object's lock.

    private boolean paused;
    private long steps;
    private double pace;

    /** Of the sessions of a server; the film tells whether there is a page. */
    public SessionControl(LiveFilm film) {
        this.film = Checks.present("film", film);
    }

    /** Which connection is shown, and so controlled. */
    public void show(String connection) {
        shown = Checks.present("connection", connection);
        synchronized (this) {
            notifyAll();
        }
    }

    @Override
    public SessionListener apply(String connection) {
        HeldSession held = new HeldSession(this, Checks.present("connection", connection));
        sessions.put(connection, held);
        return held;
    }

    void ended(String connection, HeldSession held) {
        sessions.remove(connection, held);
    }

    @Override
    public List<String> commands() {
        return List.of("pause", "run", "step", "pace", "reset", "drag", "turn");
    }

    @Override
    public synchronized Map<String, @Nullable Object> state() {
        return JsonText.fields("paused", paused, "pace", pace);
    }

    @Override
    public String carryOut(Map<?, ?> command) throws InterruptedException {
        String name = Control.text(command, "do");
        switch (name) {
            case "pause" -> hold(true, 0);
            case "run" -> hold(false, 0);
            case "step" -> hold(true, 1);
            case "pace" -> setPace(Control.number(command, "value"));
            case "reset", "drag", "turn" -> {
                return onSession(command);
            }
            default -> throw new IllegalArgumentException("do must be one of " + commands() + " (got: " + name + ")");
        }
        return "";
    }

    private synchronized void hold(boolean isPaused, long more) {
        paused = isPaused;
        steps = isPaused ? steps + more : 0;
        notifyAll();
    }

    private synchronized void setPace(double value) {
        if (value != 0 && !(value >= SLOWEST)) {
            throw new IllegalArgumentException(
                    "value must be 0 for any pace, or at least " + SLOWEST + " a second (got: " + value + ")");
        }
        pace = value;
        notifyAll();
    }

    private String onSession(Map<?, ?> command) throws InterruptedException {
        HeldSession held = sessions.get(shown);
        if (held == null) {
            return "there is no session";
        }
        CompletableFuture<String> answer = held.add(command);
        synchronized (this) {
            notifyAll();
        }
        try {
            return answer.get(PATIENCE_MILLIS, TimeUnit.MILLISECONDS);
        } catch (TimeoutException e) {
            answer.cancel(false);
            return "the environment has sent no request for " + PATIENCE_MILLIS / 1000
                    + " s, and changes are made between two requests";
        } catch (ExecutionException e) {
            return String.valueOf(
                    e.getCause() == null ? e.getMessage() : e.getCause().getMessage());
        }
    }

    /** Waits on a session's thread until its next moving request may be carried out, and carries out commands meanwhile. */
    void await(HeldSession held) {
        held.carryOut();
        while (true) {
            synchronized (this) {
                long left = left(held);
                if (left <= 0) {
                    steps -= paused && steps > 0 && held.isCalled(shown) ? 1 : 0;
                    return;
                }
                if (!held.hasCommands()) {
                    try {
                        TimeUnit.NANOSECONDS.timedWait(this, Math.min(left, 500_000_000));
                    } catch (InterruptedException e) {
                        Thread.currentThread().interrupt();
                        return;
                    }
                }
            }
            held.carryOut();
        }
    }

    /** How long a session is still to wait, nanoseconds. */
    private long left(HeldSession held) {
        if (closed || !held.isCalled(shown) || !film.isWatched(ALONE_SECONDS)) {
            return 0;
        }
        if (paused) {
            return steps > 0 ? 0 : Long.MAX_VALUE;
        }
        return pace == 0 ? 0 : Math.max(held.movedAt() + (long) (1e9 / pace) - System.nanoTime(), 0);
    }

    /** Lets all sessions go on, for good. */
    @Override
    public synchronized void close() {
        closed = true;
        notifyAll();
    }
}
