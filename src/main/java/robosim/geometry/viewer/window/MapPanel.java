package robosim.geometry.viewer.window;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.io.Serial;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import robosim.geometry.viewer.draw.Card;
import robosim.geometry.viewer.draw.ImageCanvas;
import robosim.geometry.viewer.draw.Painter;
import robosim.geometry.viewer.draw.Palette;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.Sandbox;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.scene.Scene;

/** The map of a window: draws what a {@link ViewerModel} shows, and passes it mouse events. */
public final class MapPanel extends JComponent {
    @Serial
    private static final long serialVersionUID = 1;

    private final transient ViewerModel viewing;
    private final transient Runnable changed;
    private Theme theme;

    /** The last drawn image of the static part, and what it depends on. */
    private transient @Nullable BufferedImage ground;

    private transient @Nullable Drawn drawn;

    /** Everything that the static image depends on. */
    private record Drawn(int world, Scene.View visible, int width, int height, double pixels, Theme theme) {}

    MapPanel(ViewerModel viewing, Theme theme, Runnable changed) {
        this.viewing = viewing;
        this.changed = changed;
        this.theme = theme;
        setName("map");
        setOpaque(true);
        setPreferredSize(new Dimension(1100, 800));
        MouseAdapter mouse = new Mouse();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        viewing.camera.resize(width, height);
    }

    void setTheme(Theme other) {
        theme = other;
        repaint();
    }

    private final class Mouse extends MouseAdapter {
        @Override
        public void mousePressed(MouseEvent event) {
            if (SwingUtilities.isLeftMouseButton(event)) {
                viewing.press(event.getX(), event.getY());
                changed.run();
            }
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            if (SwingUtilities.isLeftMouseButton(event)) {
                Sandbox.Push push = event.isShiftDown() ? Sandbox.Push.MOVE : Sandbox.Push.PLACE;
                viewing.drag(event.getX(), event.getY(), push);
                changed.run();
            }
        }

        @Override
        public void mouseReleased(MouseEvent event) {
            if (SwingUtilities.isLeftMouseButton(event)) {
                viewing.release();
                changed.run();
            }
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent event) {
            viewing.wheel(event.getX(), event.getY(), event.getPreciseWheelRotation());
            changed.run();
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D page = (Graphics2D) graphics.create();
        double pixels = Math.max(1, page.getTransform().getScaleX());
        MapFrame frame = viewing.camera.frame();
        page.drawImage(ground(frame, pixels), 0, 0, getWidth(), getHeight(), null);
        ImageCanvas canvas = new ImageCanvas(page, getWidth(), getHeight(), theme);
        Painter.life(viewing.life(), frame, canvas);
        Card card = viewing.card();
        if (card != null) {
            card.paint(frame, canvas);
        }
        page.dispose();
    }

    /** The static image, redrawn if anything that it depends on has changed. */
    private BufferedImage ground(MapFrame frame, double pixels) {
        Drawn now = new Drawn(viewing.world(), frame.visible(), getWidth(), getHeight(), pixels, theme);
        BufferedImage last = ground;
        if (last != null && now.equals(drawn)) {
            return last;
        }
        BufferedImage image = new BufferedImage(
                (int) Math.ceil(getWidth() * pixels),
                (int) Math.ceil(getHeight() * pixels),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D page = image.createGraphics();
        page.setColor(new Color(Palette.PAPER.in(theme)));
        page.fillRect(0, 0, image.getWidth(), image.getHeight());
        page.scale(pixels, pixels);
        Painter.ground(viewing.ground(), frame, new ImageCanvas(page, getWidth(), getHeight(), theme));
        page.dispose();
        ground = image;
        drawn = now;
        return image;
    }
}
