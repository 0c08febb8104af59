package robosim.geometry.viewer;

import java.awt.Color;
import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.function.BooleanSupplier;
import javax.imageio.ImageIO;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.scenario.source.WireReader;
import robosim.geometry.viewer.draw.Palette;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.viewer.window.Camera;
import robosim.geometry.viewer.window.MapPanel;
import robosim.geometry.viewer.window.Viewer;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/**
 * A process of its own that opens the real window on a virtual display and uses it as a person does: by its mouse and by
 * what is to be seen on the screen. It prints what it saw; whatever is otherwise ends it with another code than 0.
 */
final class WindowDriver {
    private static final long PATIENCE_NANOS = 30_000_000_000L;

    private final Robot robot;
    private final Path picture;
    private final boolean onX;
    private JFrame window;

    private WindowDriver(boolean onX, Path picture) throws Exception {
        this.onX = onX;
        this.picture = picture;
        this.robot = new Robot();
        robot.setAutoDelay(20);
    }

    /**
     * Runs.
     *
     * @param arguments a class to be loaded first, or nothing; where a picture of the screen goes; an environment's two
     *                  recorded files
     */
    public static void main(String[] arguments) {
        try {
            drive(arguments);
            System.out.println("all as it should be");
            System.exit(0);
        } catch (Exception | LinkageError e) {
            e.printStackTrace(System.out);
            System.exit(1);
        }
    }

    private static void drive(String[] arguments) throws Exception {
        if (!arguments[0].isEmpty()) {
            Class.forName(arguments[0]); // which puts a display of its own in the place of the system's
        }
        WindowDriver driver = new WindowDriver(arguments[0].isEmpty(), Path.of(arguments[1]));
        driver.world();
        driver.recording(WireReader.open(Path.of(arguments[2]), Path.of(arguments[3])));
    }

    private void world() throws Exception {
        World world = new World(
                20, 5, 10, List.of(new WorldObject(Talk.WALL, "#ff0000", List.of()), new WorldObject(Talk.DRUM)));
        Thread shown = inThread(() -> Viewer.world(world, "driven", Theme.LIGHT));
        open();
        expect("the wall is red", () -> at(2, 1.3).equals(Color.RED));
        expect("the drum is there", () -> !isFloor(-5.2, 0.13));
        hold(-5, 0);
        move(-2, 1.5);
        expect("the drum was dragged", () -> isFloor(-5.2, 0.13) && !isFloor(-2.2, 1.63));
        move(1.6, 0.2);
        expect("the wall is marked as what is in the way", () -> !at(2, 1.3).equals(Color.RED));
        expect("and it is told", () -> status().equals("drum may not be there: wall is in the way"));
        picture();
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        expect("the drum stayed where it could", () -> at(2, 1.3).equals(Color.RED) && !isFloor(-2.2, 1.63));
        int wide = red();
        wheel(2, 0, -3);
        expect("the wheel makes it larger", () -> red() > 1.5 * wide);
        space();
        close(shown);
    }

    private void space() throws Exception {
        click("view");
        expect("the plan has room for another part", () -> find(window.getContentPane(), "space") != null);
        click("view");
        expect("in three dimensions the wall is red too", () -> reddish() > 200);
    }

    private void recording(StepReader reader) throws Exception {
        Thread shown = inThread(() -> Viewer.recording(reader, "driven", null, Theme.DARK));
        open();
        expect("it plays to its end", () -> status().startsWith("step 41 of 41"));
        click("first");
        expect("and back", () -> status().startsWith("step 1 of 41") && !isFloor(-5.2, 0.13));
        click("forward");
        expect("a step", () -> status().startsWith("step 2 of 41"));
        click("last");
        expect("the drum drove", () -> isFloor(-5.2, 0.13) && status().contains("refused: drum by wall"));
        close(shown);
    }

    /** Something that waits for a window. */
    private interface Showing {
        void show() throws Exception;
    }

    private static Thread inThread(Showing showing) {
        Thread thread = new Thread(() -> {
            try {
                showing.show();
            } catch (Exception e) {
                throw new IllegalStateException(e);
            }
        });
        thread.start();
        return thread;
    }

    private void open() throws Exception {
        expect("the window opens", () -> {
            for (Window each : Window.getWindows()) {
                if (each instanceof JFrame frame && frame.isShowing()) {
                    window = frame;
                    return true;
                }
            }
            return false;
        });
        robot.waitForIdle();
    }

    private void close(Thread shown) throws Exception {
        SwingUtilities.invokeAndWait(() -> window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING)));
        shown.join(PATIENCE_NANOS / 1_000_000);
        expect("who showed it goes on when it is closed", () -> !shown.isAlive());
    }

    /** A picture of the screen as it is. */
    private void picture() throws Exception {
        var screen = robot.createScreenCapture(
                new Rectangle(Toolkit.getDefaultToolkit().getScreenSize()));
        ImageIO.write(screen, "png", picture.toFile());
    }

    private void expect(String what, BooleanSupplier isSo) throws Exception {
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (!isSo.getAsBoolean()) {
            if (System.nanoTime() > end) {
                System.out.println("not so: " + what + "; the window says: " + status());
                picture();
                System.exit(1);
            }
            Thread.sleep(50);
        }
        System.out.println(what);
    }

    private MapPanel map() {
        return (MapPanel) find(window.getContentPane(), "map");
    }

    private String status() {
        return ((JLabel) find(window.getContentPane(), "status")).getText();
    }

    private static Component find(Component in, String name) {
        if (name.equals(in.getName())) {
            return in;
        }
        if (in instanceof java.awt.Container container) {
            for (Component child : container.getComponents()) {
                Component found = find(child, name);
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    /** A place of the world on the screen, where all of the small world is shown. */
    private Point onScreen(double worldX, double worldZ) {
        Camera camera = new Camera();
        camera.resize(map().getWidth(), map().getHeight());
        camera.look(Scene.View.of(20, 10, List.of(new Scene.Thing(Talk.WALL, null), new Scene.Thing(Talk.DRUM, null))));
        Point corner = map().getLocationOnScreen();
        return new Point(
                corner.x + (int) camera.frame().x(worldX),
                corner.y + (int) camera.frame().y(worldZ));
    }

    private Color at(double worldX, double worldZ) {
        Point point = onScreen(worldX, worldZ);
        // Not getPixelColor, which is always black on cacio.
        return new Color(
                robot.createScreenCapture(new Rectangle(point.x, point.y, 1, 1)).getRGB(0, 0));
    }

    private boolean isFloor(double worldX, double worldZ) {
        int rgb = at(worldX, worldZ).getRGB() & 0xffffff;
        return rgb == Palette.FLOOR.light() || rgb == Palette.FLOOR.dark();
    }

    /** How many pixels are that red. */
    private int red() {
        var screen = robot.createScreenCapture(new Rectangle(window.getLocationOnScreen(), window.getSize()));
        int count = 0;
        for (int y = 0; y < screen.getHeight(); y++) {
            for (int x = 0; x < screen.getWidth(); x++) {
                count += (screen.getRGB(x, y) & 0xffffff) == 0xff0000 ? 1 : 0;
            }
        }
        return count;
    }

    /** How many pixels are rather red, as in light and shadow. */
    private int reddish() {
        var screen = robot.createScreenCapture(new Rectangle(window.getLocationOnScreen(), window.getSize()));
        int count = 0;
        for (int y = 0; y < screen.getHeight(); y++) {
            for (int x = 0; x < screen.getWidth(); x++) {
                int rgb = screen.getRGB(x, y);
                count += (rgb >> 16 & 0xff) > 100 + (rgb & 0xff) ? 1 : 0;
            }
        }
        return count;
    }

    private void pointAt(double worldX, double worldZ) {
        Point point = onScreen(worldX, worldZ);
        robot.mouseMove(point.x, point.y);
        robot.waitForIdle();
    }

    /** Cacio's robot has no wheel: there the window is given what a wheel would give it. */
    private void wheel(double worldX, double worldZ, int notches) throws Exception {
        pointAt(worldX, worldZ);
        if (onX) {
            robot.mouseWheel(notches);
            return;
        }
        Point point = onScreen(worldX, worldZ);
        SwingUtilities.convertPointFromScreen(point, map());
        MouseWheelEvent event = new MouseWheelEvent(
                map(),
                MouseEvent.MOUSE_WHEEL,
                0,
                0,
                point.x,
                point.y,
                0,
                false,
                MouseWheelEvent.WHEEL_UNIT_SCROLL,
                1,
                notches);
        SwingUtilities.invokeAndWait(() -> map().dispatchEvent(event));
    }

    private void hold(double worldX, double worldZ) {
        pointAt(worldX, worldZ);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    }

    /** As a hand does: not at once. */
    private void move(double worldX, double worldZ) {
        Point to = onScreen(worldX, worldZ);
        robot.mouseMove(to.x - 9, to.y - 9);
        robot.mouseMove(to.x, to.y);
        robot.waitForIdle();
    }

    private void click(String button) {
        Component found = find(window.getContentPane(), button);
        Point corner = found.getLocationOnScreen();
        robot.mouseMove(corner.x + found.getWidth() / 2, corner.y + found.getHeight() / 2);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        robot.waitForIdle();
    }
}
