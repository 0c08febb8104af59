package robosim.geometry.proof;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Point;

/**
 * What a claim can be checked with. {@code mine} is a piece of the body (0 for a ray or a cone), {@code theirs} one of the scene,
 * both counted from 0.
 *
 * @param common   directions that are tried for every pair of pieces, as the axes are
 * @param slabs    directions for single pairs
 * @param contact  what is common to two pieces, or how near they are; null where the claim has none
 * @param outsides why pieces are not inside solid meshes
 * @param reach    of a ray, the parameter up to which it is free: at least its {@code low} over the direction's length
 */
record Witness(
        List<Point> common, List<Slab> slabs, @Nullable Contact contact, List<Outside> outsides, double reach) {
    /** Copies the lists. */
    Witness {
        common = List.copyOf(common);
        slabs = List.copyOf(slabs);
        outsides = List.copyOf(outsides);
    }

    /**
     * While the parameter of the motion goes {@code from} one number {@code to} another, all of a piece of the body has a smaller
     * product with the normal than all of a piece of the scene. The parameter is the fraction of a displacement, or the tangent of
     * half the angle of a turn over the axis' length.
     *
     * @param along of a cylinder that turns, a number that its axis' product with the normal is never nearer to 0 than; else 0
     */
    record Slab(int mine, int theirs, double from, double to, Point normal, double along) {}

    /** How a {@link Contact} is to be read. */
    enum Form {
        /** {@code point} is in both pieces. */
        POINT,
        /** The segment between two {@code corners} of the body's piece meets the other piece; what is round is added to that. */
        MINE,
        /** The same with the pieces exchanged. */
        THEIRS,
        /** The ball about a corner of the body's piece, corners[0], reaches face corners[1] of the other piece. */
        MY_BALL,
        /** The same with the pieces exchanged. */
        THEIR_BALL,
        /** The segment between two points of the body's piece, {@code anchors}, meets the other piece. */
        MY_CHORD,
        /** The same with the pieces exchanged. */
        THEIR_CHORD,
        /** The first corner of the body's piece is inside the solid mesh that the other piece belongs to, by the crossings along {@code point}. */
        INSIDE,
        /** The first corner of the other piece is inside the solid mesh that the body's piece belongs to, likewise. */
        CONTAINS,
        /** {@code anchors} are a point of the body's piece and one of the other; for a cone the first is one of the scene's. */
        NEAR
    }

    /**
     * A contact of two pieces.
     *
     * @param corners two numbers, as the form says
     * @param point   a point or a direction, as the form says
     * @param anchors two points, as the form says
     */
    record Contact(int mine, int theirs, Form form, List<Integer> corners, Point point, List<Anchor> anchors) {
        /** Copies the lists. */
        Contact {
            corners = List.copyOf(corners);
            anchors = List.copyOf(anchors);
        }
    }

    /**
     * A point of a piece: its centre, {@code at} times the half sizes along the own axes, each from -1 to 1, and an offset within
     * its disc or ball. Of a triangle: the first corner, and at.x and at.y times the sides to the second and the third.
     */
    record Anchor(Point at, Point offset) {}

    /**
     * The first corner of a piece is not inside a solid mesh, whose first piece is given: in some direction, which passes no edge,
     * it has an even number of triangles before it.
     */
    record Outside(int mine, int theirs, boolean isTheirsSolid, Point direction) {}
}
