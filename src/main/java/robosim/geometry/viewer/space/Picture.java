package robosim.geometry.viewer.space;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.SenseBuffer;
import robosim.geometry.Snapshot;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * A finished step of a picture, and what is drawn over it.
 *
 * @param pixels  of squares, row by row from the top, 0xRRGGBB; not to be changed
 * @param columns squares in a row
 * @param rows    rows of squares
 * @param step    how fine it is
 * @param view    from where it was taken, in the world
 * @param moment  when it was taken
 * @param world   what it was taken of
 * @param traces  to be drawn over it
 */
public record Picture(
        int[] pixels,
        int columns,
        int rows,
        Refinement.Step step,
        SpaceView view,
        Moment moment,
        Snapshot world,
        List<Trace> traces) {

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
        return new Picture(pixels, columns, rows, step, view, moment, world, List.copyOf(others));
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
