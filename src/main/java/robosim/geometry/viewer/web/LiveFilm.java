package robosim.geometry.viewer.web;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.export.PageEvents;
import robosim.geometry.export.PageWriter;
import robosim.geometry.viewer.playback.Frame;
import robosim.geometry.viewer.playback.StateHistory;

/**
 * The recent past of what is watched, for any number of pages: each is given the world with its past, and then what
 * happens, at its own pace. Bounded: a page that falls behind what is kept begins anew with the present world. Never waits for a page.
 */
public final class LiveFilm {
    /** The past that a page begins with, as {@link StateHistory} weighs it. */
    private static final int MOST_WEIGHT = 100_000;

    private static final int MOST_EVENTS = 10_000;

    /** The most characters of all events that are kept; a single one may have more. */
    private static final long MOST_CHARS = 8_000_000;

    private final String title;
    private final String unit;

    // All that follows is guarded by this object's lock.

    private final StateHistory film = new StateHistory(MOST_WEIGHT);
    private final Deque<Event> events = new ArrayDeque<>();
    private long chars;
    private long head;
    private int world = -1;
    private @Nullable PageEvents lines;
    private Supplier<String> problem = () -> "";
    private int viewers;
    private long lonelySince = System.nanoTime();

    /**
     * One frame as a page reads it.
     *
     * @param number counts the changes of this film
     */
    record Event(long number, String text) {}

    /** What a page begins with, and the number of the last change that it includes. */
    static final class Start {
        final long number;
        final byte[] data;

        private Start(long number, byte[] data) {
            this.number = number;
            this.data = data;
        }
    }

    /**
     * What came after an event.
     *
     * @param number of the last change; from it the next question goes on
     * @param isAnew whether the page must begin anew
     */
    record News(long number, boolean isAnew, List<Event> events, String state) {}

    /**
     * Without a world at first.
     *
     * @param unit symbol of the world unit; may be empty
     */
    public LiveFilm(String title, String unit) {
        this.title = Checks.present("title", title);
        this.unit = Checks.present("unit", unit);
    }

    String title() {
        return title;
    }

    /** Appends what happened. */
    public synchronized void add(Frame frame) {
        film.add(frame);
        int number = film.size() - 1;
        int now = film.world(number);
        if (now < 0) {
            return;
        }
        head++;
        if (now != world || lines == null) {
            world = now;
            lines = new PageEvents(film, number);
            events.clear();
            chars = 0;
        } else {
            Event event = new Event(head, lines.line(number, film.frame(number)));
            events.add(event);
            chars += event.text().length();
            while (events.size() > 1 && (events.size() > MOST_EVENTS || chars > MOST_CHARS)) {
                chars -= events.remove().text().length();
            }
        }
        notifyAll();
    }

    /** Whom to ask what is wrong with the source, as text for people; empty if nothing is. */
    synchronized void tells(Supplier<String> whatIsWrong) {
        problem = whatIsWrong;
        notifyAll();
    }

    /** What a page begins with; null before there is a world. */
    synchronized @Nullable Start start() {
        if (world < 0) {
            return null;
        }
        PageWriter writer = new PageWriter(film)
                .ofSteps(Math.max(world, film.first()), film.size())
                .titled(title)
                .described("", unit);
        return new Start(head, writer.data());
    }

    /** Waits for what comes after a change; returns without events if nothing comes in that time. */
    synchronized News after(long number, String told, long millis) throws InterruptedException {
        long end = System.nanoTime() + millis * 1_000_000;
        for (long left = millis; number == head && told.equals(problem.get()) && left > 0; ) {
            wait(left);
            left = (end - System.nanoTime()) / 1_000_000;
        }
        long oldest = events.isEmpty() ? head + 1 : events.element().number();
        boolean isAnew = head > 0 && (number > head || number + 1 < oldest);
        List<Event> news = new ArrayList<>();
        for (Event event : isAnew ? List.<Event>of() : events) {
            if (event.number() > number) {
                news.add(event);
            }
        }
        return new News(head, isAnew, news, problem.get());
    }

    synchronized void join() {
        viewers++;
        notifyAll();
    }

    synchronized void leave() {
        viewers--;
        lonelySince = System.nanoTime();
    }

    synchronized int viewers() {
        return viewers;
    }

    /** Whether there has been a page in that time. */
    synchronized boolean isWatched(long seconds) {
        return viewers > 0 || System.nanoTime() - lonelySince < seconds * 1_000_000_000;
    }

    /** Waits until there is a page. */
    synchronized void awaitViewer() throws InterruptedException {
        while (viewers == 0) {
            wait();
        }
    }
}
