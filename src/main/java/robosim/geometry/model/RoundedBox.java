package robosim.geometry.model;

/**
 * What boxes, cylinders, spheres and capsules have in common: a box that is widened by a disc about its own Y and by a ball, in
 * the object's own frame and around its centre. A box has neither; a cylinder is a segment widened by a disc, a sphere is a
 * point and a capsule a segment, both widened by a ball. Who asks an object for this need not distinguish kinds of shapes.
 *
 * <pre>{@code
 * new CapsuleObject(new Point(), 0.5, 2).roundedBox();
 * // RoundedBox[halfWidth=0.0, halfHeight=1.0, halfLength=0.0, disc=0.0, ball=0.5]
 * }</pre>
 *
 * @param halfWidth  half the box's extent along the own X, world units
 * @param halfHeight the same along the own Y
 * @param halfLength the same along the own Z
 * @param disc       radius of the disc, world units; 0 for none
 * @param ball       radius of the ball, world units; 0 for none. It or {@code disc} is 0
 */
public record RoundedBox(double halfWidth, double halfHeight, double halfLength, double disc, double ball) {
    /** A box without rounding, by its extents. */
    static RoundedBox box(double width, double height, double length) {
        return new RoundedBox(width / 2, height / 2, length / 2, 0, 0);
    }

    /** A segment along the own Y, widened. */
    static RoundedBox segment(double disc, double ball, double length) {
        return new RoundedBox(0, length / 2, 0, disc, ball);
    }

    /** Whether it is widened. */
    public boolean isRound() {
        return radius() > 0;
    }

    /** The radius of the disc or ball; 0 if there is neither. */
    public double radius() {
        return disc + ball;
    }

    /** Coordinate x, y or z of a corner of the box, not widened; {@code corner} is 0 to 7, a bit for each axis. */
    public double corner(int corner, int axis) {
        double half = axis == 0 ? halfWidth : axis == 1 ? halfHeight : halfLength;
        return (corner >> axis & 1) == 0 ? -half : half;
    }
}
