package robosim.geometry.viewer.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.KeyStroke;
import javax.swing.plaf.basic.BasicHTML;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.viewer.Talk;
import robosim.geometry.viewer.draw.ImageCanvas;
import robosim.geometry.viewer.draw.Painter;
import robosim.geometry.viewer.draw.Palette;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.Player;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** All of the window but its frame: laid out, painted and driven by events, without any display. */
class ViewerPaneTest {
    private static final int WIDTH = 1000;
    private static final int HEIGHT = 700;

    /** A pane as large as a window. */
    static final class Shown {
        final ViewerModel viewing;
        final ViewerPane pane;
        final MapPanel map;

        Shown(ViewerModel viewing) {
            this.viewing = viewing;
            this.pane = new ViewerPane(viewing, Theme.LIGHT);
            pane.setSize(WIDTH, HEIGHT);
            layOut(pane);
            this.map = (MapPanel) find(pane, "map");
        }

        static void layOut(Container container) {
            container.doLayout();
            for (Component child : container.getComponents()) {
                if (child instanceof Container inner) {
                    layOut(inner);
                }
            }
        }

        static Component find(Container container, String name) {
            for (Component child : container.getComponents()) {
                if (name.equals(child.getName())) {
                    return child;
                }
                if (child instanceof Container inner) {
                    Component found = find(inner, name);
                    if (found != null) {
                        return found;
                    }
                }
            }
            return null;
        }

        BufferedImage paint() {
            BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
            Graphics2D page = image.createGraphics();
            pane.paint(page);
            page.dispose();
            return image;
        }

        /** The colour at a place of the world. */
        int at(BufferedImage image, double worldX, double worldZ) {
            MapFrame frame = viewing.camera.frame();
            return image.getRGB((int) frame.x(worldX), (int) frame.y(worldZ)) & 0xffffff;
        }

        void mouse(int id, double worldX, double worldZ, int modifiers) {
            MapFrame frame = viewing.camera.frame();
            mouseAt(map, id, (int) frame.x(worldX), (int) frame.y(worldZ), modifiers);
        }

        void mouseAt(Component on, int id, int x, int y, int modifiers) {
            int held = InputEvent.BUTTON1_DOWN_MASK | modifiers;
            on.dispatchEvent(new MouseEvent(on, id, 0, held, x, y, 1, false, MouseEvent.BUTTON1));
        }

        void key(String stroke) {
            press(KeyStroke.getKeyStroke(stroke));
        }

        void typed(char letter) {
            press(KeyStroke.getKeyStroke(letter));
        }

        private void press(KeyStroke stroke) {
            Object name = pane.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).get(stroke);
            pane.getActionMap().get(name).actionPerformed(new ActionEvent(pane, 0, ""));
        }

        void click(String button) {
            ((JButton) find(pane, button)).doClick(0);
        }

        String status() {
            return ((JLabel) find(pane, "status")).getText();
        }
    }

    private static Shown world() {
        return new Shown(ViewerModelTest.world());
    }

    private static int differences(BufferedImage a, BufferedImage b) {
        int count = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                count += a.getRGB(x, y) == b.getRGB(x, y) ? 0 : 1;
            }
        }
        return count;
    }

    @Test
    void theMapIsDrawnInEitherTheme() {
        Shown shown = world();
        BufferedImage light = shown.paint();
        assertThat(shown.at(light, 2, 1.3)).isEqualTo(0xff0000);
        assertThat(shown.at(light, -1.5, 1.5)).isEqualTo(Palette.FLOOR.light());
        assertThat(shown.at(light, -4.6, -0.13)).isNotEqualTo(Palette.FLOOR.light());
        assertThat(light.getRGB(2, HEIGHT - 2) & 0xffffff).isEqualTo(Palette.PAPER.light());
        shown.typed('d');
        BufferedImage dark = shown.paint();
        assertThat(shown.at(dark, -1.5, 1.5)).isEqualTo(Palette.FLOOR.dark());
        assertThat(dark.getRGB(2, HEIGHT - 2) & 0xffffff).isEqualTo(Palette.PAPER.dark());
        assertThat(shown.status()).isEqualTo("drag what moves; H lists the keys");
    }

    @Test
    void thePictureIsThePaintersOwn() {
        // What the window shows of a world is what the painter draws of its parts, pixel by pixel.
        Shown shown = world();
        BufferedImage window = shown.paint();
        MapFrame frame = shown.viewing.camera.frame();
        BufferedImage drawn = ImageCanvas.image(shown.map.getWidth(), shown.map.getHeight(), Theme.LIGHT, canvas -> {
            Painter.ground(shown.viewing.ground(), frame, canvas);
            Painter.life(shown.viewing.life(), frame, canvas);
        });
        for (int y = 0; y < drawn.getHeight(); y += 3) {
            for (int x = 0; x < drawn.getWidth(); x += 3) {
                assertThat(window.getRGB(x, y)).isEqualTo(drawn.getRGB(x, y));
            }
        }
    }

    @Test
    void aDragThatIsRefusedIsSeen() {
        Shown shown = world();
        shown.mouse(MouseEvent.MOUSE_PRESSED, -5, 0, 0);
        shown.mouse(MouseEvent.MOUSE_DRAGGED, -2, 2, 0);
        shown.pane.tick(0);
        BufferedImage free = shown.paint();
        assertThat(shown.at(free, -5.2, 0.13)).isEqualTo(Palette.FLOOR.light());
        assertThat(shown.at(free, -1.7, 1.8)).isNotEqualTo(Palette.FLOOR.light());
        assertThat(shown.at(free, 2, 1.3)).isEqualTo(0xff0000);
        shown.mouse(MouseEvent.MOUSE_DRAGGED, 1.6, 0, 0);
        shown.pane.tick(0);
        BufferedImage refused = shown.paint();
        assertThat(shown.at(refused, 2, 1.3)).isNotEqualTo(0xff0000); // the wall is marked
        assertThat(shown.at(refused, -1.7, 1.8)).isEqualTo(shown.at(free, -1.7, 1.8)); // the drum stayed
        assertThat(shown.status()).isEqualTo("drum may not be there: wall is in the way");
        shown.mouse(MouseEvent.MOUSE_RELEASED, 1.6, 0, 0);
        shown.pane.tick(0);
        assertThat(shown.at(shown.paint(), 2, 1.3)).isEqualTo(0xff0000);
    }

    @Test
    void shiftAsksForTheWay() {
        Shown shown = world();
        shown.mouse(MouseEvent.MOUSE_PRESSED, -5, 0, InputEvent.SHIFT_DOWN_MASK);
        shown.mouse(MouseEvent.MOUSE_DRAGGED, 6, 0, InputEvent.SHIFT_DOWN_MASK);
        shown.pane.tick(0);
        assertThat(shown.status()).contains("wall is in the way");
        shown.mouse(MouseEvent.MOUSE_DRAGGED, 6, 0, 0);
        shown.pane.tick(0);
        assertThat(shown.status()).isEqualTo("drag what moves; H lists the keys");
    }

    @Test
    void theWheelZoomsAboutThePointerAndFFits() {
        Shown shown = world();
        double x = shown.viewing.camera.frame().x(-5);
        double scale = shown.viewing.camera.scale();
        int px = (int) x;
        int py = (int) shown.viewing.camera.frame().y(0);
        double before = shown.viewing.camera.frame().worldX(px);
        shown.map.dispatchEvent(new MouseWheelEvent(
                shown.map, MouseEvent.MOUSE_WHEEL, 0, 0, px, py, 0, false, MouseWheelEvent.WHEEL_UNIT_SCROLL, 3, -2));
        assertThat(shown.viewing.camera.scale()).isEqualTo(scale * 1.44);
        assertThat(shown.viewing.camera.frame().worldX(px)).isBetween(before - 1e-9, before + 1e-9);
        assertThat(differences(world().paint(), shown.paint())).isGreaterThan(10_000);
        shown.typed('f');
        assertThat(shown.viewing.camera.scale()).isEqualTo(scale);
        shown.typed('+');
        shown.typed('-');
        assertThat(shown.viewing.camera.scale()).isBetween(scale * 0.999, scale * 1.001);
    }

    @Test
    void theCardIsDrawnWhereSomethingIsPicked() {
        Shown shown = world();
        BufferedImage before = shown.paint();
        shown.mouse(MouseEvent.MOUSE_PRESSED, 2, 0, 0);
        shown.mouse(MouseEvent.MOUSE_RELEASED, 2, 0, 0);
        assertThat(differences(before, shown.paint())).isBetween(500, 60_000);
        shown.key("ESCAPE");
        assertThat(differences(before, shown.paint())).isZero();
    }

    @Test
    void aRecordingIsDrivenByButtonsKeysAndTheTimeline() throws Exception {
        Talk talk = Talk.begun();
        for (int k = 0; k < 30; k++) {
            talk.drives(0.1, true);
        }
        Shown shown = new Shown(ViewerModelTest.recording(talk.drives(9, false)));
        Player player = shown.viewing.player;
        shown.click("forward");
        assertThat(player.position()).isEqualTo(1);
        shown.key("RIGHT");
        shown.key("shift RIGHT");
        assertThat(player.position()).isEqualTo(12);
        shown.click("back");
        shown.key("LEFT");
        assertThat(player.position()).isEqualTo(10);
        shown.click("last");
        assertThat(player.position()).isEqualTo(31);
        assertThat(shown.status()).isEqualTo("step 32 of 32: 1 move, 1 refused: drum by wall");
        assertThat(shown.at(shown.paint(), 2, 1.3))
                .isNotEqualTo(Palette.of(Talk.WALL.kind()).light());
        shown.click("first");
        assertThat(player.position()).isZero();
        assertThat(shown.at(shown.paint(), 2, 1.3))
                .isEqualTo(Palette.of(Talk.WALL.kind()).light());
        Timeline timeline = (Timeline) Shown.find(shown.pane, "timeline");
        shown.mouseAt(timeline, MouseEvent.MOUSE_PRESSED, (int) Math.round(timeline.x(20)), 10, 0);
        assertThat(player.position()).isEqualTo(20);
        shown.mouseAt(timeline, MouseEvent.MOUSE_DRAGGED, (int) Math.round(timeline.x(5)), 10, 0);
        assertThat(player.position()).isEqualTo(5);
        shown.key("SPACE");
        assertThat(player.isPlaying()).isTrue();
        shown.pane.tick(500_000_000);
        assertThat(player.position()).isEqualTo(15);
        shown.click("play");
        assertThat(player.isPlaying()).isFalse();
        shown.click("faster");
        shown.key("UP");
        shown.click("slower");
        shown.key("UP");
        assertThat(player.speed()).isEqualTo(100);
    }

    @Test
    void theTimelineMarksRefusedMoves() throws Exception {
        Talk talk = Talk.begun();
        for (int k = 0; k < 40; k++) {
            talk.drives(k == 20 ? 9 : 0.01, k != 20);
        }
        Shown shown = new Shown(ViewerModelTest.recording(talk));
        Timeline timeline = (Timeline) Shown.find(shown.pane, "timeline");
        BufferedImage image = new BufferedImage(timeline.getWidth(), timeline.getHeight(), BufferedImage.TYPE_INT_RGB);
        timeline.paint(image.createGraphics());
        int marked = 0;
        for (int number = 1; number < 41; number++) {
            boolean red = reddish(image.getRGB((int) Math.round(timeline.x(number)), 5));
            assertThat(red).as("step %d", number).isEqualTo(number == 21);
            marked += red ? 1 : 0;
        }
        assertThat(marked).isEqualTo(1);
    }

    private static boolean reddish(int rgb) {
        return (rgb >> 16 & 0xff) - (rgb >> 8 & 0xff) > 60;
    }

    @Test
    void aNameIsShownAsItIs() {
        GeometryObject odd = Talk.DRUM.moveable("<html><h1>drum");
        World world = new World(20, 5, 10, List.of(new WorldObject(Talk.WALL), new WorldObject(odd)));
        ViewerModel viewing = ViewerModel.ofWorld(world, "small");
        viewing.camera.resize(1000, 600);
        Shown shown = new Shown(viewing);
        shown.mouse(MouseEvent.MOUSE_PRESSED, -5, 0, 0);
        shown.mouse(MouseEvent.MOUSE_DRAGGED, 1.6, 0, 0);
        shown.pane.tick(0);
        JLabel label = (JLabel) Shown.find(shown.pane, "status");
        assertThat(label.getText()).startsWith("<html><h1>drum may not be there");
        assertThat(label.getClientProperty(BasicHTML.propertyKey)).isNull();
    }
}
