package robosim.geometry.material;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.check.Checks;

/**
 * A pattern on a surface. It takes the place of the material's colour.
 *
 * <p>A pattern is drawn in the plane of two lengths (s, t), in world units, that each surface defines in the object's own
 * frame; seen from outside with the own Y up, s goes to the right and t goes up:
 *
 * <table>
 * <caption>Where a point of a surface lies in the pattern</caption>
 * <tr><th>surface</th><th>s</th><th>t</th></tr>
 * <tr><td>side of a box</td><td>from the face's left edge</td><td>from its lower edge</td></tr>
 * <tr><td>top and bottom of a box</td><td>along X, from the least X</td>
 * <td>top: along -Z, from the greatest Z; bottom: along Z, from the least Z</td></tr>
 * <tr><td>cylinder</td><td>along the circle, counter-clockwise about Y, from the own X; top and bottom: as of the box around
 * it</td><td>from the lower rim</td></tr>
 * <tr><td>sphere</td><td>along the equator, at the point's longitude</td><td>along the meridian, from the lower pole</td></tr>
 * <tr><td>capsule</td><td>along the circle, at the point's longitude</td><td>along the outline, from the lower pole</td></tr>
 * <tr><td>grid</td><td colspan="2">as of one box around the whole grid</td></tr>
 * <tr><td>mesh</td><td colspan="2">as of a box whose side the triangle is by the largest component of its normal, measured
 * from the own origin. An image on triangles that have texture coordinates is placed by these instead: its left lower
 * corner is (0, 0), its right upper corner (1, 1), and it repeats</td></tr>
 * </table>
 *
 * <p>The members of a group have each its own surface.
 */
public sealed interface Texture extends Serializable permits Texture.Checker, Texture.Stripes, ImageTexture {

    /**
     * Squares of two colours in turn, as on a chess board.
     *
     * @param first  the colour of the square that begins at (0, 0)
     * @param second the colour of its neighbours
     * @param size   the side of a square in world units; above 0
     */
    record Checker(Color first, Color second, double size) implements Texture {
        @Serial
        private static final long serialVersionUID = 1;

        public Checker {
            Checks.present("first", first);
            Checks.present("second", second);
            size = Checks.positive("size", size);
        }

        @Override
        public String toString() {
            return "checker of " + first + " and " + second + ", " + size;
        }
    }

    /**
     * Parallel stripes of two colours in turn.
     *
     * @param first   the colour of the stripe that begins at (0, 0), on its left
     * @param second  the colour of its neighbours
     * @param size    the width of a stripe in world units; above 0
     * @param degrees the direction in which the stripes run, from that of s towards that of t: 0 for level ones, 90 for
     *     upright ones, 45 for those that warn
     */
    record Stripes(Color first, Color second, double size, double degrees) implements Texture {
        @Serial
        private static final long serialVersionUID = 1;

        public Stripes {
            Checks.present("first", first);
            Checks.present("second", second);
            size = Checks.positive("size", size);
            degrees = Checks.angle("degrees", degrees);
        }

        @Override
        public String toString() {
            return "stripes of " + first + " and " + second + ", " + size + " at " + degrees;
        }
    }
}
