package robosim.geometry.viewer.window;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.io.Serial;
import javax.swing.JComponent;
import robosim.geometry.viewer.draw.Canvas;
import robosim.geometry.viewer.draw.ImageCanvas;
import robosim.geometry.viewer.draw.Palette;
import robosim.geometry.viewer.draw.Style;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.playback.StateHistory;

/** A slider over all steps, with a mark where a move was refused; press and drag to go to a step. */
final class Timeline extends JComponent {
    @Serial
    private static final long serialVersionUID = 1;

    private static final int SIDE = 10;
    private static final int HEIGHT = 26;

    /** Minimum distance in pixels from one mark to the next. */
    private static final double MARK = 2.5;

    private final transient ViewerModel viewing;
    private Theme theme;

    Timeline(ViewerModel viewing, Theme theme, Runnable changed) {
        this.viewing = viewing;
        this.theme = theme;
        setName("timeline");
        setPreferredSize(new Dimension(200, HEIGHT));
        setToolTipText("Drag to go to a step; marks are refused moves");
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                viewing.leaveCopy();
                viewing.player.seek(number(event.getX()));
                changed.run();
            }

            @Override
            public void mouseDragged(MouseEvent event) {
                mousePressed(event);
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    void setTheme(Theme other) {
        theme = other;
    }

    private int inside() {
        return Math.max(1, getWidth() - 2 * SIDE);
    }

    /** The step at a pixel. */
    private int number(int x) {
        int first = viewing.film.first();
        int steps = viewing.film.size() - 1 - first;
        return first + (int) Math.round((double) steps * Math.max(0, Math.min(inside(), x - SIDE)) / inside());
    }

    /** The pixel of a step. */
    double x(int number) {
        int first = viewing.film.first();
        int steps = Math.max(1, viewing.film.size() - 1 - first);
        return SIDE + inside() * (double) (number - first) / steps;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D page = (Graphics2D) graphics.create();
        page.setColor(new Color(Palette.PAPER.in(theme)));
        page.fillRect(0, 0, getWidth(), getHeight());
        ImageCanvas canvas = new ImageCanvas(page, getWidth(), getHeight(), theme);
        double y = HEIGHT / 2.0;
        canvas.line(SIDE, y, SIDE + inside(), y, Style.line(Palette.BORDER, 4, 0.45));
        int position = viewing.player.position();
        if (position >= 0) {
            canvas.line(SIDE, y, x(position), y, Style.line(Palette.robot(0), 4, 1));
            refusals(canvas, y);
            canvas.circle(x(position), y, 7, Style.filled(Palette.robot(0), 1).outlined(Palette.PAPER, 2, 1));
        }
        page.dispose();
    }

    /**
     * Draws a mark for each step in which a move was refused; if there is no room, skips those just after one with a
     * mark.
     */
    private void refusals(Canvas canvas, double y) {
        StateHistory film = viewing.film;
        double room = MARK * (film.size() - 1.0 - film.first()) / inside(); // steps per mark
        int next = film.nextRefused(film.first());
        while (next < film.size()) {
            double x = x(next);
            canvas.line(x, y - 9, x, y - 6, Style.line(Palette.REFUSED, 1.6, 0.9));
            next = film.nextRefused(next + Math.max(1, (int) Math.ceil(room)));
        }
    }
}
