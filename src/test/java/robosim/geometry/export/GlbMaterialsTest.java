package robosim.geometry.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.image.PngReader;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** Materials in glTF: colours, light of their own, roughness, pictures and where they lie. */
class GlbMaterialsTest {
    private static final ImageTexture PICTURE =
            new ImageTexture(2, 2, new int[] {0xff0000, 0x00ff00, 0x0000ff, 0xffffff}, 0.5, 0.25);

    /** A square, of whose two triangles the first has texture coordinates. */
    private static final MeshObject POSTER = new MeshObject(
                    List.of(new Point(0, 0, 0), new Point(1, 0, 0), new Point(1, 1, 0), new Point(0, 1, 0)),
                    new int[][] {{0, 1, 2}, {0, 2, 3}})
            .withTextureCoordinates(
                    new TextureCoordinates(new double[] {0, 0, 1, 0, 1, 1}, new int[] {0, 1, 2, -1, -1, -1}));

    @TempDir
    Path folder;

    /** Objects of each kind, with each texture. */
    static List<GeometryObject> dressed() {
        List<Texture> textures = List.of(
                new Texture.Checker(Color.WHITE, Color.parse("#303030"), 0.25),
                new Texture.Stripes(Color.parse("#ffcc00"), Color.BLACK, 0.1, 45),
                PICTURE);
        List<GeometryObject> all = new ArrayList<>();
        for (int k = 0; k < textures.size(); k++) {
            Material material = Material.DEFAULT.withTexture(textures.get(k));
            for (GeometryObject each : Pages.kinds()) {
                String name = each.name();
                Point at = each.pose().center();
                GeometryObject dressed =
                        each.movedTo(new Point(at.x(), at.y(), at.z() + 12 * k)).withMaterial(material);
                all.add(name == null ? dressed : dressed.named(name + " " + k));
            }
            all.add(POSTER.movedTo(new Point(10 * k, 0, -12)).withMaterial(material));
        }
        return all;
    }

    private byte[] written(GeometryObject... objects) throws IOException {
        Path file = folder.resolve("world.glb");
        World world = new World(
                100,
                100,
                100,
                null,
                Dimension.SPATIAL,
                Accuracy.EXACT,
                List.of(objects).stream().map(WorldObject::new).toList());
        GlbWriter.write(world, "world", file, done -> {});
        return Files.readAllBytes(file);
    }

    private static String json(byte[] glb) {
        int length = ByteBuffer.wrap(glb).order(ByteOrder.LITTLE_ENDIAN).getInt(12);
        return new String(glb, 20, length, StandardCharsets.UTF_8);
    }

    /** The bytes of a part of the binary chunk. */
    private static ByteBuffer view(byte[] glb, int number) {
        String json = json(glb);
        Matcher views = Pattern.compile("\\{\"buffer\":0,\"byteOffset\":(\\d+),\"byteLength\":(\\d+)")
                .matcher(json);
        for (int k = 0; k <= number; k++) {
            assertThat(views.find()).isTrue();
        }
        int begin = 20 + ByteBuffer.wrap(glb).order(ByteOrder.LITTLE_ENDIAN).getInt(12) + 8;
        return ByteBuffer.wrap(glb, begin + Integer.parseInt(views.group(1)), Integer.parseInt(views.group(2)))
                .slice()
                .order(ByteOrder.LITTLE_ENDIAN);
    }

    private static int number(String json, String before) {
        Matcher found = Pattern.compile(Pattern.quote(before) + "(\\d+)").matcher(json);
        assertThat(found.find()).as("%s in %s", before, json).isTrue();
        return Integer.parseInt(found.group(1));
    }

    @Test
    void colourLightRoughnessAndMirrorAreTold() throws IOException {
        Material material = Material.of(Color.parse("#ff0000"))
                .withDiffuse(0.5)
                .withShininess(30)
                .withMirror(0.25)
                .withEmission(Color.parse("#00ff00"));
        String json = json(written(new SphereObject(new Point(0, 0, 0), 1).withMaterial(material)));
        assertThat(json)
                .contains("\"baseColorFactor\":[0.5, 0.0, 0.0, 1.0],\"metallicFactor\":0.25")
                .contains("\"roughnessFactor\":" + 0.5 * 0.75) // (2 / 32)^(1/4), three quarters of it
                .contains("\"emissiveFactor\":[0.0, 1.0, 0.0]");
        String matt =
                json(written(new SphereObject(new Point(0, 0, 0), 1).withMaterial(Material.DEFAULT.withSpecular(0))));
        assertThat(matt).contains("\"roughnessFactor\":1.0");
    }

    /** A member without a material has the group's, and one with its own keeps it. */
    @Test
    void membersHaveTheirOwnMaterials() throws IOException {
        ObjectGroup pair = new ObjectGroup(List.of(
                new BoxObject(new Point(0, 0, 0), 1, 1, 1),
                new BoxObject(new Point(2, 0, 0), 1, 1, 1).withMaterial(Material.of(Color.parse("#00ff00")))));
        String json = json(written(pair.withMaterial(Material.of(Color.parse("#0000ff")))));
        assertThat(json).contains("[0.0, 0.0, 1.0, 1.0]").contains("[0.0, 1.0, 0.0, 1.0]");
        assertThat(json.split("baseColorFactor", -1)).hasSize(3);
    }

    @Test
    void picturesAreInTheFileOnce() throws IOException {
        Material material = Material.DEFAULT.withTexture(PICTURE);
        Material smaller = Material.DEFAULT.withTexture(PICTURE.tiled(0.1, 0.1));
        byte[] glb = written(
                new BoxObject(new Point(0, 0, 0), 1, 1, 1).withMaterial(material),
                new BoxObject(new Point(3, 0, 0), 1, 2, 1).withMaterial(material),
                new BoxObject(new Point(6, 0, 0), 1, 2, 1).withMaterial(smaller));
        String json = json(glb);
        assertThat(json.split("image/png", -1)).hasSize(2);
        ByteBuffer png = view(glb, number(json, "\"images\":[{\"bufferView\":"));
        byte[] bytes = new byte[png.remaining()];
        png.get(bytes);
        assertThat(PngReader.read(new ByteArrayInputStream(bytes)).pixels()).containsExactly(PICTURE.pixels());
    }

    /** Squares of the first colour begin at the left lower edge, seen from outside. */
    @Test
    void aCheckerIsAPictureOfFourPixels() throws IOException {
        Color first = Color.parse("#ff0000");
        Material material = Material.DEFAULT.withTexture(new Texture.Checker(first, Color.BLACK, 0.25));
        byte[] glb = written(new BoxObject(new Point(0, 0, 0), 1, 2, 3).withMaterial(material));
        String json = json(glb);
        ByteBuffer png = view(glb, number(json, "\"images\":[{\"bufferView\":"));
        byte[] bytes = new byte[png.remaining()];
        png.get(bytes);
        // Rows come from the top; v is 1 at the lower edge.
        assertThat(PngReader.read(new ByteArrayInputStream(bytes)).pixels()).containsExactly(0, 0xff0000, 0xff0000, 0);
        assertThat(json).contains("\"magFilter\":9728");
        ByteBuffer points = accessor(glb, number(json, "\"POSITION\":"));
        ByteBuffer normals = accessor(glb, number(json, "\"NORMAL\":"));
        ByteBuffer shares = accessor(glb, number(json, "\"TEXCOORD_0\":"));
        double[] half = {0.5, 1, 1.5};
        for (int k = 0; k < 24; k++) {
            double[] p = three(points);
            double[] n = three(normals);
            // Up is Y; on the top that which leads away from somebody who looks along -Z, on the bottom the reverse.
            double[] up = {0, n[1] == 0 ? 1 : 0, n[1] == 0 ? 0 : -n[1]};
            double[] right = {up[1] * n[2] - up[2] * n[1], up[2] * n[0] - up[0] * n[2], up[0] * n[1] - up[1] * n[0]};
            double s = 0;
            double t = 0;
            for (int axis = 0; axis < 3; axis++) {
                s += right[axis] * p[axis] + Math.abs(right[axis]) * half[axis];
                t += up[axis] * p[axis] + Math.abs(up[axis]) * half[axis];
            }
            assertThat((double) shares.getFloat()).isCloseTo(s / 0.5, within(1e-6));
            assertThat((double) shares.getFloat()).isCloseTo(1 - t / 0.5, within(1e-6));
        }
    }

    /** The faces of a mesh with texture coordinates take these; the others are plain. */
    @Test
    void aMeshIsPlacedByItsTextureCoordinates() throws IOException {
        byte[] glb = written(POSTER.withMaterial(Material.DEFAULT.withTexture(PICTURE)));
        String json = json(glb);
        ByteBuffer shares = accessor(glb, number(json, "\"TEXCOORD_0\":"));
        float[] found = new float[6];
        shares.asFloatBuffer().get(found);
        assertThat(found).containsExactly(0, 1, 1, 1, 1, 0);
        assertThat(json.split("TEXCOORD_0", -1)).hasSize(2);
        assertThat(json.split("\"POSITION\"", -1)).hasSize(3);
    }

    @Test
    void aRoundMantleGoesAroundAndUp() {
        GlbShape cylinder = GlbShape.cylinder(2, 3);
        float[] points = cylinder.points();
        double[] places = cylinder.places();
        float[] normals = cylinder.normals();
        int sides = 0;
        for (int k = 0; 3 * k < points.length; k++) {
            if (normals != null && normals[3 * k + 1] == 0) {
                double s = places[2 * k];
                assertThat(2 * Math.cos(s / 2)).isCloseTo(points[3 * k], within(1e-6));
                assertThat(-2 * Math.sin(s / 2)).isCloseTo(points[3 * k + 2], within(1e-6));
                assertThat(places[2 * k + 1]).isCloseTo(points[3 * k + 1] + 1.5, within(1e-6));
                sides++;
            }
        }
        assertThat(sides).isEqualTo(98);
        GlbShape capsule = GlbShape.capsule(2, 3);
        double[] on = capsule.places();
        assertThat(on[1]).isZero();
        assertThat(on[on.length - 1]).isCloseTo(2 * Math.PI + 3, within(1e-12));
    }

    private static double[] three(ByteBuffer in) {
        return new double[] {in.getFloat(), in.getFloat(), in.getFloat()};
    }

    private static ByteBuffer accessor(byte[] glb, int number) {
        Matcher accessors =
                Pattern.compile("\\{\"bufferView\":(\\d+),\"componentType\"").matcher(json(glb));
        for (int k = 0; k <= number; k++) {
            assertThat(accessors.find()).isTrue();
        }
        return view(glb, Integer.parseInt(accessors.group(1)));
    }
}
