package robosim.geometry.proof;

import java.util.List;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * What a proof is of. Every number is the real number that the double stands for. {@code body} is an object at the place where the
 * claim holds. {@code self} is its index in the scene, which is left out, or -1; {@code other} is an index in the scene, or {@link
 * #ALL}.
 *
 * <p>{@code touched} are pieces of the scene, counted through all its objects, that the body may touch: they are claimed not to
 * overlap it, that is, a plane has the two on different sides.
 */
public sealed interface Claim {
    /** In place of the index of an object: every object of the scene but the body itself, and the border of the world. */
    int ALL = -1;

    /** In place of the index of an object: the border of the world. */
    int BORDER = -2;

    /** The body has no point in common with an object, or with any and is within the world. */
    record Apart(GeometryObject body, int self, int other, List<Integer> touched) implements Claim {
        /** Copies the list. */
        public Apart {
            touched = List.copyOf(touched);
        }
    }

    /** The body has a point in common with an object. */
    record Touching(GeometryObject body, int other) implements Claim {}

    /** The distance between the body and an object, or the nearest of all, is in {@code [low, high]}. */
    record Distance(GeometryObject body, int self, int other, double low, double high) implements Claim {}

    /** The body can be moved by {@code free} times a displacement in a straight line: nothing is touched along it, and the border is not crossed. */
    record Translation(GeometryObject body, int self, Point displacement, double free, List<Integer> touched)
            implements Claim {
        /** Copies the list. */
        public Translation {
            touched = List.copyOf(touched);
        }
    }

    /** The same, and where the body is moved by {@code at} times the displacement it touches an object, or is beyond the border. */
    record Blocked(
            GeometryObject body, int self, Point displacement, double free, double at, int other, List<Integer> touched)
            implements Claim {
        /** Copies the list. */
        public Blocked {
            touched = List.copyOf(touched);
        }
    }

    /**
     * The body can be turned counter-clockwise about an axis through its centre, by any angle whose half has a tangent of at most
     * {@code tangent} times the axis' length: nothing is touched meanwhile, and the border is not crossed.
     */
    record Turn(GeometryObject body, int self, Point axis, double tangent, List<Integer> touched) implements Claim {
        /** Copies the list. */
        public Turn {
            touched = List.copyOf(touched);
        }
    }

    /** No object but {@code self} is nearer along a ray than {@code low}, and unless {@code high} is infinite, {@code other} is at most that far. */
    record Ray(Point start, Point direction, int self, double low, double high, int other) implements Claim {}

    /**
     * The same for the points of a cone: those to which the direction from the start has at least a given cosine with the axis.
     *
     * @param cosine of half the opening angle, above 0
     */
    record Cone(Point start, Point direction, double cosine, int self, double low, double high, int other)
            implements Claim {}
}
