package robosim.geometry.viewer.playback;

/**
 * Where in a film one is, and how it goes on. Time comes from outside, so that it is the same each time. It belongs to one
 * thread at a time.
 */
public final class Player {
    /** Steps a second to choose from. */
    static final double[] SPEEDS = {0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};

    private static final int USUAL = 5;

    private final StateHistory film;
    private int speed = USUAL;
    private int position;
    private double share;
    private boolean playing;

    /** Whether it goes along with a film that grows: where it is at its end and playing. */
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

    /** Shows what happens as it happens, until it is paused. */
    public static Player ofLive(StateHistory film) {
        return new Player(film, true);
    }

    /** The frame that is shown; -1 where there is none yet. */
    public int position() {
        int last = film.size() - 1;
        return last < 0 ? -1 : Math.max(film.first(), Math.min(position, last));
    }

    public boolean isPlaying() {
        return playing;
    }

    /** Whether what is shown is the newest of something that goes on. */
    public boolean isFollowing() {
        return live && playing;
    }

    /** Steps a second. */
    public double speed() {
        return SPEEDS[speed];
    }

    /** So much time went by. */
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

    /** Whether a recording is at its end; one that is still read may go on. */
    boolean isAtEnd() {
        return position() == film.size() - 1;
    }

    /** Pauses or goes on; at the end of a recording, from its beginning. */
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

    /** Goes so many steps forward or back, and pauses. */
    public void step(int steps) {
        seek((int) Math.max(Integer.MIN_VALUE, Math.min(Integer.MAX_VALUE, (long) position() + steps)));
    }

    /** Goes to a frame, or the nearest that there is, and pauses. */
    public void seek(int number) {
        pause();
        position = Math.max(film.first(), Math.min(number, Math.max(0, film.size() - 1)));
    }

    /** The next speed up or down. */
    public void faster(int steps) {
        speed = Math.max(0, Math.min(SPEEDS.length - 1, speed + steps));
    }
}
