package robosim.geometry.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.net.watch.WatchClient;
import robosim.geometry.net.watch.WatchServer;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.protocol.batch.BatchRequest;
import robosim.geometry.protocol.batch.WorldRequest;

/**
 * Lets the sessions of a server or a client be watched: each watcher gets a scenario, line by line, that begins with
 * the present world, with its bodies, and goes on with each step as it happens. A watcher stays with its session until that is over; then
 * it gets the newest of the others, or the next that begins.
 *
 * <p>A session only hands over objects that it has anyway and never waits: a watcher that falls too far behind is
 * disconnected.
 *
 * <!-- java: given InetAddress address -->
 * <pre>{@code
 * NetOptions options = NetOptions.defaults();
 * Watching watching = new Watching(options.session());
 * GeometryServer server = new GeometryServer(address, 5555, options.withListeners(watching));
 * watching.listen(5556);
 * }</pre>
 */
public final class Watching implements Function<String, SessionListener>, AutoCloseable {
    /** After the name of a connection, before its number of steps. */
    private static final String AS_IT_IS = ", as it is after ";

    private final ScenarioHeader header;
    private final long beginning = System.nanoTime();

    /** The open sessions, newest last. Everything below is guarded by this object's lock. */
    private final Set<Watched> sessions = new LinkedHashSet<>();

    private final Set<Watcher> watchers = new HashSet<>();

    /** Where watchers dial in; null if it does not listen. */
    private @Nullable WatchServer server;

    /**
     * Without watchers at first.
     *
     * @param session the options of the sessions
     */
    public Watching(SessionOptions session) {
        this.header = new ScenarioHeader("a live session", session);
    }

    @Override
    public SessionListener apply(String connection) {
        return new Watched(Checks.present("connection", connection));
    }

    /**
     * Starts to listen for watchers on the loopback address; nothing is read from them.
     *
     * @param port 1 to 65535, or 0 for any free port
     * @return the port
     * @throws java.io.UncheckedIOException if it cannot listen there
     * @throws IllegalStateException if it is listening already
     */
    public synchronized int listen(int port) {
        if (server != null) {
            throw new IllegalStateException("watching must not be listening already (got: port " + server.port() + ")");
        }
        server = new WatchServer(port, this::join);
        return server.port();
    }

    /**
     * Dials what listens, and reads the present world and then each step as it happens; sends nothing. If nothing comes for
     * 10 seconds, reading throws.
     *
     * @throws IOException if it cannot be reached, or does not send a scenario
     */
    public static ScenarioReader dial(String host, int port) throws IOException {
        return ScenarioReader.of(WatchClient.dial(host, port), host + ":" + port);
    }

    /**
     * The lines of one more watcher, without a socket, for a viewer in the same program. Reading waits for the next ones, and
     * throws where this watcher has fallen too far behind; closing the stream ends it.
     */
    public InputStream lines() {
        AtomicBoolean isOver = new AtomicBoolean();
        return new WatcherStream(join(() -> isOver.set(true)), isOver::get);
    }

    /** The connection of which a step is the beginning, as its notes tell; null for any other step. */
    public static @Nullable String connection(List<String> notes) {
        String first = Checks.list("notes", notes).isEmpty() ? "" : notes.get(0);
        int end = first.indexOf(AS_IT_IS);
        return end < 0 ? null : first.substring(0, end);
    }

    /** Hangs up on all watchers and stops to listen. */
    @Override
    public void close() {
        WatchServer open;
        synchronized (this) {
            open = server;
            server = null;
        }
        if (open != null) {
            open.close();
        }
    }

    /**
     * Adds a watcher.
     *
     * @param breakOff to be called, from any thread, when the watcher gets no more; it does not block
     */
    WatchServer.Lines join(Runnable breakOff) {
        Watcher watcher = new Watcher(Checks.present("breakOff", breakOff));
        synchronized (this) {
            watchers.add(watcher);
            attach(watcher, newest());
        }
        return watcher;
    }

    private synchronized void leave(Watcher watcher) {
        watchers.remove(watcher);
    }

    /** The newest session that has a world; null if none has. */
    private @Nullable Watched newest() {
        Watched newest = null;
        for (Watched each : sessions) {
            newest = each.objects == null ? newest : each;
        }
        return newest;
    }

    private void attach(Watcher watcher, @Nullable Watched session) {
        watcher.session = session;
        if (session != null) {
            session.bodies.present(session.now()).forEach(watcher::offer);
        }
    }

    private Timing timing(long at, long took) {
        return new Timing(Math.max(0, Math.min(Timing.MOST, at - beginning)), Math.max(0, Math.min(Timing.MOST, took)));
    }

    /** One session; its methods are called on its own thread. */
    private final class Watched implements SessionListener {
        private final String name;
        private @Nullable Session session;
        private long askedAt;
        private long steps;

        /** Whether it has a world; used on its own thread only. */
        private boolean begun;

        /** The objects with which the present world began; null before there is one. */
        private @Nullable List<GeometryObject> objects;

        private @Nullable WorldSettings settings;

        /** The objects that have moved since, at their present places. */
        private final Map<String, GeometryObject> moved = new HashMap<>();

        private final BodyHistory bodies = new BodyHistory();

        /** The world that these bodies are in; used on its own thread only. */
        private @Nullable Geometry known;

        Watched(String name) {
            this.name = name;
        }

        @Override
        public void opened(Session opened) {
            session = opened;
            synchronized (Watching.this) {
                sessions.add(this);
            }
        }

        /** If the session began with an existing world, it has that world only after {@code opened}. */
        @Override
        public void requested(Bundle request) {
            askedAt = System.nanoTime();
            Geometry world = begun || session == null ? null : session.world();
            if (world != null) {
                begun = true;
                List<GeometryObject> present = world.objects();
                synchronized (Watching.this) {
                    begin(present, world);
                    tell(null);
                }
            }
            if (begun && session != null && request instanceof StepBundle && bodies.isEmpty()) {
                known = session.world();
                synchronized (Watching.this) {
                    bodies.begin(now());
                }
            }
        }

        @Override
        public void replied(Bundle request, @Nullable Reply reply, long nanoseconds) {
            Geometry world = session == null ? null : session.world();
            if (world == null) {
                return;
            }
            begun = true;
            List<GeometryObject> present = isOtherObjects(request) ? world.objects() : null;
            synchronized (Watching.this) {
                steps++;
                if (present != null) {
                    begin(present, world);
                }
                follow(world, request, reply);
                Step step = new Step(0, List.of(), request, reply, timing(askedAt, nanoseconds));
                if (world != known) { // an init that fails leaves the one before
                    known = world;
                    bodies.clear();
                }
                bodies.follow(world, step);
                tell(step);
            }
        }

        /** Sends a step, if there is one, to the watchers of this session, and the world to those that wait for one. */
        private void tell(@Nullable Step step) {
            for (Watcher watcher : watchers) {
                if (watcher.session == null) {
                    attach(watcher, this);
                } else if (watcher.session == this && step != null) {
                    watcher.offer(step);
                }
            }
        }

        private void begin(List<GeometryObject> present, Geometry world) {
            objects = present;
            settings = new WorldSettings(
                    world.width(), world.height(), world.length(), world.dimension(), world.accuracy());
            moved.clear();
        }

        private static boolean isOtherObjects(Bundle request) {
            return request instanceof InitBundle
                    || (request instanceof BatchRequestBundle batch
                            && batch.requests().stream()
                                    .anyMatch(each -> each instanceof WorldRequest about && about.isAboutObjects()));
        }

        /** Records the places of the objects that were moved. */
        private void follow(Geometry world, Bundle request, @Nullable Reply reply) {
            if (reply != null && reply.bundle() instanceof MoveBundle made) {
                made.moves().forEach(move -> follow(world, move.objectName()));
            } else if (reply != null && reply.bundle() instanceof StepBundle.Answer stepped) {
                stepped.bodies().forEach(body -> follow(world, body.objectName()));
            } else if (request instanceof BatchRequestBundle batch) {
                for (BatchRequest each : batch.requests()) {
                    if (each instanceof WorldRequest && each.isAboutMover()) {
                        follow(world, each.objectName());
                    }
                }
            }
        }

        private void follow(Geometry world, String moving) {
            if (world.hasObject(moving)) {
                moved.put(moving, world.getObject(moving));
            }
        }

        /** The present world, as a step that creates it. */
        private Step now() {
            List<GeometryObject> present = new ArrayList<>();
            for (GeometryObject object : objects == null ? List.<GeometryObject>of() : objects) {
                String own = object.name();
                present.add(own == null ? object : moved.getOrDefault(own, object));
            }
            List<String> notes = List.of(name + AS_IT_IS + steps + (steps == 1 ? " step" : " steps"));
            return new Step(0, notes, new InitBundle(present, settings), null, timing(System.nanoTime(), 0));
        }

        @Override
        public void ended() {
            synchronized (Watching.this) {
                sessions.remove(this);
                for (Watcher watcher : watchers) {
                    if (watcher.session == this) {
                        attach(watcher, newest());
                    }
                }
            }
        }
    }

    private final class Watcher extends WatcherQueue {
        /** The session that it watches; null if there is none. */
        private @Nullable Watched session;

        Watcher(Runnable breakOff) {
            super(header, breakOff);
        }

        @Override
        public void close() {
            leave(this);
        }
    }
}
