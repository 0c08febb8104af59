package robosim.geometry.viewer.window;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.io.Serial;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.viewer.draw.Canvas;
import robosim.geometry.viewer.draw.Card;
import robosim.geometry.viewer.draw.ImageCanvas;
import robosim.geometry.viewer.draw.Palette;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.Sandbox;
import robosim.geometry.viewer.scene.MapFrame;
import robosim.geometry.viewer.space.BackgroundRenderer;
import robosim.geometry.viewer.space.Gallery;
import robosim.geometry.viewer.space.Moment;
import robosim.geometry.viewer.space.Picture;
import robosim.geometry.viewer.space.SpaceCamera;

/** The world in three dimensions: shows the newest pictures of a {@link BackgroundRenderer}, and passes mouse events on. */
public final class SpacePanel extends JComponent {
    @Serial
    private static final long serialVersionUID = 1;

    /** Pixels within which a press is not a drag. */
    private static final double SLACK = 4;

    private static final double LABEL_SIZE = 12;

    private static final int MOST_DRAWN = 4;

    final transient Gallery gallery = new Gallery();
    private final transient ViewerModel viewing;
    private final transient Runnable changed;
    private final transient BackgroundRenderer studio;
    private Theme theme;

    /** The pictures that were drawn last, with their images. */
    private final transient List<Drawn> drawn = new ArrayList<>();

    private record Drawn(Picture picture, BufferedImage image) {}

    SpacePanel(ViewerModel viewing, Theme theme, Runnable changed, Executor worker) {
        this.viewing = viewing;
        this.theme = theme;
        this.changed = changed;
        this.studio = new BackgroundRenderer(
                worker, this::repaint, Runtime.getRuntime().availableProcessors());
        setName("space");
        setOpaque(true);
        setPreferredSize(new Dimension(1100, 800));
        MouseAdapter mouse = new Mouse();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
    }

    /** One thread, which ends when it has had nothing to do for a while. */
    static Executor worker() {
        ThreadPoolExecutor one =
                new ThreadPoolExecutor(1, 1, 2, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), work -> {
                    Thread thread = new Thread(work, "viewer-pictures");
                    thread.setDaemon(true);
                    return thread;
                });
        one.allowCoreThreadTimeOut(true);
        return one;
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        gallery.resize(width, height);
        order();
    }

    void setTheme(Theme other) {
        theme = other;
        order();
        repaint();
    }

    /** Orders pictures of what the window shows now, if they are to be seen. */
    void order() {
        Moment moment = viewing.moment();
        if (getParent() == null || getWidth() == 0 || getHeight() == 0 || moment == null) {
            return;
        }
        GeometryObject picked = viewing.picked();
        String robot = picked != null && picked.isMoveable() ? picked.name() : null;
        studio.order(
                moment,
                gallery.shots(moment, robot),
                theme == Theme.LIGHT ? BackgroundRenderer.LIGHT : BackgroundRenderer.DARK);
    }

    private final class Mouse extends MouseAdapter {
        private double beginX;
        private double beginY;
        private double x;
        private double y;
        private boolean moved;
        private @Nullable FloorHand hand;

        @Override
        public void mousePressed(MouseEvent event) {
            beginX = event.getX();
            beginY = event.getY();
            x = beginX;
            y = beginY;
            moved = false;
            gallery.press(x, y);
            Picture picture = picture(x, y);
            hand = null;
            if (picture != null && SwingUtilities.isLeftMouseButton(event) && !event.isControlDown()) {
                hand = FloorHand.on(seen(x, y), picture.view().pose().center());
            }
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            moved |= StrictMath.hypot(event.getX() - beginX, event.getY() - beginY) > SLACK;
            if (!moved) {
                return;
            }
            if (hand != null) {
                push(hand, event);
            } else {
                gallery.drag(event.getX() - x, event.getY() - y, camera(event));
                order();
            }
            x = event.getX();
            y = event.getY();
        }

        /** Pushes what was taken hold of to below the pointer, as on the plan. */
        private void push(FloorHand held, MouseEvent event) {
            Picture picture = picture(beginX, beginY);
            Gallery.Cell cell = gallery.cells().get(Math.max(0, gallery.at(beginX, beginY)));
            double[] place = picture == null
                    ? null
                    : held.place(picture.view(), event.getX() - cell.x(), event.getY() - cell.y());
            if (place != null) {
                Sandbox.Push push = event.isShiftDown() ? Sandbox.Push.MOVE : Sandbox.Push.PLACE;
                viewing.push(held.robot, place[0], place[1], push);
                changed.run();
            }
        }

        private Gallery.Hand camera(MouseEvent event) {
            if (event.isControlDown()) {
                return Gallery.Hand.LOOK;
            }
            return event.isShiftDown() || !SwingUtilities.isLeftMouseButton(event)
                    ? Gallery.Hand.PAN
                    : Gallery.Hand.ORBIT;
        }

        @Override
        public void mouseReleased(MouseEvent event) {
            if (hand != null && moved) {
                viewing.release();
                changed.run();
            }
            if (moved || !SwingUtilities.isLeftMouseButton(event)) {
                return;
            }
            Picture.Seen seen = seen(event.getX(), event.getY());
            if (seen == null) {
                return;
            }
            viewing.select(seen.object());
            if (event.getClickCount() > 1 && seen.point() != null) {
                gallery.center(seen.point());
            }
            changed.run();
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent event) {
            gallery.zoom(
                    event.getX(), event.getY(), StrictMath.pow(SpaceCamera.STEP, -event.getPreciseWheelRotation()));
            order();
        }
    }

    /** What is seen at a point of the panel; null where there is no picture. */
    private Picture.@Nullable Seen seen(double x, double y) {
        Picture picture = picture(x, y);
        if (picture == null) {
            return null;
        }
        Gallery.Cell cell = gallery.cells().get(gallery.at(x, y));
        return picture.at(x - cell.x(), y - cell.y());
    }

    /** The picture at a point of the panel; null where there is none. */
    private @Nullable Picture picture(double x, double y) {
        int number = gallery.at(x, y);
        return number < 0 ? null : studio.picture(number);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D page = (Graphics2D) graphics.create();
        page.setColor(new Color(Palette.PAPER.in(theme)));
        page.fillRect(0, 0, getWidth(), getHeight());
        List<Gallery.Cell> cells = gallery.cells();
        for (int k = 0; k < cells.size(); k++) {
            paint(cells.get(k), studio.picture(k), page);
        }
        ImageCanvas canvas = new ImageCanvas(page, getWidth(), getHeight(), theme);
        String problem = studio.problem();
        if (!problem.isEmpty()) {
            canvas.text(12, getHeight() - 12.0, problem, Canvas.Anchor.START, LABEL_SIZE, Palette.REFUSED);
        }
        Card card = viewing.card();
        boolean isAlone = getParent() != null && getParent().getComponentCount() == 1;
        if (card != null && isAlone) { // beside the plan, the plan shows it
            card.paint(MapFrame.screen(getWidth(), getHeight(), 0, 0, 1), canvas);
        }
        page.dispose();
    }

    private void paint(Gallery.Cell cell, @Nullable Picture picture, Graphics2D page) {
        Graphics2D part = (Graphics2D) page.create(cell.x(), cell.y(), cell.width(), cell.height());
        if (picture == null) {
            part.setColor(new Color(Palette.FLOOR.in(theme)));
            part.fillRect(0, 0, cell.width(), cell.height());
        } else {
            Graphics2D scaled = (Graphics2D) part.create();
            // While the window is being resized, the last picture is stretched.
            scaled.scale(
                    (double) cell.width() / picture.view().width(),
                    (double) cell.height() / picture.view().height());
            draw(picture, scaled);
            scaled.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            TraceArtist artist = new TraceArtist(picture.view(), theme, scaled);
            picture.traces().forEach(artist::paint);
            scaled.dispose();
        }
        if (!cell.label().isEmpty()) {
            new ImageCanvas(part, cell.width(), cell.height(), theme)
                    .text(10, 20, cell.label(), Canvas.Anchor.START, LABEL_SIZE, Palette.TEXT);
        }
        part.dispose();
    }

    private void draw(Picture picture, Graphics2D page) {
        page.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        BufferedImage image = image(picture);
        int side = picture.step().side();
        page.translate(picture.left(), picture.top());
        page.drawImage(image, 0, 0, picture.columns() * side, picture.rows() * side, null);
        page.translate(-picture.left(), -picture.top());
    }

    /** The image of a picture: of the same pixels it is made once. */
    private BufferedImage image(Picture picture) {
        for (Drawn each : drawn) {
            if (picture.hasPixelsOf(each.picture)) {
                return each.image;
            }
        }
        BufferedImage made = new BufferedImage(picture.columns(), picture.rows(), BufferedImage.TYPE_INT_RGB);
        made.setRGB(0, 0, picture.columns(), picture.rows(), picture.pixels(), 0, picture.columns());
        if (drawn.size() >= MOST_DRAWN) {
            drawn.remove(0);
        }
        drawn.add(new Drawn(picture, made));
        return made;
    }
}
