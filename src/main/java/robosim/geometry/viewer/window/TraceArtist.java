package robosim.geometry.viewer.window;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import robosim.geometry.viewer.draw.Theme;
import robosim.geometry.viewer.space.SpaceView;
import robosim.geometry.viewer.space.Trace;

/** Draws traces over a picture: what is hidden behind something is faint. */
final class TraceArtist {
    /** How opaque the hidden part is, as a share. */
    private static final double HIDDEN = 0.2;

    private final SpaceView view;
    private final Theme theme;
    private final Graphics2D page;
    private final double[] pixel = new double[3];

    TraceArtist(SpaceView view, Theme theme, Graphics2D page) {
        this.view = view;
        this.theme = theme;
        this.page = page;
    }

    void paint(Trace trace) {
        double[] places = new double[2 * trace.size()];
        boolean[] inFront = new boolean[trace.size()];
        for (int k = 0; k < trace.size(); k++) {
            double[] points = trace.points();
            inFront[k] = view.project(points[3 * k], points[3 * k + 1], points[3 * k + 2], pixel);
            places[2 * k] = clamp(pixel[0]);
            places[2 * k + 1] = clamp(pixel[1]);
        }
        switch (trace.kind()) {
            case LINE -> line(trace, places, inFront);
            case FAN -> fan(trace, places, inFront);
            case DOTS -> dots(trace, places, inFront);
        }
    }

    /** Far outside the picture, where numbers are too large to draw. */
    private static double clamp(double place) {
        return Math.max(-1e5, Math.min(1e5, place));
    }

    private void line(Trace trace, double[] places, boolean[] inFront) {
        page.setStroke(new BasicStroke((float) trace.width(), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        for (int k = 1; k < trace.size(); k++) {
            if (inFront[k - 1] && inFront[k]) {
                ink(trace, trace.seen()[k - 1] || trace.seen()[k]);
                page.draw(new Line2D.Double(places[2 * k - 2], places[2 * k - 1], places[2 * k], places[2 * k + 1]));
            }
        }
    }

    private void fan(Trace trace, double[] places, boolean[] inFront) {
        for (int k = 2; k < trace.size(); k++) {
            if (inFront[0] && inFront[k - 1] && inFront[k]) {
                ink(trace, trace.seen()[k - 1] || trace.seen()[k]);
                Path2D triangle = new Path2D.Double();
                triangle.moveTo(places[0], places[1]);
                triangle.lineTo(places[2 * k - 2], places[2 * k - 1]);
                triangle.lineTo(places[2 * k], places[2 * k + 1]);
                triangle.closePath();
                page.fill(triangle);
            }
        }
    }

    private void dots(Trace trace, double[] places, boolean[] inFront) {
        double size = trace.width();
        for (int k = 0; k < trace.size(); k++) {
            if (inFront[k]) {
                ink(trace, trace.seen()[k]);
                page.fill(new Ellipse2D.Double(places[2 * k] - size / 2, places[2 * k + 1] - size / 2, size, size));
            }
        }
    }

    private void ink(Trace trace, boolean isSeen) {
        double share = trace.share() * (isSeen ? 1 : HIDDEN);
        int alpha = (int) Math.round(255 * share);
        page.setColor(new Color((trace.ink().in(theme) & 0xffffff) | (alpha << 24), true));
    }
}
