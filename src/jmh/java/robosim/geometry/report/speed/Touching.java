package robosim.geometry.report.speed;

import java.util.SplittableRandom;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.report.speed.PairMaker.Family;

/**
 * Objects that touch to the last bit: right triangles of whole numbers between round things, and corners, made of numbers
 * short enough to round nothing, on faces. Not every attempt succeeds; who asks checks.
 */
final class Touching {
    private static final int[][] TRIANGLES = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}, {20, 21, 29}};
    private static final int[][] DIAGONALS = {{1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {4, 4, 7, 9}, {2, 6, 9, 11}};

    /** Entries of rotations are whole multiples of this: products with short sizes and their sums are doubles. */
    private static final double GRID = 0x1p-36;

    private final SplittableRandom random;

    Touching(SplittableRandom random) {
        this.random = random;
    }

    GeometryObject[] pair(Family family) {
        return switch (family) {
            case DISC_DISC -> discs();
            case BOX_DISC -> cornerAndDisc();
            case BOX_BOX -> cornerOnFace(false);
            case TURNED_TURNED -> cornerOnFace(true);
            case CYLINDER_BOX -> cylinderAndBox();
            case BALL_BALL -> balls();
        };
    }

    /** A multiple of 1/64. */
    private double shortNumber(double least, double most) {
        return Math.rint(random.nextDouble(least, most) * 64) / 64;
    }

    private double signed(double value) {
        return random.nextBoolean() ? value : -value;
    }

    /** A way of whole 64ths and its length. */
    private double[] triangle() {
        int[] sides = TRIANGLES[random.nextInt(TRIANGLES.length)];
        boolean swap = random.nextBoolean();
        double scale = (random.nextInt(3) + 1) / 16.0 / (sides[2] > 10 ? 4 : 1);
        return new double[] {signed(sides[swap ? 1 : 0] * scale), signed(sides[swap ? 0 : 1] * scale), sides[2] * scale
        };
    }

    private GeometryObject[] discs() {
        double[] way = triangle();
        double radius = way[2] * random.nextInt(1, 8) / 8;
        Point at = new Point(shortNumber(-0.5, 0.5), 0, shortNumber(-0.5, 0.5));
        return new GeometryObject[] {
            new CylinderObject(at, radius, 1),
            new CylinderObject(new Point(at.x() + way[0], 0, at.z() + way[1]), way[2] - radius, 1)
        };
    }

    private GeometryObject[] balls() {
        int[] sides = DIAGONALS[random.nextInt(DIAGONALS.length)];
        double scale = 1.0 / 8;
        double radius = sides[3] * scale * random.nextInt(1, 8) / 8;
        Point at = new Point(shortNumber(-0.5, 0.5), shortNumber(-0.5, 0.5), shortNumber(-0.5, 0.5));
        Point other = new Point(
                at.x() + signed(sides[0] * scale),
                at.y() + signed(sides[1] * scale),
                at.z() + signed(sides[2] * scale));
        return new GeometryObject[] {new SphereObject(at, radius), new SphereObject(other, sides[3] * scale - radius)};
    }

    private BoxObject box(boolean anyAttitude) {
        BoxObject box = new BoxObject(new Point(), shortNumber(0.4, 1.6), shortNumber(0.4, 1.6), shortNumber(0.4, 1.6));
        double yaw = random.nextDouble(-180, 180);
        double[] rotation = box.turned(anyAttitude ? random.nextDouble(-180, 180) : 0, yaw)
                .rotation()
                .clone();
        for (int k = 0; k < 9; k++) {
            rotation[k] = Math.rint(rotation[k] / GRID) * GRID;
        }
        return box.oriented(rotation);
    }

    /** The corner of a box that lies farthest towards -X. */
    private static double[] corner(BoxObject box) {
        double[] r = box.rotation();
        double[] halves = {box.width() / 2, box.height() / 2, box.length() / 2};
        double[] corner = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double sign = r[axis] > 0 ? -1 : 1;
            for (int k = 0; k < 3; k++) {
                corner[k] += sign * halves[axis] * r[3 * k + axis];
            }
        }
        return corner;
    }

    /** A turned box whose corner is on the face of one that stands square. */
    private GeometryObject[] cornerOnFace(boolean anyAttitude) {
        BoxObject square =
                new BoxObject(new Point(), shortNumber(0.4, 1.6), shortNumber(0.4, 1.6), shortNumber(0.4, 1.6));
        BoxObject turned = box(anyAttitude);
        double[] corner = corner(turned);
        Point place = new Point(
                square.width() / 2 - corner[0],
                anyAttitude ? Math.rint(-corner[1] * 64) / 64 : 0,
                Math.rint(-corner[2] * 64) / 64 + shortNumber(-0.1, 0.1));
        return new GeometryObject[] {square, turned.movedTo(place)};
    }

    /** A disc that touches the corner of a turned box, or the face of a square one. */
    private GeometryObject[] cornerAndDisc() {
        BoxObject box = box(false);
        double[] way = triangle();
        double[] corner = corner(box);
        CylinderObject disc =
                new CylinderObject(new Point(corner[0] - Math.abs(way[0]), 0, corner[2] + way[1]), way[2], 1);
        return new GeometryObject[] {box, disc};
    }

    /** One on the other, or side by side. */
    private GeometryObject[] cylinderAndBox() {
        GeometryObject[] flat = cornerAndDisc();
        BoxObject box = (BoxObject) flat[0];
        CylinderObject disc = (CylinderObject) flat[1];
        CylinderObject cylinder = new CylinderObject(disc.center(), disc.radius(), shortNumber(0.4, 1.6));
        if (random.nextBoolean()) {
            return new GeometryObject[] {cylinder, box};
        }
        double up = (cylinder.height() + box.height()) / 2;
        return new GeometryObject[] {
            cylinder.movedTo(new Point(shortNumber(-0.2, 0.2), signed(up), shortNumber(-0.2, 0.2))), box
        };
    }
}
