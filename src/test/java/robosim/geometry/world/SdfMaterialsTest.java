package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.image.PngWriter;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;

/** The materials of visuals, for the collisions beside them. */
class SdfMaterialsTest {
    private static final String BALL = "<geometry><sphere><radius>1</radius></sphere></geometry>";

    @TempDir
    Path folder;

    private WorldImport read(String link, boolean isStatic) throws IOException {
        Path file = folder.resolve("t.sdf");
        Files.writeString(
                file,
                "<sdf version=\"1.9\"><world name=\"w\"><model name=\"m\"><static>" + isStatic
                        + "</static><link name=\"l\">" + link + "</link></model></world></sdf>");
        return SdfReader.read(file, List.of());
    }

    private static String collision(String name) {
        return "<collision name=\"" + name + "\">" + BALL + "</collision>";
    }

    private static String visual(String name, String inside) {
        return "<visual name=\"" + name + "\">" + BALL + inside + "</visual>";
    }

    private static String material(String inside) {
        return "<material><ambient>1 1 1 1</ambient>" + inside + "<script><name>Gazebo/Grey</name></script></material>";
    }

    private GeometryObject object(String link) throws IOException {
        return read(link, true).world().objects().get(0).object();
    }

    @Test
    void readsTheColorsOfAVisual() throws IOException {
        String all = material("<diffuse>0.25 .5 1 0.5</diffuse><specular>0.1 0.75 0 1</specular>"
                + "<emissive>0 0 1.5</emissive><shininess>30</shininess>");
        Material material = object(collision("c") + visual("v", all)).material();
        assertThat(material)
                .isEqualTo(Material.of(new Color(0.25, 0.5, 1))
                        .withSpecular(0.75)
                        .withShininess(30)
                        .withEmission(new Color(0, 0, 1)));
        WorldImport read = read(collision("c") + visual("v", all), true);
        assertThat(read.passedOver()).isEqualTo(java.util.Map.of("visual", 1));
        assertThat(read.isWhole()).isTrue();
        assertThat(read.world().objects().get(0).color()).isEqualTo("#4080ff");
        assertThat(object(collision("c") + visual("v", "")).material().isDefault())
                .isTrue();
        assertThat(object(collision("c") + visual("v", material(""))).material())
                .as("Gazebo/Grey")
                .isEqualTo(Material.of(Color.parse("#b3b3b3")));
        assertThat(object(collision("c")).material().isDefault()).isTrue();
    }

    @Test
    void eachCollisionHasThatOfItsName() throws IOException {
        String red = material("<diffuse>1 0 0</diffuse>");
        String blue = material("<diffuse>0 0 1</diffuse>");
        ObjectGroup group = (ObjectGroup) read(
                        visual("a", "")
                                + visual("b", red)
                                + visual("c", blue)
                                + collision("c")
                                + collision("a")
                                + collision("other"),
                        false)
                .world()
                .objects()
                .get(0)
                .object();
        assertThat(group.members())
                .extracting(member -> member.material().color().toString())
                .containsExactly("#0000ff", "#ff0000", "#ff0000");
        assertThat(group.material().isDefault()).isTrue();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            <diffuse>1 0</diffuse>         | <diffuse> must be 4 numbers (got: 2)
            <diffuse>red green blue</diffuse> | <diffuse>: a number must be decimal
            <emissive/>                    | <emissive> must be 4 numbers (got: none)
            <shininess>1 2</shininess>     | <shininess> must be 1 number (got: 2)
            """)
    void whatIsNoColorCostsTheColorAlone(String inside, String message) throws IOException {
        WorldImport read = read(collision("c") + visual("v", material(inside)), true);
        assertThat(read.isWhole()).isFalse();
        assertThat(read.skipped()).singleElement().satisfies(skipped -> {
            assertThat(skipped.what()).startsWith("<material> of ");
            assertThat(skipped.reason()).contains(message);
            assertThat(skipped.line()).isEqualTo(1);
        });
        assertThat(read.world().objects().get(0).object().material().isDefault())
                .isTrue();
    }

    /** As models lie in folders: a mesh, its library, and the picture beside its folder; mirrored by its scale. */
    @Test
    void aMeshBringsItsOwn() throws IOException {
        Files.createDirectories(folder.resolve("textures"));
        Files.createDirectories(folder.resolve("meshes"));
        ImageTexture image = new ImageTexture(2, 1, new int[] {0x102030, 0x405060}, 1, 1);
        try (OutputStream out = Files.newOutputStream(folder.resolve("textures/t.png"))) {
            PngWriter.writeColour(out, 2, 1, image.pixels());
        }
        Files.writeString(folder.resolve("meshes/m.mtl"), "newmtl a\nmap_Kd ../textures/t.png\n");
        Files.writeString(
                folder.resolve("meshes/m.obj"),
                "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl a\n"
                        + "f 1/1 2/2 3/3 4/4\nf 1/1 2/2 3/3\n");
        for (String scale : List.of("1 1 1", "-1 1 1")) {
            MeshObject mesh = (MeshObject) object("<collision name=\"c\"><geometry><mesh><uri>meshes/m.obj</uri><scale>"
                    + scale + "</scale></mesh></geometry></collision>");
            assertThat(mesh.material()).isEqualTo(Material.DEFAULT.withTexture(image));
            for (int t = 0; t < mesh.triangles().size(); t++) {
                for (int k = 0; k < 3; k++) {
                    int vertex = mesh.triangles().vertex(t, k);
                    // X is forward in both, and the file's Y is the other way along our Z.
                    assertThat(mesh.triangles().textured(t, k, 0))
                            .isEqualTo(Math.abs(mesh.triangles().coordinate(vertex, 0)));
                    assertThat(mesh.triangles().textured(t, k, 1))
                            .isEqualTo(-mesh.triangles().coordinate(vertex, 2) + 0.0);
                }
            }
        }
    }

    private Path picture(String name) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        try (OutputStream out = Files.newOutputStream(file)) {
            PngWriter.writeColour(out, 2, 1, new int[] {0xff0000, 0x00ff00});
        }
        return file;
    }

    private static String metal(String inside) {
        return "<material><diffuse>0.5 0.5 0.5 1</diffuse><pbr><metal>" + inside + "</metal></pbr></material>";
    }

    private static String shown(String shape, String material) {
        return collision("c") + "<visual name=\"v\"><geometry>" + shape + "</geometry>" + material + "</visual>";
    }

    @Test
    void aPictureOfColorsCoversAShapeOnce() throws IOException {
        picture("textures/a.png");
        String map = metal("<albedo_map>textures/a.png</albedo_map>");
        double[][] tiles = {{3, 4}, {5, 4}, {3, 5}};
        String[] boxes = {"3 4 0.1", "0.1 5 4", "3 0.1 5"}; // x y z of SDFormat
        for (int k = 0; k < boxes.length; k++) {
            ImageTexture seen = seen(shown("<box><size>" + boxes[k] + "</size></box>", map));
            assertThat(seen.pixel(0, 0)).isEqualTo(0xff0000);
            assertThat(new double[] {seen.tileWidth(), seen.tileHeight()}).containsExactly(tiles[k]);
        }
        ImageTexture ball = seen(shown("<sphere><radius>2</radius></sphere>", map));
        assertThat(ball.tileWidth()).isEqualTo(4 * Math.PI);
        assertThat(ball.tileHeight()).isEqualTo(2 * Math.PI);
    }

    private ImageTexture seen(String link) throws IOException {
        return (ImageTexture) object(link).visuals().get(0).material().texture();
    }

    @Test
    void aPictureOfColorsIsPlacedByTheCornersOfAMesh() throws IOException {
        picture("textures/a.png");
        Files.writeString(
                folder.resolve("m.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
        String mesh = "<mesh><uri>m.obj</uri></mesh>";
        GeometryObject plain = object(shown(mesh, "")).visuals().get(0);
        assertThat(((MeshObject) plain).textureCoordinates()).isNull();
        GeometryObject seen = object(shown(mesh, metal("<albedo_map>textures/a.png</albedo_map>")))
                .visuals()
                .get(0);
        assertThat(((MeshObject) seen).textureCoordinates()).isNotNull();
    }

    @Test
    void metalIsAsRoughAsThatOfGltf() throws IOException {
        Material made = object(shown(
                        "<box><size>1 1 1</size></box>",
                        metal("<roughness>0.25</roughness><metalness>0.8</metalness>")))
                .visuals()
                .get(0)
                .material();
        assertThat(made)
                .isEqualTo(Material.of(new Color(0.5, 0.5, 0.5))
                        .withShininess(2 / Math.pow(0.25, 4) - 2)
                        .withMirror(0.8 * 0.75));
        Material usual = object(shown("<box><size>1 1 1</size></box>", metal("")))
                .visuals()
                .get(0)
                .material();
        assertThat(usual).isEqualTo(Material.of(new Color(0.5, 0.5, 0.5)).withShininess(30));
    }

    @Test
    void aMissingPictureIsToldAndThePlainColorSeen() throws IOException {
        WorldImport read =
                read(shown("<box><size>1 1 1</size></box>", metal("<albedo_map>gone.png</albedo_map>")), true);
        assertThat(read.isWhole()).isTrue();
        assertThat(read.world()
                        .objects()
                        .get(0)
                        .object()
                        .visuals()
                        .get(0)
                        .material()
                        .color())
                .isEqualTo(new Color(0.5, 0.5, 0.5));
        assertThat(read.remarks())
                .singleElement()
                .asString()
                .contains("1 visual is seen in a plain colour", "gone.png");
    }

    @ParameterizedTest
    @CsvSource({
        "Gazebo/RedGlow, #ff0000, #ff0000",
        "Gazebo/BlueTransparent, #0000ff, #000000",
        "Gazebo/Red, #ff0000, #000000"
    })
    void scriptsThatGlowOrAreTransparent(String name, String color, String emission) throws IOException {
        Material made = object(
                        collision("c") + visual("v", "<material><script><name>" + name + "</name></script></material>"))
                .material();
        assertThat(made).isEqualTo(Material.of(Color.parse(color)).withEmission(Color.parse(emission)));
    }
}
