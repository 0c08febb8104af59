package robosim.geometry.viewer.space;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.Snapshot;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/** A finished step of a picture, and what is drawn over it. */
public final class Picture {
    private final int[] pixels;
    private final int columns;
    private final int rows;
    private final Refinement.Step step;
    private final SpaceView view;
    private final Moment moment;
    private final Snapshot world;
    private final List<Trace> traces;

    /**
     * A picture.
     *
     * @param pixels of squares, row by row from the top, 0xRRGGBB; kept, not copied
     * @param step   how fine it is
     * @param view   from where it was taken, in the world
     * @param moment when it was taken
     * @param world  what it was taken of
     * @param traces to be drawn over it
     */
    Picture(int[] pixels, Refinement.Step step, SpaceView view, Moment moment, Snapshot world, List<Trace> traces) {
        this.pixels = pixels;
        this.columns = step.squares(view.width());
        this.rows = step.squares(view.height());
        this.step = step;
        this.view = view;
        this.moment = moment;
        this.world = world;
        this.traces = List.copyOf(traces);
    }

    /** Of squares, row by row from the top, 0xRRGGBB; the picture's own array, not to be changed. */
    public int[] pixels() {
        return pixels;
    }

    /** Whether two pictures differ at most in what is drawn over them. */
    public boolean hasPixelsOf(@Nullable Picture other) {
        return other != null && pixels == other.pixels;
    }

    /** Squares in a row. */
    public int columns() {
        return columns;
    }

    /** Rows of squares. */
    public int rows() {
        return rows;
    }

    /** How fine it is. */
    public Refinement.Step step() {
        return step;
    }

    /** From where it was taken, in the world. */
    public SpaceView view() {
        return view;
    }

    /** When it was taken. */
    Moment moment() {
        return moment;
    }

    /** What it was taken of. */
    Snapshot world() {
        return world;
    }

    /** What is drawn over it. */
    public List<Trace> traces() {
        return traces;
    }

    /** Where its left edge is in the view, in pixels: squares may reach beyond it, equally far on both sides. */
    public double left() {
        return (view.width() - (double) columns * step.side()) / 2;
    }

    /** Where its upper edge is in the view. */
    public double top() {
        return (view.height() - (double) rows * step.side()) / 2;
    }

    /** Whether it gets no finer. */
    public boolean isFinest() {
        return Refinement.after(step).equals(step);
    }

    Picture with(List<Trace> others) {
        return new Picture(pixels, step, view, moment, world, others);
    }

    /**
     * What is seen at a point of the view.
     *
     * @param object null for the floor and for the sky
     * @param point  where it is; null for the sky
     */
    public record Seen(
            @Nullable GeometryObject object, @Nullable Point point) {}

    /** Finds what is seen at a point of the view, by an exact ray. */
    public Seen at(double x, double y) {
        Geometry own = world.toGeometry();
        Point eye = view.pose().center();
        Point way = view.direction(x, y);
        SenseBuffer met = new SenseBuffer(SenseBuffer.Extra.OBJECTS);
        own.castRays(
                new double[] {eye.x(), eye.y(), eye.z(), way.x(), way.y(), way.z(), Double.POSITIVE_INFINITY}, 1, met);
        GeometryObject object = met.object(0);
        if (object == null) {
            return new Seen(null, null);
        }
        double far = met.distance(0);
        Point point = new Point(eye.x() + far * way.x(), eye.y() + far * way.y(), eye.z() + far * way.z());
        return new Seen(Stage.isFloor(object, moment) ? null : object, point);
    }
}
