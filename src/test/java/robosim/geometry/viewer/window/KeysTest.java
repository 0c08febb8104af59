package robosim.geometry.viewer.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.ActionEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.image.PngReader;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.Sandbox;
import robosim.geometry.world.SonarRing;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;
import robosim.geometry.world.WorldReader;

/** Help, layers, following and saving, by their keys. */
class KeysTest {
    private static final int WIDTH = 900;
    private static final int HEIGHT = 640;

    @TempDir
    Path folder;

    private final World world = new World(
            20,
            2,
            20,
            Unit.METRE,
            robosim.geometry.model.Dimension.PLANAR,
            robosim.geometry.model.Accuracy.EXACT,
            List.of(
                    new WorldObject(new BoxObject(new Point(4, 0, 0), 1, 1, 6).named("wall"), "#336699", List.of()),
                    new WorldObject(
                            new CylinderObject(new Point(0, 0, 0), 0.5, 1).moveable("r"),
                            null,
                            List.of(new SonarRing(4, 0, 9, 20)))));

    private final ViewerModel viewing = ViewerModel.ofWorld(world, "a yard");
    private ViewerPane pane;

    private ViewerPane pane() {
        if (pane == null) {
            pane = new ViewerPane(viewing, Theme.LIGHT, Runnable::run, folder);
            pane.setSize(WIDTH, HEIGHT);
            pane.doLayout();
            pane.getComponent(0).doLayout();
        }
        return pane;
    }

    private void press(KeyStroke stroke) {
        Object name = pane().getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).get(stroke);
        assertThat(name).as(stroke + "").isNotNull();
        pane().getActionMap().get(name).actionPerformed(new ActionEvent(pane(), 0, ""));
    }

    private int[] painted() {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        pane().paint(image.createGraphics());
        return image.getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH);
    }

    @Test
    void helpIsDrawnOverTheWindowAndGoesAgain() {
        int[] plain = painted();
        press(KeyStroke.getKeyStroke('h'));
        assertThat(painted()).isNotEqualTo(plain);
        press(KeyStroke.getKeyStroke("ESCAPE"));
        assertThat(painted()).isEqualTo(plain);
        press(KeyStroke.getKeyStroke("F1"));
        press(KeyStroke.getKeyStroke('H'));
        assertThat(painted()).isEqualTo(plain);
    }

    /** The sonars of the file are drawn when it is opened, measure anew after a drag, and can be left out. */
    @Test
    void sonars() {
        assertThat(viewing.life().pings()).hasSize(4);
        assertThat(viewing.life().pings().get(0).distance()).isEqualTo(3.5);
        assertThat(viewing.life().farthest()).isEqualTo(3.5);
        viewing.select(robot());
        Sandbox.Push push = Sandbox.Push.PLACE;
        drag(0, 0, 2, 0, push);
        assertThat(viewing.life().pings().get(0).distance()).isEqualTo(1.5);
        press(KeyStroke.getKeyStroke('s'));
        assertThat(viewing.life().pings()).isEmpty();
        press(KeyStroke.getKeyStroke('s'));
        assertThat(viewing.life().pings()).hasSize(4);
    }

    private GeometryObject robot() {
        return viewing.life().things().get(0).object();
    }

    private void drag(double x, double z, double toX, double toZ, Sandbox.Push push) {
        pane();
        var frame = viewing.camera.frame();
        viewing.press(frame.x(new Point(x, 0, z)), frame.y(new Point(x, 0, z)));
        viewing.drag(frame.x(new Point(toX, 0, toZ)), frame.y(new Point(toX, 0, toZ)), push);
    }

    @Test
    void whatIsInTheWayIsDrawnOrNot() {
        drag(0, 0, 4, 0, Sandbox.Push.PLACE);
        assertThat(viewing.life().blocked()).hasSize(1);
        press(KeyStroke.getKeyStroke('x'));
        assertThat(viewing.life().blocked()).isEmpty();
        press(KeyStroke.getKeyStroke('x'));
        assertThat(viewing.life().blocked()).hasSize(1);
    }

    /** The plan goes where the robot goes. */
    @Test
    void thePlanFollowsARobot() {
        pane();
        viewing.wheel(WIDTH / 2.0, HEIGHT / 2.0, -8);
        viewing.select(robot());
        press(KeyStroke.getKeyStroke('g'));
        drag(0, 0, 0.5, -1, Sandbox.Push.PLACE);
        viewing.release();
        viewing.tick(0);
        var visible = viewing.camera.frame().visible();
        assertThat((visible.minX() + visible.maxX()) / 2)
                .isEqualTo(robot().center().x());
        assertThat((visible.minZ() + visible.maxZ()) / 2)
                .isEqualTo(robot().center().z());
        press(KeyStroke.getKeyStroke('g'));
        drag(0.5, -1, 0, 0, Sandbox.Push.PLACE);
        viewing.release();
        viewing.tick(0);
        assertThat(viewing.camera.frame().visible()).isEqualTo(visible);
    }

    /** The file keeps colours, unit and sonars; one that exists is never replaced. */
    @Test
    void theWorldIsSavedAsItStands() throws Exception {
        drag(0, 0, 2, 1, Sandbox.Push.PLACE);
        viewing.release();
        press(KeyStroke.getKeyStroke("control S"));
        Path file = folder.resolve("a-yard-moved.xml");
        assertThat(viewing.status()).isEqualTo("saved " + file.toAbsolutePath());
        World read = WorldReader.read(file);
        assertThat(read.unit()).isEqualTo(Unit.METRE);
        assertThat(read.objects().get(0)).isEqualTo(world.objects().get(0));
        assertThat(read.objects().get(1).sonars())
                .isEqualTo(world.objects().get(1).sonars());
        assertThat(read.objects().get(1).object()).isEqualTo(robot());
        byte[] first = Files.readAllBytes(file);
        press(KeyStroke.getKeyStroke("control S"));
        assertThat(folder.resolve("a-yard-moved-2.xml")).hasBinaryContent(first);
    }

    @Test
    void aPictureOfTheWindow() throws Exception {
        int[] plain = painted();
        press(KeyStroke.getKeyStroke('h'));
        press(KeyStroke.getKeyStroke('p'));
        Path file = folder.resolve("a-yard.png");
        assertThat(viewing.status()).isEqualTo("saved " + file.toAbsolutePath());
        try (var in = Files.newInputStream(file)) {
            int[] read = PngReader.read(in).pixels();
            assertThat(Arrays.stream(read).map(each -> each & 0xffffff).toArray())
                    .isEqualTo(Arrays.stream(plain).map(each -> each & 0xffffff).toArray());
        }
    }

    /** Why nothing was saved is said. */
    @Test
    void whereNothingCanBeSaved() throws Exception {
        pane();
        Files.delete(folder);
        press(KeyStroke.getKeyStroke('p'));
        assertThat(viewing.status()).startsWith("not saved: ");
        Files.createDirectory(folder);
    }
}
