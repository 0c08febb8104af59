package robosim.geometry.viewer.window;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.concurrent.CountDownLatch;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.scenario.source.WatchReader;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.Colours;
import robosim.geometry.viewer.playback.Feed;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.world.World;

/**
 * Opens a window with a view from above: of a world whose robots can be dragged, of a recording, or of a live session.
 * Only this class needs a display.
 */
public final class Viewer {
    private static final int TICK_MILLIS = 33;

    private Viewer() {}

    public static boolean hasDisplay() {
        try {
            return !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError | NoClassDefFoundError noneThatAnswers) {
            return false;
        }
    }

    /** Shows a world until the window is closed. */
    public static void world(World world, String title, Theme theme) throws InterruptedException {
        Checks.present("world", world);
        Checks.present("title", title);
        Checks.present("theme", theme);
        show(ViewerModel.ofWorld(world, title), theme);
    }

    /**
     * Shows a recording until the window is closed, and closes it.
     *
     * @param world lends its colours and its unit; null for none
     */
    public static void recording(StepReader recording, String title, @Nullable World world, Theme theme)
            throws InterruptedException {
        Checks.present("recording", recording);
        Checks.present("title", title);
        Checks.present("theme", theme);
        try (Feed feed = new Feed(recording, colours(world), () -> "")) {
            show(ViewerModel.ofRecording(feed, title, unit(world)), theme);
        }
    }

    /**
     * Shows a live session until the window is closed, then closes the reader. Nothing is sent to the session.
     *
     * @param world lends its colours and its unit; null for none
     */
    public static void live(WatchReader session, String title, @Nullable World world, Theme theme)
            throws InterruptedException {
        Checks.present("session", session);
        Checks.present("title", title);
        Checks.present("theme", theme);
        try (Feed feed = new Feed(session, colours(world), session::state)) {
            show(ViewerModel.ofLive(feed, title, unit(world)), theme);
        }
    }

    private static Colours colours(@Nullable World world) {
        return world == null ? Colours.NONE : Colours.of(world);
    }

    private static String unit(@Nullable World world) {
        return world == null ? "" : Pictures.unit(world);
    }

    private static void show(ViewerModel viewing, Theme theme) throws InterruptedException {
        CountDownLatch closed = new CountDownLatch(1);
        SwingUtilities.invokeLater(() -> open(viewing, theme, closed));
        closed.await();
    }

    private static void open(ViewerModel viewing, Theme theme, CountDownLatch closed) {
        ViewerPane pane = new ViewerPane(viewing, theme);
        JFrame window = new JFrame(viewing.title() + " - RoboSim viewer");
        window.setName("viewer");
        window.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
        window.setContentPane(pane);
        window.pack();
        window.setLocationByPlatform(true);
        long[] last = {System.nanoTime()};
        Timer timer = new Timer(TICK_MILLIS, event -> {
            long now = System.nanoTime();
            pane.tick(now - last[0]);
            last[0] = now;
        });
        window.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                timer.stop();
                closed.countDown();
            }
        });
        timer.start();
        window.setVisible(true);
    }
}
