package robosim.geometry.viewer.draw;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.function.Consumer;

/** Draws on an image, in one theme. */
public final class ImageCanvas implements Canvas {
    /** The maximum length in pixels of a dashed line; longer ones are drawn solid. */
    private static final double LONGEST_DASHED = 10_000;

    private final Graphics2D graphics;
    private final Theme theme;
    private final Shape whole;

    /** A canvas over the graphics of a window or an image, whose settings it changes. */
    public ImageCanvas(Graphics2D graphics, double width, double height, Theme theme) {
        this.graphics = graphics;
        this.theme = theme;
        this.whole = new Rectangle2D.Double(0, 0, width, height);
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    }

    /** Draws an image. */
    public static BufferedImage image(double width, double height, Theme theme, Consumer<Canvas> drawing) {
        BufferedImage image =
                new BufferedImage((int) Math.ceil(width), (int) Math.ceil(height), BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        drawing.accept(new ImageCanvas(graphics, image.getWidth(), image.getHeight(), theme));
        graphics.dispose();
        return image;
    }

    @Override
    public void open(String role, String name) {}

    @Override
    public void close() {}

    @Override
    public void clip(double x, double y, double width, double height) {
        graphics.setClip(new Rectangle2D.Double(x, y, width, height));
    }

    @Override
    public void unclip() {
        graphics.setClip(whole);
    }

    @Override
    public void polygons(List<double[]> corners, Style style) {
        Path2D path = new Path2D.Double(Path2D.WIND_NON_ZERO);
        for (double[] polygon : corners) {
            append(path, polygon);
            path.closePath();
        }
        draw(path, style);
    }

    @Override
    public void polyline(double[] corners, Style style) {
        Path2D path = new Path2D.Double();
        append(path, corners);
        draw(path, style);
    }

    private static void append(Path2D path, double[] corners) {
        path.moveTo(corners[0], corners[1]);
        for (int k = 2; k < corners.length; k += 2) {
            path.lineTo(corners[k], corners[k + 1]);
        }
    }

    @Override
    public void circle(double x, double y, double radius, Style style) {
        draw(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius), style);
    }

    @Override
    public void sector(double x, double y, double radius, double from, double sweep, Style style) {
        draw(new Arc2D.Double(x - radius, y - radius, 2 * radius, 2 * radius, from, sweep, Arc2D.PIE), style);
    }

    @Override
    public void arc(double x, double y, double radius, double from, double sweep, Style style) {
        draw(new Arc2D.Double(x - radius, y - radius, 2 * radius, 2 * radius, from, sweep, Arc2D.OPEN), style);
    }

    @Override
    public void text(double x, double y, String text, Anchor anchor, double size, Ink ink) {
        if (text.isEmpty()) {
            return;
        }
        double left = switch (anchor) {
            case START -> x;
            case MIDDLE -> x - StrokeFont.width(text, size) / 2;
            case END -> x - StrokeFont.width(text, size);
        };
        Path2D strokes = new Path2D.Double();
        StrokeFont.lines(text, size, left, y).forEach(line -> append(strokes, line));
        double pen = Math.max(1.1, size / 11);
        draw(strokes, Style.line(Palette.FLOOR, pen + 3, 1));
        draw(strokes, Style.line(ink, pen, 1));
    }

    private void draw(Shape shape, Style style) {
        if (style.fill() != null) {
            graphics.setColor(colour(style.fill(), style.fillOpacity()));
            graphics.fill(shape);
        }
        if (style.stroke() != null) {
            graphics.setColor(colour(style.stroke(), style.strokeOpacity()));
            float width = (float) style.width();
            boolean dashed = style.dash() > 0 && isSmall(shape);
            float[] dash = dashed ? new float[] {(float) style.dash()} : null;
            graphics.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 1, dash, 0));
            graphics.draw(shape);
        }
    }

    /** Whether a shape is small enough to be dashed; dashes far outside a zoomed window are computed too. */
    private static boolean isSmall(Shape shape) {
        Rectangle2D bounds = shape.getBounds2D();
        return bounds.getWidth() < LONGEST_DASHED && bounds.getHeight() < LONGEST_DASHED;
    }

    private Color colour(Ink ink, double opacity) {
        return new Color(ink.in(theme) | (int) Math.round(255 * opacity) << 24, true);
    }
}
