package robosim.geometry.render;

import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.material.Color;
import robosim.geometry.model.Point;

/** A {@link Light} as shading needs it: what of it arrives at a point, if nothing is in the way. */
final class PixelBeam {
    final double red;
    final double green;
    final double blue;

    /** Whether what is in the way keeps its light off. */
    final boolean hasShadows;

    /** Whether it is so far away that its rays are parallel. */
    private final boolean isSun;

    private final double x;
    private final double y;
    private final double z;

    // The axis of a spot, and the cosines at which it is dark and at which it is in full strength; below -1 for a lamp.
    private double axisX;
    private double axisY;
    private double axisZ;
    private double edge = -2;
    private double full = -1;

    private Light.Falloff falloff = Light.Falloff.SQUARE;

    // What was found for the last point: the unit way to the light, how far it is, and how much arrives.
    double wayX;
    double wayY;
    double wayZ;
    double distance;
    double strength;

    PixelBeam(Light light) {
        Color color = light.color();
        red = color.linearRed() * light.strength();
        green = color.linearGreen() * light.strength();
        blue = color.linearBlue() * light.strength();
        hasShadows = light.shadows() == Light.Shadows.HARD;
        isSun = light instanceof Light.Sun;
        if (light instanceof Light.Sun sun) {
            Point way = sun.direction();
            double scale = scale(way);
            x = -way.x() * scale;
            y = -way.y() * scale;
            z = -way.z() * scale;
        } else {
            Point place = light instanceof Light.Spot spot ? spot.place() : ((Light.Lamp) light).place();
            falloff = light instanceof Light.Spot spot ? spot.falloff() : ((Light.Lamp) light).falloff();
            x = place.x();
            y = place.y();
            z = place.z();
        }
        if (light instanceof Light.Spot spot) {
            double scale = scale(spot.direction());
            axisX = spot.direction().x() * scale;
            axisY = spot.direction().y() * scale;
            axisZ = spot.direction().z() * scale;
            edge = Degrees.cos(spot.degrees() / 2);
            full = Degrees.cos(spot.degrees() * 3 / 8);
        }
    }

    private static double scale(Point way) {
        double most = VectorMath.largest(way.x(), way.y(), way.z());
        return 1 / most / VectorMath.length(way.x() / most, way.y() / most, way.z() / most);
    }

    /** Looks at the light from a point on a surface; answers whether it may be lit. */
    boolean reaches(double[] points, double[] normals, int at) {
        if (isSun) {
            wayX = x;
            wayY = y;
            wayZ = z;
            distance = Double.POSITIVE_INFINITY;
            strength = facing(normals, at);
            return strength > 0;
        }
        double dx = x - points[at];
        double dy = y - points[at + 1];
        double dz = z - points[at + 2];
        double square = dx * dx + dy * dy + dz * dz;
        if (!(square > 0)) {
            return false;
        }
        distance = Math.sqrt(square);
        if (distance > falloff.range()) {
            return false;
        }
        wayX = dx / distance;
        wayY = dy / distance;
        wayZ = dz / distance;
        strength =
                facing(normals, at) / (falloff.constant() + falloff.linear() * distance + falloff.quadratic() * square);
        double along = -(wayX * axisX + wayY * axisY + wayZ * axisZ);
        if (edge > -2 && along < full) {
            double share = (along - edge) / (full - edge);
            strength *= share > 0 ? share * share * (3 - 2 * share) : 0;
        }
        return strength > 0;
    }

    private double facing(double[] n, int at) {
        return n[at] * wayX + n[at + 1] * wayY + n[at + 2] * wayZ;
    }
}
