package robosim.geometry.net.pace;

import java.time.Duration;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;

/** Breaks off what takes too long and has no time-out of its own: writing to a socket, a handshake, a TLS end. */
public final class Watchdog implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger("robosim.geometry.net");
    private static final long MOST_TICK_MILLIS = 1000;

    private final String name;
    private final Set<Guard> guards = ConcurrentHashMap.newKeySet();
    private final Thread thread;
    private final long tickMillis;

    /**
     * Watches from now on, on a thread of its own.
     *
     * @param name   the thread's
     * @param finest the shortest time that will be watched; the watchdog is late by at most a quarter of it
     */
    public Watchdog(String name, Duration finest) {
        this.name = name;
        tickMillis = Math.max(1, Math.min(MOST_TICK_MILLIS, finest.toMillis() / 4));
        thread = new Thread(this::watch, name);
        thread.setDaemon(true);
        thread.start();
    }

    @SuppressWarnings("BusyWait") // it looks again and again, that is its task
    private void watch() {
        Throwable failure = null;
        while (true) {
            try {
                Thread.sleep(tickMillis);
                if (failure != null) { // told where another one is caught: there may be no memory to tell it
                    LOG.log(System.Logger.Level.ERROR, name + ": goes on after an error of the module itself", failure);
                    failure = null;
                }
                long now = System.nanoTime();
                guards.forEach(guard -> guard.check(now));
            } catch (InterruptedException e) {
                return; // closed
            } catch (RuntimeException | Error e) {
                failure = e; // the others are still watched
            }
        }
    }

    /** A guard over one thing at a time; {@code breakOff} must make it fail at once. */
    public Guard guard(Runnable breakOff) {
        Guard guard = new Guard(breakOff);
        guards.add(guard);
        return guard;
    }

    /** Ends the thread and waits for it. */
    @Override
    public void close() {
        thread.interrupt();
        if (thread == Thread.currentThread()) {
            return;
        }
        try {
            thread.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Of one connection. */
    public final class Guard implements AutoCloseable {
        private static final long NOTHING = 0;
        private static final long BROKEN = -1;

        private final Runnable breakOff;

        /** When it must be done, odd and positive on a clock that begins with the guard; or one of the above. */
        private final AtomicLong due = new AtomicLong(NOTHING);

        private final long origin = System.nanoTime();

        private Guard(Runnable breakOff) {
            this.breakOff = breakOff;
        }

        /** What begins now must be done by then, a {@link System#nanoTime}. */
        public void begin(long deadline) {
            long last = due.get();
            if (last != BROKEN) {
                due.compareAndSet(last, Math.max(0, deadline - origin) | 1);
            }
        }

        /** It is done. */
        public void end() {
            long last = due.get();
            if (last != BROKEN) {
                due.compareAndSet(last, NOTHING);
            }
        }

        /** Whether something was broken off. */
        public boolean isBroken() {
            return due.get() == BROKEN;
        }

        private void check(long now) {
            long then = due.get();
            if (then > NOTHING && now - origin > then && due.compareAndSet(then, BROKEN)) {
                breakOff.run();
            }
        }

        @Override
        public void close() {
            guards.remove(this);
        }
    }
}
