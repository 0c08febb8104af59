package robosim.geometry.viewer.playback;

/**
 * The position in a history, and its playback. Time is passed in, so playback is reproducible. May be used by one
 * thread at a time.
 */
public final class Player {
    /** The speeds to choose from, steps per second. */
    static final double[] SPEEDS = {0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};

    private static final int USUAL = 5;

    private final StateHistory film;
    private int speed = USUAL;
    private int position;
    private double share;
    private boolean playing;

    /** Whether it follows a growing history while it is playing at the end. */
    private final boolean live;

    private Player(StateHistory film, boolean live) {
        this.film = film;
        this.live = live;
        this.playing = true;
    }

    /** Plays from the beginning. */
    public static Player ofRecording(StateHistory film) {
        return new Player(film, false);
    }

    /** Follows a live session until it is paused. */
    public static Player ofLive(StateHistory film) {
        return new Player(film, true);
    }

    /** The frame shown; -1 if there is none yet. */
    public int position() {
        int last = film.size() - 1;
        return last < 0 ? -1 : Math.max(film.first(), Math.min(position, last));
    }

    public boolean isPlaying() {
        return playing;
    }

    /** Whether it shows the newest frame of a live session. */
    public boolean isFollowing() {
        return live && playing;
    }

    /** Steps a second. */
    public double speed() {
        return SPEEDS[speed];
    }

    /** Advances the time. */
    public void tick(long nanos) {
        if (!playing || film.size() == 0) {
            return;
        }
        if (live) {
            position = film.size() - 1;
            return;
        }
        share += speed() * nanos / 1e9;
        double whole = Math.floor(share);
        share -= whole;
        position = (int) Math.min(film.size() - 1.0, position() + whole);
    }

    /** Whether playback is at the end of what has been read so far. */
    boolean isAtEnd() {
        return position() == film.size() - 1;
    }

    /** Pauses or resumes; at the end of a recording, restarts from its beginning. */
    public void toggle() {
        playing = !playing;
        if (playing && !live && isAtEnd()) {
            position = film.first();
        }
        share = 0;
    }

    public void pause() {
        playing = false;
        share = 0;
    }

    /** Goes a number of steps forward or back, and pauses. */
    public void step(int steps) {
        seek((int) Math.max(Integer.MIN_VALUE, Math.min(Integer.MAX_VALUE, (long) position() + steps)));
    }

    /** Goes to a frame, or the nearest that exists, and pauses. */
    public void seek(int number) {
        pause();
        position = Math.max(film.first(), Math.min(number, Math.max(0, film.size() - 1)));
    }

    /** The next speed up or down. */
    public void faster(int steps) {
        speed = Math.max(0, Math.min(SPEEDS.length - 1, speed + steps));
    }
}
