package robosim.geometry.viewer.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayDeque;
import java.util.Deque;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.Point;
import robosim.geometry.viewer.Talk;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.space.Gallery;
import robosim.geometry.viewer.window.ViewerPaneTest.Shown;

/** The part of the window with the world in three dimensions, painted and driven by events, without any display. */
class SpacePanelTest {
    private static final int WIDTH = 700;
    private static final int HEIGHT = 400;

    private final Deque<Runnable> waiting = new ArrayDeque<>();
    private final ViewerModel viewing;
    private final ViewerPane pane;

    SpacePanelTest() {
        viewing = ViewerModelTest.world();
        pane = new ViewerPane(viewing, Theme.LIGHT, waiting::add);
        pane.setSize(WIDTH, HEIGHT);
        Shown.layOut(pane);
    }

    private SpacePanel space() {
        return (SpacePanel) Shown.find(pane, "space");
    }

    private void typed(char letter) {
        KeyStroke stroke = KeyStroke.getKeyStroke(letter);
        Object name = pane.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).get(stroke);
        pane.getActionMap().get(name).actionPerformed(new ActionEvent(pane, 0, ""));
        Shown.layOut(pane);
    }

    private void mouse(int id, int x, int y, int modifiers, int clicks) {
        int held = InputEvent.BUTTON1_DOWN_MASK | modifiers;
        space().dispatchEvent(new MouseEvent(space(), id, 0, held, x, y, clicks, false, MouseEvent.BUTTON1));
    }

    private void drag(int dx, int dy, int modifiers) {
        mouse(MouseEvent.MOUSE_PRESSED, 100, 100, modifiers, 1);
        mouse(MouseEvent.MOUSE_DRAGGED, 100 + dx, 100 + dy, modifiers, 1);
        mouse(MouseEvent.MOUSE_RELEASED, 100 + dx, 100 + dy, modifiers, 1);
    }

    private void click(int x, int y, int clicks) {
        mouse(MouseEvent.MOUSE_PRESSED, x, y, 0, clicks);
        mouse(MouseEvent.MOUSE_RELEASED, x, y, 0, clicks);
    }

    /** Does all that is waiting to be rendered. */
    private void render() {
        while (!waiting.isEmpty()) {
            waiting.remove().run();
        }
    }

    private BufferedImage paint() {
        render();
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D page = image.createGraphics();
        space().paint(page);
        page.dispose();
        return image;
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

    /** The middle of all pixels that are rather red; null where there are none. */
    private static int[] red(BufferedImage image) {
        long sumX = 0;
        long sumY = 0;
        int count = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                int rgb = image.getRGB(x, y);
                if ((rgb >> 16 & 0xff) > 100 + (rgb & 0xff)) {
                    sumX += x;
                    sumY += y;
                    count++;
                }
            }
        }
        return count == 0 ? null : new int[] {(int) (sumX / count), (int) (sumY / count), count};
    }

    @Test
    void aKeyOrAButtonShowsThePlanOrBothOrSpace() {
        assertThat(Shown.find(pane, "map")).isNotNull();
        assertThat(space()).isNull();
        assertThat(waiting).isEmpty(); // what is not shown is not rendered
        typed('v');
        assertThat(Shown.find(pane, "map").getWidth()).isBetween(340, 350);
        assertThat(space().getWidth()).isBetween(340, 350);
        ((JButton) Shown.find(pane, "view")).doClick(0);
        Shown.layOut(pane);
        assertThat(Shown.find(pane, "map")).isNull();
        assertThat(space().getWidth()).isEqualTo(WIDTH);
        typed('v');
        assertThat(space()).isNull();
    }

    @Test
    void theEventThreadOnlyOrders() {
        typed('v');
        assertThat(waiting).hasSize(1);
        typed('v');
        drag(40, 5, 0);
        drag(40, 5, 0);
        assertThat(waiting).hasSize(1); // one worker takes the newest order
        assertThat(red(paint())).isNotNull();
    }

    @Test
    void theHandMovesTheCamera() {
        typed('v');
        typed('v');
        BufferedImage before = paint();
        drag(60, 0, 0);
        BufferedImage orbited = paint();
        assertThat(differences(before, orbited)).isGreaterThan(5000);
        drag(0, 40, InputEvent.SHIFT_DOWN_MASK);
        BufferedImage panned = paint();
        assertThat(red(panned)[1]).isGreaterThan(red(orbited)[1] + 20);
        drag(15, 0, InputEvent.CTRL_DOWN_MASK);
        assertThat(red(paint())[0]).isGreaterThan(red(panned)[0] + 40);
        typed('f');
        assertThat(differences(before, paint())).isZero();
        space().dispatchEvent(new MouseWheelEvent(
                space(), MouseEvent.MOUSE_WHEEL, 0, 0, 350, 180, 0, false, MouseWheelEvent.WHEEL_UNIT_SCROLL, 3, -3));
        assertThat(red(paint())[2]).isGreaterThan(2 * red(before)[2]);
        typed('f');
        typed('i');
        assertThat(red(paint())[2]).isGreaterThan(red(before)[2]);
        typed('k');
        typed('+');
        typed('-');
        typed('l');
        typed('j');
        typed('o');
        typed('u');
        assertThat(red(paint())[2]).isBetween(red(before)[2] - 50, red(before)[2] + 50);
    }

    @Test
    void aClickSelectsWhatIsSeen() {
        typed('v');
        typed('v');
        BufferedImage before = paint();
        int[] wall = red(before);
        click(wall[0], wall[1], 1);
        assertThat(viewing.picked().name()).isEqualTo("wall");
        assertThat(differences(before, paint())).isBetween(500, 60_000); // its outline and its card
        click(2, 2, 1); // the sky
        assertThat(viewing.picked()).isNull();
        assertThat(differences(before, paint())).isZero();
        click(wall[0], wall[1], 2);
        int[] now = red(paint());
        assertThat(Math.abs(now[0] - WIDTH / 2)).isLessThan(15); // two clicks bring it to the middle
    }

    /** A pixel at which the robot is seen, by its exact ray. */
    private int[] robot() {
        for (int y = 0; y < HEIGHT; y += 4) {
            for (int x = 0; x < WIDTH; x += 4) {
                click(x, y, 1);
                if (viewing.picked() != null && viewing.picked().isMoveable()) {
                    return new int[] {x, y};
                }
            }
        }
        throw new AssertionError("the robot is seen");
    }

    @Test
    void aRobotIsDraggedOnTheFloor() {
        typed('v');
        typed('v');
        int[] wall = red(paint());
        int[] at = robot();
        Point before = viewing.picked().center();
        mouse(MouseEvent.MOUSE_PRESSED, at[0], at[1], 0, 1);
        mouse(MouseEvent.MOUSE_DRAGGED, at[0] + 2, at[1], 0, 1);
        assertThat(viewing.picked().center()).isEqualTo(before); // a hand that trembles moves nothing
        mouse(MouseEvent.MOUSE_DRAGGED, at[0] + 20, at[1] + 25, 0, 1);
        Point there = viewing.picked().center();
        assertThat(there).isNotEqualTo(before);
        assertThat(there.y()).isEqualTo(before.y());
        assertThat(viewing.status()).startsWith("drag what moves");
        mouse(MouseEvent.MOUSE_DRAGGED, at[0], at[1], 0, 1);
        assertThat(viewing.picked().center().x())
                .isCloseTo(before.x(), within(1e-9)); // the point touched is below the hand
        assertThat(viewing.picked().center().z()).isCloseTo(before.z(), within(1e-9));
        mouse(MouseEvent.MOUSE_RELEASED, at[0], at[1], 0, 1);
        assertThat(red(paint())[0]).isBetween(wall[0] - 3, wall[0] + 3); // no camera was moved
    }

    @Test
    void aRobotIsNotDraggedIntoAWall() {
        typed('v');
        typed('v');
        paint();
        int[] at = robot();
        Point before = viewing.picked().center();
        // From the robot towards the wall, until the wall is in the way.
        mouse(MouseEvent.MOUSE_PRESSED, at[0], at[1], InputEvent.SHIFT_DOWN_MASK, 1);
        int[] wall = red(paint());
        for (int k = 1; k <= 40 && !viewing.status().contains("in the way"); k++) {
            int x = at[0] + (wall[0] - at[0]) * k / 20;
            mouse(MouseEvent.MOUSE_DRAGGED, x, at[1] + (wall[1] - at[1]) * k / 20, InputEvent.SHIFT_DOWN_MASK, 1);
        }
        assertThat(viewing.status()).contains("wall is in the way");
        Point stays = viewing.picked().center();
        assertThat(stays.x()).isLessThan(Talk.WALL.bounds().minX());
        assertThat(stays).isNotEqualTo(before);
        BufferedImage refused = paint();
        mouse(MouseEvent.MOUSE_RELEASED, at[0], at[1], InputEvent.SHIFT_DOWN_MASK, 1);
        assertThat(viewing.status()).doesNotContain("in the way");
        assertThat(differences(refused, paint())).isGreaterThan(50); // the refusal was drawn
    }

    @Test
    void aCameraGoesAlongWithARobot() {
        typed('v');
        typed('g');
        assertThat(space().gallery.isFollowing()).isTrue();
        assertThat(space().getWidth()).isBetween(340, 350); // beside the plan
        typed('g');
        assertThat(space().gallery.isFollowing()).isFalse();
    }

    @Test
    void aRobotsOwnViewAndSeveralCameras() {
        typed('r');
        typed('v'); // from beside the plan to the whole window
        assertThat(space().gallery.arrangement()).isEqualTo(Gallery.Arrangement.OWN);
        int[] wall = red(paint());
        assertThat(wall[0]).isBetween(WIDTH / 2 - 3, WIDTH / 2 + 3); // straight ahead
        typed('r');
        assertThat(space().gallery.arrangement()).isEqualTo(Gallery.Arrangement.ONE);
        typed('c');
        typed('c');
        typed('c');
        assertThat(space().gallery.arrangement()).isEqualTo(Gallery.Arrangement.FOUR);
        BufferedImage four = paint();
        // The wall is red in each of them.
        for (Gallery.Cell cell : space().gallery.cells()) {
            boolean isRed = false;
            for (int y = cell.y(); y < cell.y() + cell.height(); y++) {
                for (int x = cell.x(); x < cell.x() + cell.width(); x++) {
                    int rgb = four.getRGB(x, y);
                    isRed |= (rgb >> 16 & 0xff) > 100 + (rgb & 0xff);
                }
            }
            assertThat(isRed).as("%s", cell).isTrue();
        }
    }

    @Test
    void aStepOfARecordingMovesTheRobotAndSonarsAreDrawn() throws Exception {
        Talk talk = Talk.begun().drives(2, true).looks(4.0);
        ViewerModel recording = ViewerModelTest.recording(talk);
        ViewerPane shown = new ViewerPane(recording, Theme.DARK, Runnable::run);
        shown.setSize(WIDTH, HEIGHT);
        ((JButton) Shown.find(shown, "view")).doClick(0);
        ((JButton) Shown.find(shown, "view")).doClick(0);
        Shown.layOut(shown);
        Component panel = Shown.find(shown, "space");
        BufferedImage[] steps = new BufferedImage[3];
        for (int k = 0; k < 3; k++) {
            steps[k] = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
            panel.paint(steps[k].createGraphics());
            ((JButton) Shown.find(shown, "forward")).doClick(0);
        }
        assertThat(differences(steps[0], steps[1])).isGreaterThan(300);
        assertThat(differences(steps[1], steps[2])).isGreaterThan(300);
    }
}
