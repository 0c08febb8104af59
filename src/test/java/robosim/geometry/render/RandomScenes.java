package robosim.geometry.render;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Scenes of all shapes and materials, on a floor. */
final class RandomScenes {
    private final SplittableRandom random;

    RandomScenes(long seed) {
        random = new SplittableRandom(seed);
    }

    double next(double from, double to) {
        return random.nextDouble(from, to);
    }

    Color color() {
        return new Color(random.nextDouble(), random.nextDouble(), random.nextDouble());
    }

    Material material(int kind) {
        Material plain = Material.of(color());
        return switch (kind % 7) {
            case 0 -> plain;
            case 1 -> plain.withTexture(new Texture.Checker(color(), color(), next(0.2, 0.5)));
            case 2 -> plain.withTexture(new Texture.Stripes(color(), color(), next(0.1, 0.4), next(-180, 180)));
            case 3 -> plain.withMirror(next(0.2, 0.9)).withSpecular(0.5).withShininess(next(1, 200));
            case 4 -> plain.withTexture(image());
            case 5 -> plain.withEmission(color()).withDiffuse(0.3);
            default -> Material.DEFAULT;
        };
    }

    private ImageTexture image() {
        int[] pixels = new int[5 * 3];
        for (int k = 0; k < pixels.length; k++) {
            pixels[k] = random.nextInt(1 << 24);
        }
        return new ImageTexture(5, 3, pixels, next(0.5, 1.5), next(0.5, 1.5));
    }

    GeometryObject shape(int kind) {
        Point place = new Point(next(-3, 3), next(0.2, 1.6), next(-3, 3));
        return switch (kind % 6) {
            case 0 -> new BoxObject(place, next(0.3, 1.2), next(0.3, 1.2), next(0.3, 1.2));
            case 1 -> new CylinderObject(place, next(0.2, 0.6), next(0.3, 1.5));
            case 2 -> new SphereObject(place, next(0.2, 0.7));
            case 3 -> new CapsuleObject(place, next(0.2, 0.4), next(0.2, 1));
            case 4 -> pyramid().movedTo(place);
            default ->
                new ObjectGroup(List.of(
                                new BoxObject(new Point(0.3, 0, 0), 0.4, 0.5, 0.6).withMaterial(material(kind)),
                                new SphereObject(new Point(-0.3, 0.2, 0), 0.35)))
                        .movedTo(place);
        };
    }

    /** A pyramid on which an image lies by texture coordinates, but for one face. */
    MeshObject textured() {
        double[] points = new double[16];
        for (int k = 0; k < points.length; k++) {
            points[k] = next(-1.5, 2.5);
        }
        int[] corners = {0, 1, 2, 3, 4, 5, 6, 7, 1, 3, 2, 5, 0, -1, -1, -1};
        return pyramid()
                .turned(next(-90, 90), next(-180, 180))
                .withTextureCoordinates(new TextureCoordinates(points, corners))
                .withMaterial(Material.DEFAULT.withTexture(image()));
    }

    private MeshObject pyramid() {
        double s = next(0.4, 0.9);
        return new MeshObject(
                List.of(
                        new Point(-s, -s, -s),
                        new Point(s, -s, -s),
                        new Point(s, -s, s),
                        new Point(-s, -s, s),
                        new Point(0.1, s, 0)),
                new int[][] {{0, 1, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}});
    }

    /** @param turned whether objects stand in any attitude */
    List<GeometryObject> scene(int count, boolean turned) {
        List<GeometryObject> objects = new ArrayList<>();
        objects.add(new BoxObject(new Point(0, -0.5, 0), 12, 1, 12)
                .withMaterial(Material.DEFAULT.withTexture(new Texture.Checker(color(), color(), 1))));
        for (int k = 0; k < count; k++) {
            GeometryObject object = shape(k).withMaterial(material(random.nextInt(7)));
            objects.add(turned ? object.turned(next(-90, 90), next(-180, 180)) : object.turned(0, next(-180, 180)));
        }
        return objects;
    }

    Lighting lighting() {
        return new Lighting(
                        new Sky(color(), color(), color(), next(0.1, 0.5)).withLight(next(0, 1) < 0.5 ? null : color()),
                        List.of(new Light.Sun(new Point(next(-1, 1), -1, next(-1, 1)), color(), next(0.3, 0.8))))
                .withLight(new Light.Lamp(new Point(next(-5, 5), next(2.5, 4), next(-5, 5)), color(), next(1, 6)))
                .withLight(new Light.Spot(
                        new Point(next(-5, 5), 5, next(-5, 5)), new Point(0, -1, 0.1), next(40, 90), color(), 9))
                .withLight(new Light.Lamp(
                        new Point(next(-3, 3), next(0.1, 1), next(-3, 3)),
                        color(),
                        next(0.2, 0.6),
                        new Light.Falloff(next(2, 9), next(0, 1), next(0, 1), next(0.01, 1)),
                        random.nextBoolean() ? Light.Shadows.NONE : Light.Shadows.HARD));
    }
}
