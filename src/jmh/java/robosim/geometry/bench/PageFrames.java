package robosim.geometry.bench;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.WorldSettings;
import robosim.geometry.scenario.Step;
import robosim.geometry.viewer.playback.Replayer;
import robosim.geometry.viewer.web.Chromium;
import robosim.geometry.viewer.web.LiveFilm;
import robosim.geometry.viewer.web.PageServer;

/**
 * A running session in headless Chromium with WebGL in software: frames a second while all robots move 20 times a
 * second, and the time from a step to the frame that shows it. Needs Chromium on the path.
 */
public final class PageFrames {
    private PageFrames() {}

    /** Arguments: the number of robots (default 1,000) and the seconds to measure (10). */
    public static void main(String[] arguments) throws Exception {
        int robots = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 1000;
        int seconds = arguments.length > 1 ? Integer.parseInt(arguments[1]) : 10;
        int side = (int) Math.ceil(Math.sqrt(robots));
        List<GeometryObject> objects = new ArrayList<>();
        for (int k = 0; k < robots; k++) {
            objects.add(new CylinderObject(new Point(k % side - side / 2.0, 0, k / side - side / 2.0), 0.3, 1)
                    .moveable("robot " + k));
        }
        LiveFilm film = new LiveFilm("robots", "m");
        Replayer stage = new Replayer(SessionOptions.ROBOSIM);
        WorldSettings settings = new WorldSettings(side + 4, 2, side + 4, Dimension.PLANAR, Accuracy.EXACT);
        film.add(stage.play(new Step(new InitBundle(objects, settings), null)));
        Path folder = Files.createTempDirectory("page");
        InetSocketAddress address = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        try (PageServer server = PageServer.live(address, film, null);
                Chromium browser = Chromium.start(folder, 1280, 720)) {
            browser.open(server.page());
            browser.until("document.documentElement.dataset.state === 'ready'");
            browser.run("window.shown = 0; window.steps = 0; (function count() { shown++;"
                    + " if (robosim.view.frame !== window.last) { steps++; window.last = robosim.view.frame; }"
                    + " requestAnimationFrame(count); })()");
            for (int k = 0; k < 20 * seconds; k++) {
                film.add(stage.play(step(robots, k)));
                Thread.sleep(50);
            }
            double shown = ((Number) browser.run("shown")).doubleValue() / seconds;
            double steps = ((Number) browser.run("steps")).doubleValue();
            double[] delays = new double[50];
            for (int k = 0; k < delays.length; k++) {
                int frame = 1 + 20 * seconds + k;
                long begin = System.nanoTime();
                film.add(stage.play(step(robots, k)));
                browser.until("robosim.data.first + robosim.view.frame >= " + frame);
                delays[k] = (System.nanoTime() - begin) * 1e-6;
            }
            Arrays.sort(delays);
            System.out.printf(
                    Locale.ROOT,
                    "%d robots: %.1f frames a second, %.0f of %d steps shown; step to frame median %.0f ms, most %.0f ms%n",
                    robots,
                    shown,
                    steps,
                    20 * seconds,
                    delays[delays.length / 2],
                    delays[delays.length - 1]);
        }
    }

    private static Step step(int robots, int k) {
        List<MoveRequest> moves = new ArrayList<>();
        for (int robot = 0; robot < robots; robot++) {
            moves.add(new MoveRequest("robot " + robot, k % 2 == 0 ? 0.1 : -0.1, 0, 0, 0, 0));
        }
        return new Step(new MoveBundle(moves), null);
    }
}
