package robosim.geometry.protocol;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** One of everything that can be sent. The stored bytes of the first release hold these: do not change them, add. */
public final class Samples {
    private Samples() {}

    /**
     * Every shape, named and nameless, static and moveable, upright and turned, with and without bounding volumes, materials
     * and texture coordinates.
     */
    public static List<GeometryObject> everyShape() {
        List<GeometryObject> shapes = new ArrayList<>(shapesBeforeMaterials());
        Material all = Material.of(new Color(0.1, 0.25, 1))
                .withDiffuse(0.5)
                .withSpecular(0.75)
                .withShininess(33.3)
                .withMirror(0.125)
                .withEmission(Color.parse("#102030"))
                .withTexture(new Texture.Stripes(Color.BLACK, new Color(0.3, 0.2, 0.1), 0.25, 45))
                .withReflectance(1)
                .withLabel(Integer.MAX_VALUE);
        ImageTexture image = new ImageTexture(2, 2, new int[] {0xff0000, 0x00ff00, 0x0000ff, 0x12abcd}, 0.5, 4);
        Material picture = Material.DEFAULT.withTexture(image);
        MeshObject quad = new MeshObject(
                List.of(new Point(), new Point(1, 0, 0), new Point(1, 0.5, 1), new Point(0, 0, 1)),
                new int[][] {{0, 1, 2, 3}, {0, 1, 2}});
        TextureCoordinates corners =
                new TextureCoordinates(new double[] {0, 0, 1, 0, 1, 0.1, -2, 1}, new int[] {0, 1, 2, 3, -1, 1, 2});
        BoxObject box = new BoxObject(new Point(11, 0, 0), 1, 2, 3).withMaterial(all);
        shapes.add(box);
        shapes.add(new CylinderObject(new Point(11, 0, 4), 0.5, 1)
                .withMaterial(Material.DEFAULT.withTexture(new Texture.Checker(Color.WHITE, Color.BLACK, 1e-3)))
                .named("checked"));
        shapes.add(
                new SphereObject(new Point(11, 0, 8), 0.5).withMaterial(picture).moveable("picture"));
        shapes.add(new CapsuleObject(new Point(14, 0, 0), 0.5, 1)
                .withMaterial(picture)
                .named("same picture"));
        shapes.add(quad.withTextureCoordinates(corners));
        MeshObject poster =
                quad.withTextureCoordinates(corners).withMaterial(picture).turned(20, 30);
        shapes.add(new ObjectGroup(List.of(box, poster, box.withMaterial(Material.DEFAULT)))
                .withMaterial(Material.DEFAULT.withLabel(1))
                .movedTo(new Point(-30, 0, 0)));
        shapes.add(shapesBeforeMaterials()
                .get(shapesBeforeMaterials().size() - 1)
                .named("painted")
                .withMaterial(Material.of(Color.parse("#ff8000"))));
        return List.copyOf(shapes);
    }

    /** The shapes that there were before materials. */
    static List<GeometryObject> shapesBeforeMaterials() {
        List<GeometryObject> shapes = new ArrayList<>(shapesBeforeTheGrid());
        byte[] cells = {(byte) 0b1010_0101, 0b11};
        shapes.add(GridObject.of(new Point(6, 0.5, -6), 0.3, 2, 5, 2, cells));
        shapes.add(GridObject.of(new Point(0.1, 0, 8), 0.05, 0, 2, 5, cells)
                .turned(0, 0.1)
                .turned(0, 33.3)
                .named("map"));
        return List.copyOf(shapes);
    }

    /** The shapes that there were before the grid. */
    static List<GeometryObject> shapesBeforeTheGrid() {
        List<GeometryObject> shapes = new ArrayList<>(firstShapes());
        shapes.add(
                new CapsuleObject(new Point(-4, 1, 4), 0.25, 1.5).turned(10, 20).moveable("capsule"));
        return List.copyOf(shapes);
    }

    /** The shapes that there were before the capsule. */
    static List<GeometryObject> firstShapes() {
        BoxObject box = new BoxObject(new Point(1, 2, -3), 0.1, 2, 3);
        MeshObject tetrahedron = new MeshObject(
                        List.of(new Point(), new Point(1, 0, 0), new Point(0, 1, 0), new Point(0, 0, 1)),
                        new int[][] {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}},
                        new SphereObject(new Point(0.25, 0.25, 0.25), 1))
                .solid();
        MeshObject quad = new MeshObject(
                List.of(new Point(), new Point(1, 0, 0), new Point(1, 0.5, 1), new Point(0, 0, 1)),
                new int[][] {{0, 1, 2, 3}});
        ObjectGroup group = new ObjectGroup(
                List.of(box, new ObjectGroup(List.of(new SphereObject(new Point(0, 1, 0), 0.5), quad))),
                new BoxObject(new Point(), 20, 20, 20));
        return List.of(
                box,
                box.named("wall"),
                box.moveable("robot").turned(0, 0.1).turned(0, 33.3),
                new CylinderObject(new Point(4, 0, 4), 0.5, 0).turned(30, 45).named("turned"),
                new SphereObject(new Point(0x1p100, -0x1p-1074, 0), 0).moveable("\u00e9\u4e2d\ud83e\udd16"),
                tetrahedron.movedTo(new Point(7, 0, 0)).moveable("mesh"),
                quad,
                group.turned(0, 90).movedTo(new Point(-9, 0, 9)).moveable("group"));
    }

    /** One of each bundle, with every optional part given and left out. */
    public static List<Bundle> everyBundle() {
        return everyBundle(everyShape());
    }

    static List<Bundle> everyBundle(List<GeometryObject> shapes) {
        WorldSettings settings = new WorldSettings(40, 3, 30.5, Dimension.SPATIAL, Accuracy.DOP);
        return List.of(
                new InitBundle(List.of()),
                new InitBundle(shapes, settings),
                new MoveBundle(List.of()),
                new MoveBundle(List.of(
                        new MoveRequest("robot", 0.1, -0.0, 1e-300, Math.PI / 2, -0.0),
                        new MoveRequest("", -1, 0, 0, 0, 3 * Math.PI))),
                new SonarRequestBundle(List.of(
                        new SonarRequest("robot", 1, 0),
                        new SonarRequest("mesh", -0.0, -1, new Beam(0.5, 0.5, Math.nextDown(Math.PI))),
                        new SonarRequest("mesh", 1, 2, Beam.LINE))),
                new DistanceBundle(List.of(0.0, 0x1.23456789abcdep-3, Double.POSITIVE_INFINITY, Double.NaN)));
    }
}
