package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Objects;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.image.PngWriter;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;

/** Materials of world files. */
class MaterialFilesTest {
    private static final String OPEN =
            "<world xmlns=\"urn:robosim:world:1\" width=\"9\" height=\"9\" length=\"9\" unit=\"m\">";

    private static final int[] PIXELS = {0xff0000, 0x00ff00, 0x0000ff, 0xffffff, 0x000000, 0x123456};

    @TempDir
    Path folder;

    private World read(String content) throws WorldException {
        return WorldReader.read(
                new ByteArrayInputStream((OPEN + content + "</world>").getBytes(StandardCharsets.UTF_8)),
                "t.xml",
                folder);
    }

    private GeometryObject object(String content) throws WorldException {
        return read(content).objects().get(0).object();
    }

    private void picture(String name) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        try (OutputStream out = Files.newOutputStream(file)) {
            PngWriter.writeColour(out, 3, 2, PIXELS);
        }
    }

    @Test
    void readsAllThatAMaterialCanSay() throws IOException {
        picture("textures/brick.png");
        World world = read("""
                <material name="a" color="#ff8000" diffuse=".9" specular="0.5" shininess="40" mirror="0.125"
                          emission="0.1 0 1e-3" reflectance="1" label="7"/>
                <material name="b"><checker first="#000000" second="1 1 1" size="25cm"/></material>
                <material name="c" color="0.25 .5 1"><stripes first="#ffffff" second="#102030" size="1" degrees="-45"/></material>
                <material name="d"><image file="textures/brick.png" width="2" height="50cm"/></material>
                <material name="e"><image columns="3" rows="2">ff0000 00FF00 0000ff ffffff
                    000000 123456</image></material>
                <material name="f"/>
                <box material="a" width="1" height="1" length="1"/>
                <cylinder material="b" radius="1" height="1"/>
                <sphere material="c" radius="1" color="#010203"/>
                <capsule material="d" radius="1" segment="1"/>
                <group material="e"><box width="1" height="1" length="1" material="d"/><sphere radius="1" color="#0000ff"/>
                    <sphere radius="1"/></group>
                <grid material="a" cell="1" height="1" columns="1" rows="1">0 1</grid>
                <box material="f" width="1" height="1" length="1"/>
                """);
        Material a = Material.of(Color.parse("#ff8000"))
                .withDiffuse(0.9)
                .withSpecular(0.5)
                .withShininess(40)
                .withMirror(0.125)
                .withEmission(new Color(0.1, 0, 1e-3))
                .withReflectance(1)
                .withLabel(7);
        assertThat(material(world, 0)).isEqualTo(a);
        assertThat(material(world, 1))
                .isEqualTo(Material.DEFAULT.withTexture(new Texture.Checker(Color.BLACK, Color.WHITE, 0.25)));
        assertThat(material(world, 2))
                .isEqualTo(Material.of(new Color(0.25, 0.5, 1))
                        .withTexture(new Texture.Stripes(Color.WHITE, Color.parse("#102030"), 1, -45)));
        assertThat(world.objects().get(2).color()).isEqualTo("#010203");
        ImageTexture image = new ImageTexture(3, 2, PIXELS, 2, 0.5);
        assertThat(material(world, 3)).isEqualTo(Material.DEFAULT.withTexture(image));
        assertThat(material(world, 4)).isEqualTo(Material.DEFAULT.withTexture(image.tiled(1, 1)));
        ObjectGroup group = (ObjectGroup) world.objects().get(4).object();
        assertThat(group.members())
                .extracting(GeometryObject::material)
                .containsExactly(
                        Material.DEFAULT.withTexture(image), Material.of(Color.parse("#0000ff")), Material.DEFAULT);
        assertThat(material(world, 5)).isEqualTo(a);
        assertThat(world.objects().get(5).color()).as("the viewer shows it too").isEqualTo("#ff8000");
        assertThat(material(world, 6).isDefault()).isTrue();
        World again = WorldReader.read(
                new ByteArrayInputStream(WorldWriter.toXml(world).getBytes(StandardCharsets.UTF_8)), "again.xml", null);
        assertThat(again).isEqualTo(world);
        assertThat(WorldWriter.toXml(again)).isEqualTo(WorldWriter.toXml(world));
    }

    private static Material material(World world, int index) {
        return world.objects().get(index).object().material();
    }

    @Test
    void theExamplesOfThePageAreRead() throws IOException {
        picture("textures/brick.png");
        String page = Files.readString(Path.of("docs", "world-format.md"));
        String section = page.substring(page.indexOf("### Materials"), page.indexOf("### Meshes"));
        String[] blocks = section.split("```(xml)?\n", -1);
        World world = read(blocks[1] + blocks[3]);
        assertThat(world.objects()).hasSize(3);
        assertThat(material(world, 1).label()).isEqualTo(3);
        MeshObject poster = (MeshObject) world.objects().get(2).object();
        assertThat(poster.material().texture()).isEqualTo(new ImageTexture(2, 1, new int[] {0xff0000, 0x0000ff}, 2, 1));
        assertThat(poster.triangles().isTextured(1)).isTrue();
    }

    @Test
    void aColorIsAMaterialToo() throws IOException {
        World world = read("<box color=\"#FF8000\" width=\"1\" height=\"1\" length=\"1\"/>");
        assertThat(material(world, 0)).isEqualTo(Material.of(Color.parse("#ff8000")));
        assertThat(world.objects().get(0).color()).isEqualTo("#ff8000");
        assertThat(WorldWriter.toXml(world)).contains("color=\"#ff8000\"").doesNotContain("material");
        assertThat(read("<box width=\"1\" height=\"1\" length=\"1\"/>")
                        .objects()
                        .get(0)
                        .color())
                .isNull();
    }

    @Test
    void meshesHaveTextureCoordinates() throws IOException {
        String mesh = "<mesh><vertices>0 0 0 1 0 0 0 1 0 0 0 1</vertices><quads>0 1 2 3</quads>"
                + "<triangles>0 1 2</triangles>%s</mesh>";
        World world = read(mesh.formatted("<uv>0 0 1 0 .5 -2</uv><corners>0 1 2 0 -1 -1 -1</corners>"));
        MeshObject read = (MeshObject) world.objects().get(0).object();
        assertThat(read.textureCoordinates())
                .isEqualTo(
                        new TextureCoordinates(new double[] {0, 0, 1, 0, 0.5, -2}, new int[] {0, 1, 2, 0, -1, -1, -1}));
        assertThat(read(WorldWriter.toXml(world)
                        .replaceFirst("(?s).*<world [^>]*>", "")
                        .replace("</world>", "")))
                .extracting(World::objects)
                .isEqualTo(world.objects());
        assertThatThrownBy(() -> read(mesh.formatted("<uv>0 0</uv><corners>0 0 0 0 0 0</corners>")))
                .hasMessageContaining("corners must have one index for each corner of the 2 faces, 7 (got: 6)");
        assertThatThrownBy(() -> read(mesh.formatted("<uv>0 0</uv><corners>0 0 0 1 0 0 0</corners>")))
                .hasMessageContaining("corners[3] must be -1 or one of the 1 points");
        assertThatThrownBy(() -> read(mesh.formatted("<uv>0 0 1</uv><corners>0 0 0 0 0 0 0</corners>")))
                .hasMessageContaining("points must have two numbers each (got: 3 numbers)");
        assertThatThrownBy(() -> read(mesh.formatted("<uv>0 0</uv>"))).hasMessageContaining("<corners>");
    }

    /** Placements of one picture share its pixels, as those of one mesh share its triangles. */
    @Test
    void aFileIsReadOnce() throws IOException {
        picture("a.png");
        World world = read("<material name=\"a\"><image file=\"a.png\"/></material>"
                + "<material name=\"b\"><image file=\"./a.png\"/></material>"
                + "<box material=\"a\" width=\"1\" height=\"1\" length=\"1\"/>"
                + "<box material=\"b\" width=\"1\" height=\"1\" length=\"1\"/>");
        assertThat(material(world, 0)).isEqualTo(material(world, 1));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            <box material="x" width="1" height="1" length="1"/>      | material must be the name of a <material> at the beginning of the world (got: x)
            <material name="x" diffuse="1.5"/>                       | t.xml:1:111: <material>: diffuse must be a number from 0 to 1 (got: 1.5)
            <material name="x" mirror="-1"/>                         | mirror of <material> must be a number above 0
            <material name="x" shininess="0.5"/>                     | <material>: shininess must be a number from 1 to 1000000 (got: 0.5)
            <material name="x" color="red"/>                         | color of <material> must be # and six hexadecimal digits, like #cc8800, or three numbers from 0 to 1
            <material name="x" color="1 1 2"/>                       | <material>: color: blue must be a number from 0 to 1 (got: 2.0)
            <material name="x" label="-1"/>                          | label of <material> must be a whole number of at least 0 (got: -1)
            <material/>                                              | <material> needs the attribute name
            <material name="x"/><material name="x"/>                 | <material>: materials must have names of their own (got twice: x)
            <material name="x"><checker first="#000000" second="#ffffff" size="0"/></material> | <checker>: size must be a number above 0
            <material name="x"><checker first="#000000" size="1"/></material> | <checker> needs the attribute second
            <material name="x"><image/></material>                   | <image>: an image must have either a file, or columns, rows and pixels (got: neither)
            <material name="x"><image file="a.png">ffffff</image></material> | (got: both)
            <material name="x"><image columns="2" rows="2">ffffff</image></material> | pixels must have one number for each of 2 x 2 (got: 1)
            <material name="x"><image columns="99999" rows="99999">ffffff</image></material> | at most 67108864 pixels (got: 99999 x 99999)
            <material name="x"><image columns="1" rows="1">fffff</image></material> | <image>: a pixel must be six hexadecimal digits, rrggbb (got: fffff)
            <material name="x"><image file="no.png"/></material>     | there is no such picture in
            <material name="x"><image file="../no.png"/></material>  | there is no such picture in
            <material name="x"><image file="/etc/passwd"/></material> | a picture must be a path with / relative to the file that names it (got: /etc/passwd)
            <material name="x"><image file="t.txt"/></material>      | the picture could not be read; save it as PNG
            <material name="x"><image file="a.png" width="0"/></material> | tileWidth must be a number above 0
            <box width="1" height="1" length="1"/><material name="x"/> | <material> is not allowed in <world>
            """)
    void whatIsWrongIsRefused(String content, String message) throws IOException {
        picture("a.png");
        Files.writeString(folder.resolve("t.txt"), "this is not a picture at all, whatever its name is");
        assertThatThrownBy(() -> read(content))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining(message);
    }

    /** A PNG of 2^32 pixels, and one of 2^26 that ends behind its header. */
    @Test
    void aPictureIsNotBelievedBeforeItIsDecoded() throws IOException {
        byte[] bytes = png();
        Path file = folder.resolve("bomb.png");
        String content = "<material name=\"x\"><image file=\"bomb.png\"/></material>";
        Files.write(file, withSize(bytes, 1 << 16, 1 << 16));
        assertThatThrownBy(() -> read(content))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining(
                        "bomb.png: width and height must be at least 1, and their product at most 67108864"
                                + " pixels (got: 65536 x 65536)");
        Files.write(file, withSize(bytes, -1, 1));
        assertThatThrownBy(() -> read(content)).hasMessageContaining("(got: 4294967295 x 1)");
        Files.write(file, withSize(bytes, 1 << 13, 1 << 13));
        assertThatThrownBy(() -> read(content))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("the picture could not be read; save it as PNG");
    }

    /** JPEG loses a little of each colour; a single one of 8 x 8 pixels nothing but rounding. */
    @Test
    void jpegIsReadToo() throws IOException {
        BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB);
        BufferedImage grey = new BufferedImage(8, 8, BufferedImage.TYPE_BYTE_GRAY);
        for (int k = 0; k < 64; k++) {
            image.setRGB(k % 8, k / 8, 0xc08040);
            grey.getRaster().setSample(k % 8, k / 8, 0, 100);
        }
        assertThat(ImageIO.write(image, "jpeg", folder.resolve("c.jpg").toFile()))
                .isTrue();
        assertThat(ImageIO.write(grey, "jpeg", folder.resolve("g.jpg").toFile()))
                .isTrue();
        World world = read("<material name=\"c\"><image file=\"c.jpg\"/></material>"
                + "<material name=\"g\"><image file=\"g.jpg\"/></material>"
                + "<box material=\"c\" width=\"1\" height=\"1\" length=\"1\"/>"
                + "<box material=\"g\" width=\"1\" height=\"1\" length=\"1\"/>");
        int pixel = pixel(material(world, 0));
        assertThat(pixel >> 16).isBetween(0xbe, 0xc2);
        assertThat(pixel >> 8 & 0xff).isBetween(0x7e, 0x82);
        assertThat(pixel & 0xff).isBetween(0x3e, 0x42);
        assertThat(pixel(material(world, 1))).isEqualTo(100 * 0x010101);

        byte[] bytes = Files.readAllBytes(folder.resolve("c.jpg"));
        Files.write(folder.resolve("c.jpg"), Arrays.copyOf(bytes, bytes.length / 2));
        assertThatThrownBy(() -> read("<material name=\"c\"><image file=\"c.jpg\"/></material>"))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("c.jpg: the picture could not be read; save it as PNG");
        int frame = 0;
        while ((bytes[frame] & 0xff) != 0xff || (bytes[frame + 1] & 0xff) != 0xc0) {
            frame++;
        }
        ByteBuffer.wrap(bytes, frame + 5, 4).putShort((short) 60_000).putShort((short) 60_000);
        Files.write(folder.resolve("c.jpg"), bytes);
        assertThatThrownBy(() -> read("<material name=\"c\"><image file=\"c.jpg\"/></material>"))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("at most 67108864 pixels (got: 60000 x 60000)");
    }

    private static int pixel(Material material) {
        return ((ImageTexture) Objects.requireNonNull(material.texture())).pixel(3, 3);
    }

    private static byte[] png() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PngWriter.writeColour(out, 3, 2, PIXELS);
        return out.toByteArray();
    }

    private static byte[] withSize(byte[] png, int width, int height) {
        byte[] changed = png.clone();
        ByteBuffer.wrap(changed, 16, 8).putInt(width).putInt(height);
        CRC32 sum = new CRC32();
        sum.update(changed, 12, 17);
        ByteBuffer.wrap(changed, 29, 4).putInt((int) sum.getValue());
        return changed;
    }

    @Test
    void picturesAreLimitedTogether() throws IOException {
        // Many small files: no one of them is above the limit.
        StringBuilder content = new StringBuilder();
        byte[] empty = withSize(png(), 1 << 13, 1 << 13);
        Files.write(folder.resolve("a.png"), png());
        Files.write(folder.resolve("b.png"), empty);
        content.append("<material name=\"a\"><image file=\"a.png\"/></material>");
        content.append("<material name=\"b\"><image file=\"b.png\"/></material>");
        assertThatThrownBy(() -> read(content.toString()))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining(
                        "the pictures of a world must have at most 67108864 pixels together; make them smaller (got: 67108870)");
    }

    @Test
    void aStreamWithoutAFolderReadsNoFile() {
        String xml = OPEN + "<material name=\"x\"><image file=\"a.png\"/></material></world>";
        assertThatThrownBy(() ->
                        WorldReader.read(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "t.xml", null))
                .hasMessageContaining("give the pixels inline (got: a.png)");
    }
}
