package robosim.geometry.report.speed;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Semaphore;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.viewer.space.BackgroundRenderer;
import robosim.geometry.viewer.space.Moment;
import robosim.geometry.viewer.space.Picture;
import robosim.geometry.viewer.space.Shot;
import robosim.geometry.viewer.space.SpaceCamera;

/**
 * The window in three dimensions while a mouse drags the camera around, without a display: a picture is ordered as the window
 * orders it, awaited, and drawn in its size into an image; then the next one is ordered, which ends the refinement of this
 * one.
 */
final class SensorWindow {
    static final String QUERY = "window 1024 x 768 while dragging";
    static final String FRAMES = "frames a second";
    static final String SLOWEST = "slowest of 99 % ms";
    static final String SIDE = "pixels of a square's side";

    private static final int WIDTH = 1024;
    private static final int HEIGHT = 768;

    /** As on the machines for which the window is meant. */
    private static final int THREADS = 2;

    private SensorWindow() {}

    static void run(SensorScene scene, Form form, Study.Sink sink) {
        Moment moment = moment(scene);
        SpaceCamera camera = SpaceCamera.usual();
        camera.resize(WIDTH, HEIGHT);
        camera.look(moment.bounds());
        BufferedImage screen = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Semaphore shown = new Semaphore(0);
        ExecutorService worker = Executors.newSingleThreadExecutor();
        try {
            BackgroundRenderer studio = new BackgroundRenderer(worker, shown::release, THREADS);
            int warm = (int) form.warmMillis() / 2;
            int count = 10 * form.rounds();
            Ecdf nanos = new Ecdf();
            Ecdf sides = new Ecdf();
            double sum = 0;
            for (int k = -warm; k < count; k++) {
                long begin = System.nanoTime();
                camera.orbit(3, k % 2);
                Shot shot = new Shot(camera.view(), null);
                studio.order(moment, List.of(shot), BackgroundRenderer.LIGHT);
                Picture picture = studio.picture(0);
                while (picture == null || !picture.view().equals(shot.view())) {
                    shown.acquireUninterruptibly();
                    picture = studio.picture(0);
                }
                draw(picture, screen);
                long end = System.nanoTime();
                if (k >= 0) {
                    nanos.add(end - begin);
                    sides.add(picture.step().side());
                    sum += end - begin;
                }
            }
            Subject module = Subject.module(Accuracy.EXACT, Dimension.SPATIAL);
            sink.put(module, scene.name, QUERY, FRAMES, count / (sum * 1e-9));
            sink.put(module, scene.name, QUERY, SLOWEST, nanos.quantile(0.99) * 1e-6);
            sink.put(module, scene.name, QUERY, SIDE, sides.quantile(0.5));
        } finally {
            worker.shutdownNow();
        }
    }

    private static void draw(Picture picture, BufferedImage screen) {
        BufferedImage image = new BufferedImage(picture.columns(), picture.rows(), BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, picture.columns(), picture.rows(), picture.pixels(), 0, picture.columns());
        Graphics2D g = screen.createGraphics();
        int side = picture.step().side();
        g.drawImage(
                image,
                (int) picture.left(),
                (int) picture.top(),
                picture.columns() * side,
                picture.rows() * side,
                null);
        g.dispose();
    }

    private static Moment moment(SensorScene scene) {
        List<Scene.Thing> statics = new ArrayList<>();
        List<Scene.Thing> movers = new ArrayList<>();
        for (GeometryObject object : scene.objects) {
            (object.isMoveable() ? movers : statics).add(new Scene.Thing(object, null));
        }
        Scene.View border = Scene.View.world(40, 40);
        return new Moment(0, Dimension.SPATIAL, border, statics, Scene.of("", border, movers));
    }
}
