package robosim.geometry.render;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/**
 * A picture by the book, which shares no code with the product: every ray is tried on every shape with textbook formulas,
 * shadows begin a millionth of a unit away, and colours go through the formulas of sRGB. It only reads values.
 */
final class SlowTracer {
    /** Where rays begin that leave a surface; scenes are some units large. */
    private static final double AWAY = 1e-6;

    /** A vector, with the operations of the books. */
    record V(double x, double y, double z) {
        static V of(Point p) {
            return new V(p.x(), p.y(), p.z());
        }

        V plus(V o) {
            return new V(x + o.x, y + o.y, z + o.z);
        }

        V minus(V o) {
            return new V(x - o.x, y - o.y, z - o.z);
        }

        V times(double f) {
            return new V(x * f, y * f, z * f);
        }

        V times(V o) {
            return new V(x * o.x, y * o.y, z * o.z);
        }

        double dot(V o) {
            return x * o.x + y * o.y + z * o.z;
        }

        V cross(V o) {
            return new V(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x);
        }

        V unit() {
            return times(1 / Math.sqrt(dot(this)));
        }

        double at(int axis) {
            return axis == 0 ? x : axis == 1 ? y : z;
        }
    }

    /** Three columns: the own axes. */
    record Frame(V center, V ax, V ay, V az) {
        static Frame of(GeometryObject object) {
            double[] r = object.rotation();
            return new Frame(
                    V.of(object.center()), new V(r[0], r[3], r[6]), new V(r[1], r[4], r[7]), new V(r[2], r[5], r[8]));
        }

        V out(V own) {
            return ax.times(own.x).plus(ay.times(own.y)).plus(az.times(own.z));
        }

        V place(V own) {
            return center.plus(out(own));
        }

        V in(V world) {
            return new V(world.dot(ax), world.dot(ay), world.dot(az));
        }

        Frame within(Frame outer) {
            return new Frame(outer.place(center), outer.out(ax), outer.out(ay), outer.out(az));
        }
    }

    /** A shape at its place; the first distance above 0 at which a ray in its own frame meets it, and the normal there. */
    private record Shape(GeometryObject object, Frame frame, Material material) {}

    private record Hit(double distance, V normal, Shape shape, V own, double[] share) {}

    private final List<Shape> shapes = new ArrayList<>();

    /** By the number of a shape that is a cell of a grid, its middle in the grid's frame. */
    private final Map<Integer, V> cells = new HashMap<>();

    private final Lighting lighting;
    private final int mirrors;

    SlowTracer(List<? extends GeometryObject> objects, Lighting lighting, int mirrors) {
        this.lighting = lighting;
        this.mirrors = mirrors;
        for (GeometryObject object : objects) {
            add(object, Frame.of(object), object.material());
        }
    }

    private void add(GeometryObject object, Frame frame, Material material) {
        if (object instanceof ObjectGroup group) {
            for (GeometryObject member : group.members()) {
                add(member, Frame.of(member).within(frame), member.material().within(material));
            }
        } else if (object instanceof GridObject grid) {
            for (int row = 0; row < grid.rows(); row++) {
                for (int column = 0; column < grid.columns(); column++) {
                    if (grid.isOccupied(column, row)) {
                        double x = (column + 0.5 - grid.columns() / 2.0) * grid.cell();
                        double z = (row + 0.5 - grid.rows() / 2.0) * grid.cell();
                        cells.put(shapes.size(), new V(x, 0, z));
                        shapes.add(new Shape(grid, frame, material));
                    }
                }
            }
        } else {
            shapes.add(new Shape(object, frame, material));
        }
    }

    /** The colour of a ray, 0 to 255 each, before rounding. */
    double[] color(V from, V way) {
        V light = light(from, way.unit(), 0);
        return new double[] {encoded(light.x), encoded(light.y), encoded(light.z)};
    }

    private static double encoded(double linear) {
        double c = Math.max(0, Math.min(1, linear));
        return 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * Math.pow(c, 1 / 2.4) - 0.055);
    }

    private static V linear(Color c) {
        return new V(decoded(c.red()), decoded(c.green()), decoded(c.blue()));
    }

    private static V packed(int rgb) {
        return new V(
                decoded((rgb >> 16 & 255) / 255.0), decoded((rgb >> 8 & 255) / 255.0), decoded((rgb & 255) / 255.0));
    }

    private static double decoded(double c) {
        return c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
    }

    private V light(V from, V way, int depth) {
        Hit hit = first(from, way);
        Sky sky = lighting.sky();
        if (hit == null) {
            double up = way.y;
            V end = linear(up >= 0 ? sky.zenith() : sky.ground());
            double share = Math.pow(1 - Math.min(1, up >= 0 ? up : -3 * up), 3);
            return end.times(1 - share).plus(linear(sky.horizon()).times(share));
        }
        Material m = hit.shape.material;
        V n = hit.normal;
        V point = from.plus(way.times(hit.distance)).plus(n.times(AWAY));
        V color = m.texture() == null ? linear(m.color()) : texture(m.texture(), hit);
        V above = linear(sky.zenith()).plus(linear(sky.horizon())).times(0.5);
        V below = linear(sky.ground());
        if (sky.light() != null) {
            above = linear(sky.light());
            below = above;
        }
        V around = above.times((1 + n.y) / 2).plus(below.times((1 - n.y) / 2)).times(sky.strength());
        V own = linear(m.emission()).plus(around.times(color).times(m.diffuse()));
        for (Light light : lighting.lights()) {
            own = own.plus(received(light, point, n, way, color, m));
        }
        if (depth == mirrors || m.mirror() == 0) {
            return own;
        }
        V mirrored = way.minus(n.times(2 * way.dot(n)));
        return own.times(1 - m.mirror()).plus(light(point, mirrored, depth + 1).times(m.mirror()));
    }

    private V received(Light light, V point, V n, V way, V color, Material m) {
        V to;
        double arriving = light.strength();
        double far = Double.POSITIVE_INFINITY;
        if (light instanceof Light.Sun sun) {
            to = V.of(sun.direction()).times(-1).unit();
        } else {
            Point place = light instanceof Light.Lamp lamp ? lamp.place() : ((Light.Spot) light).place();
            V toLight = V.of(place).minus(point);
            far = Math.sqrt(toLight.dot(toLight));
            to = toLight.unit();
            Light.Falloff falloff = light instanceof Light.Lamp lamp ? lamp.falloff() : ((Light.Spot) light).falloff();
            arriving /= falloff.constant() + far * (falloff.linear() + far * falloff.quadratic());
            arriving = far > falloff.range() ? 0 : arriving;
        }
        if (light instanceof Light.Spot spot) {
            double angle = Math.toDegrees(Math.acos(Math.max(
                    -1, Math.min(1, -to.dot(V.of(spot.direction()).unit())))));
            double half = spot.degrees() / 2;
            double edge = Math.cos(Math.toRadians(half));
            double full = Math.cos(Math.toRadians(half * 0.75));
            double share = (Math.cos(Math.toRadians(angle)) - edge) / (full - edge);
            arriving *= angle >= half ? 0 : angle <= 0.75 * half ? 1 : share * share * (3 - 2 * share);
        }
        arriving *= n.dot(to);
        if (arriving <= 0) {
            return new V(0, 0, 0);
        }
        Hit between = light.shadows() == Light.Shadows.NONE ? null : first(point, to);
        if (between != null && between.distance <= far) {
            return new V(0, 0, 0);
        }
        V mirrored = n.times(2 * n.dot(to)).minus(to);
        double highlight = m.specular() * Math.pow(Math.max(0, -mirrored.dot(way)), m.shininess());
        return color.times(m.diffuse())
                .plus(new V(highlight, highlight, highlight))
                .times(linear(light.color()))
                .times(arriving);
    }

    private Hit first(V from, V way) {
        Hit best = null;
        for (int k = 0; k < shapes.size(); k++) {
            Shape shape = shapes.get(k);
            V o = shape.frame.in(from.minus(shape.frame.center));
            V d = shape.frame.in(way);
            Hit hit = meet(shape, cells.get(k), o, d);
            if (hit != null && (best == null || hit.distance < best.distance)) {
                best = hit;
            }
        }
        return best;
    }

    private static Hit meet(Shape shape, V cell, V o, V d) {
        double[] best = {Double.POSITIVE_INFINITY};
        V[] normal = new V[1];
        double[] share = null;
        GeometryObject object = shape.object;
        if (object instanceof BoxObject box) {
            slabs(o, d, new V(box.width() / 2, box.height() / 2, box.length() / 2), best, normal);
        } else if (object instanceof GridObject grid) {
            double half = grid.cell() / 2;
            slabs(o.minus(cell), d, new V(half, grid.height() / 2, half), best, normal);
        } else if (object instanceof SphereObject sphere) {
            ball(o, d, 0, sphere.radius(), best, normal);
        } else if (object instanceof CylinderObject cylinder) {
            mantle(o, d, cylinder.radius(), cylinder.height() / 2, best, normal);
            for (int side = -1; side <= 1; side += 2) {
                double t = (side * cylinder.height() / 2 - o.y) / d.y;
                V p = o.plus(d.times(t));
                if (t > 0 && p.x * p.x + p.z * p.z <= cylinder.radius() * cylinder.radius()) {
                    take(t, new V(0, side, 0), best, normal);
                }
            }
        } else if (object instanceof CapsuleObject capsule) {
            mantle(o, d, capsule.radius(), capsule.segment() / 2, best, normal);
            ball(o, d, capsule.segment() / 2, capsule.radius(), best, normal);
            ball(o, d, -capsule.segment() / 2, capsule.radius(), best, normal);
        } else if (object instanceof MeshObject mesh) {
            int first = 0; // corner of the face
            for (int[] face : mesh.faces()) {
                for (int k = 2; k < face.length; k++) {
                    V a = V.of(mesh.vertices().get(face[0]));
                    V b = V.of(mesh.vertices().get(face[k - 1]));
                    V c = V.of(mesh.vertices().get(face[k]));
                    double before = best[0];
                    triangle(o, d, a, b, c, best, normal);
                    if (best[0] < before) {
                        share = share(
                                mesh, new int[] {first, first + k - 1, first + k}, a, b, c, o.plus(d.times(best[0])));
                    }
                }
                first += face.length;
            }
        }
        if (normal[0] == null) {
            return null;
        }
        V n = normal[0].dot(d) > 0 ? normal[0].times(-1) : normal[0];
        return new Hit(best[0], shape.frame.out(n), shape, o.plus(d.times(best[0])), share);
    }

    /** The place in the image of a point of a triangle, by the shares of its corners; null without coordinates. */
    private static double[] share(MeshObject mesh, int[] corners, V a, V b, V c, V p) {
        TextureCoordinates given = mesh.textureCoordinates();
        if (given == null) {
            return null;
        }
        V n = b.minus(a).cross(c.minus(a));
        double[] weights = {
            c.minus(b).cross(p.minus(b)).dot(n) / n.dot(n),
            a.minus(c).cross(p.minus(c)).dot(n) / n.dot(n),
            b.minus(a).cross(p.minus(a)).dot(n) / n.dot(n)
        };
        double[] uv = new double[2];
        for (int k = 0; k < 3; k++) {
            int point = given.corners()[corners[k]];
            if (point == TextureCoordinates.NONE) {
                return null;
            }
            uv[0] += weights[k] * given.points()[2 * point];
            uv[1] += weights[k] * given.points()[2 * point + 1];
        }
        return uv;
    }

    private static void take(double t, V n, double[] best, V[] normal) {
        if (t > 0 && t < best[0]) {
            best[0] = t;
            normal[0] = n;
        }
    }

    private static void slabs(V o, V d, V half, double[] best, V[] normal) {
        for (int axis = 0; axis < 3; axis++) {
            for (int side = -1; side <= 1; side += 2) {
                double t = (side * half.at(axis) - o.at(axis)) / d.at(axis);
                V p = o.plus(d.times(t));
                int b = (axis + 1) % 3;
                int c = (axis + 2) % 3;
                if (t > 0 && Math.abs(p.at(b)) <= half.at(b) && Math.abs(p.at(c)) <= half.at(c)) {
                    take(t, new V(axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0), best, normal);
                }
            }
        }
    }

    private static void ball(V o, V d, double y, double r, double[] best, V[] normal) {
        V m = o.minus(new V(0, y, 0));
        double b = m.dot(d);
        double root = b * b - (m.dot(m) - r * r);
        if (root >= 0) {
            for (int side = -1; side <= 1; side += 2) {
                double t = -b + side * Math.sqrt(root);
                V p = m.plus(d.times(t));
                if (y == 0 || p.y * y >= 0) { // of a capsule, the outer half
                    take(t, p.times(1 / r), best, normal);
                }
            }
        }
    }

    private static void mantle(V o, V d, double r, double half, double[] best, V[] normal) {
        double a = d.x * d.x + d.z * d.z;
        double b = o.x * d.x + o.z * d.z;
        double c = o.x * o.x + o.z * o.z - r * r;
        double root = b * b - a * c;
        if (root >= 0 && a > 0) {
            for (int side = -1; side <= 1; side += 2) {
                double t = (-b + side * Math.sqrt(root)) / a;
                V p = o.plus(d.times(t));
                if (Math.abs(p.y) <= half) {
                    take(t, new V(p.x / r, 0, p.z / r), best, normal);
                }
            }
        }
    }

    /** Möller and Trumbore 1997. */
    private static void triangle(V o, V d, V a, V b, V c, double[] best, V[] normal) {
        V e = b.minus(a);
        V f = c.minus(a);
        V p = d.cross(f);
        double det = e.dot(p);
        V s = o.minus(a);
        V q = s.cross(e);
        double u = s.dot(p) / det;
        double v = d.dot(q) / det;
        if (u >= 0 && v >= 0 && u + v <= 1) {
            take(f.dot(q) / det, e.cross(f).unit(), best, normal);
        }
    }

    private V texture(Texture texture, Hit hit) {
        double[] st = place(hit);
        if (texture instanceof Texture.Checker checker) {
            long sum = (long) Math.floor(st[0] / checker.size()) + (long) Math.floor(st[1] / checker.size());
            return linear(sum % 2 == 0 ? checker.first() : checker.second());
        }
        if (texture instanceof Texture.Stripes stripes) {
            double angle = Math.toRadians(stripes.degrees());
            double across = st[1] * Math.cos(angle) - st[0] * Math.sin(angle);
            return linear((long) Math.floor(across / stripes.size()) % 2 == 0 ? stripes.first() : stripes.second());
        }
        ImageTexture image = (ImageTexture) texture;
        double[] uv =
                hit.share == null ? new double[] {st[0] / image.tileWidth(), st[1] / image.tileHeight()} : hit.share;
        double x = uv[0] * image.width() - 0.5;
        double y = -uv[1] * image.height() - 0.5;
        V sum = new V(0, 0, 0);
        for (int dy = 0; dy < 2; dy++) {
            for (int dx = 0; dx < 2; dx++) {
                double wx = dx == 1 ? x - Math.floor(x) : 1 - (x - Math.floor(x));
                double wy = dy == 1 ? y - Math.floor(y) : 1 - (y - Math.floor(y));
                int column = Math.floorMod((int) Math.floor(x) + dx, image.width());
                int row = Math.floorMod((int) Math.floor(y) + dy, image.height());
                sum = sum.plus(packed(image.pixel(column, row)).times(wx * wy));
            }
        }
        return sum;
    }

    /** As the table of {@link Texture} says. */
    private static double[] place(Hit hit) {
        GeometryObject object = hit.shape.object;
        V p = hit.own;
        V n = hit.shape.frame.in(hit.normal);
        double longitude = Math.atan2(-p.z, p.x);
        longitude = longitude < 0 ? longitude + 2 * Math.PI : longitude;
        if (object instanceof SphereObject s) {
            return new double[] {longitude * s.radius(), (Math.asin(p.y / s.radius()) + Math.PI / 2) * s.radius()};
        }
        if (object instanceof CylinderObject c) {
            return Math.abs(n.y) > 0.5
                    ? side(p, n, c.radius(), c.height() / 2, c.radius())
                    : new double[] {longitude * c.radius(), p.y + c.height() / 2};
        }
        if (object instanceof CapsuleObject c) {
            double half = c.segment() / 2;
            double r = c.radius();
            double along;
            if (Math.abs(p.y) <= half) {
                along = r * Math.PI / 2 + p.y + half;
            } else if (p.y < 0) {
                along = r * (Math.asin((p.y + half) / r) + Math.PI / 2);
            } else {
                along = r * (Math.asin((p.y - half) / r) + Math.PI / 2) + c.segment();
            }
            return new double[] {longitude * r, along};
        }
        if (object instanceof GridObject grid) {
            return side(p, n, grid.columns() * grid.cell() / 2, grid.height() / 2, grid.rows() * grid.cell() / 2);
        }
        return object instanceof BoxObject box
                ? side(p, n, box.width() / 2, box.height() / 2, box.length() / 2)
                : side(p, n, 0, 0, 0);
    }

    private static double[] side(V p, V n, double x, double y, double z) {
        if (Math.abs(n.y) >= Math.max(Math.abs(n.x), Math.abs(n.z))) {
            return n.y > 0 ? new double[] {p.x + x, z - p.z} : new double[] {p.x + x, p.z + z};
        }
        if (Math.abs(n.x) >= Math.abs(n.z)) {
            return n.x > 0 ? new double[] {z - p.z, p.y + y} : new double[] {p.z + z, p.y + y};
        }
        return n.z > 0 ? new double[] {p.x + x, p.y + y} : new double[] {x - p.x, p.y + y};
    }
}
