package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.export.GlbWriter;
import robosim.geometry.image.PngWriter;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

/** Materials and pictures of glTF files, by others and by this module. */
class GltfMaterialsTest {
    private static final ImageTexture PICTURE =
            new ImageTexture(2, 2, new int[] {0xff0000, 0x00ff00, 0x0000ff, 0xffffff}, 1, 1);

    @TempDir
    Path folder;

    private static String uri(String type, byte[] bytes) {
        return "data:" + type + ";base64," + Base64.getEncoder().encodeToString(bytes);
    }

    /** A triangle with texture coordinates, made of the first of some materials. */
    private static String triangle(String materials) throws IOException {
        ByteBuffer numbers = ByteBuffer.allocate(60).order(ByteOrder.LITTLE_ENDIAN);
        for (float each : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 0}) {
            numbers.putFloat(each);
        }
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        PngWriter.writeColour(png, 2, 2, PICTURE.pixels());
        return ("{'asset':{'version':'2.0'},'scenes':[{'nodes':[0]}],'nodes':[{'mesh':0}],'meshes':[{'primitives':[{"
                        + "'attributes':{'POSITION':0,'TEXCOORD_0':1},'material':0}]}],'materials':[" + materials
                        + "],'textures':[{'source':0}],'images':[{'uri':'" + uri("image/png", png.toByteArray())
                        + "'}],'buffers':[{'byteLength':60,'uri':'" + uri("application/octet-stream", numbers.array())
                        + "'}],'bufferViews':[{'buffer':0,'byteLength':36},{'buffer':0,'byteOffset':36,'byteLength':24}],"
                        + "'accessors':[{'bufferView':0,'componentType':5126,'count':3,'type':'VEC3'},"
                        + "{'bufferView':1,'componentType':5126,'count':3,'type':'VEC2'}]}")
                .replace('\'', '"');
    }

    private MeshObject read(String materials) throws IOException {
        return MeshTriangles.read(Files.writeString(folder.resolve("t.gltf"), triangle(materials)));
    }

    @Test
    void colourLightRoughnessAndMetal() throws IOException {
        Material material = read("{'emissiveFactor':[0,1,0],'pbrMetallicRoughness':{'baseColorFactor':[0.5,0.25,1,1],"
                        + "'metallicFactor':0.5,'roughnessFactor':0.5}}")
                .material();
        assertThat(material)
                .hasToString(Material.of(Color.ofLinear(0.5, 0.25, 1))
                        .withEmission(Color.parse("#00ff00"))
                        .withShininess(30) // the square of the roughness is the square root of 2 / (n + 2)
                        .withMirror(0.25)
                        .toString());
    }

    /** What a file leaves out is white, rough and of metal, which mirrors as far as it is not rough. */
    @Test
    void whatIsLeftOut() throws IOException {
        Material rough = read("{'pbrMetallicRoughness':{}}").material();
        assertThat(rough)
                .hasToString(Material.of(Color.WHITE)
                        .withSpecular(0)
                        .withShininess(1)
                        .toString());
        assertThat(read("{'pbrMetallicRoughness':{'roughnessFactor':0.25}}")
                        .material()
                        .mirror())
                .isEqualTo(0.75);
        assertThat(read("{}").material().isDefault()).isTrue();
    }

    @Test
    void aPictureWithItsPlaces() throws IOException {
        MeshObject mesh = read("{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}");
        assertThat(mesh.material().texture()).isInstanceOf(ImageTexture.class);
        assertThat(((ImageTexture) mesh.material().texture()).pixels()).containsExactly(PICTURE.pixels());
        TextureCoordinates places = mesh.textureCoordinates();
        assertThat(places).isNotNull();
        // In glTF, the first row of a picture is at 0.
        assertThat(places.coordinate(places.corners()[0], 0)).isZero();
        assertThat(places.coordinate(places.corners()[0], 1)).isZero();
        assertThat(places.coordinate(places.corners()[1], 0)).isOne();
        assertThat(places.coordinate(places.corners()[2], 1)).isOne();
    }

    /** A picture that is not there costs nothing but itself. */
    @Test
    void theColourWithoutThePicture() throws IOException {
        Material material =
                read("{'pbrMetallicRoughness':{'baseColorFactor':[1,0,0,1],'baseColorTexture':{'index':3}}}")
                        .material();
        assertThat(material.color().packed()).isEqualTo(0xff0000);
        assertThat(material.texture()).isNull();
    }

    @Test
    void ourOwnFilesKeepColoursAndPictures() throws IOException {
        MeshObject poster = new MeshObject(
                        List.of(new Point(0, 0, 0), new Point(1, 0, 0), new Point(1, 1, 0), new Point(0, 1, 0)),
                        new int[][] {{0, 1, 2}, {0, 2, 3}})
                .withTextureCoordinates(
                        new TextureCoordinates(new double[] {0, 0, 1, 0, 1, 1, 0, 1}, new int[] {0, 1, 2, 0, 2, 3}));
        Material plain = Material.of(Color.parse("#3f6ea5")).withShininess(30).withEmission(Color.parse("#102030"));
        Material back = again(poster.withMaterial(plain)).material();
        assertThat(back.color().packed()).isEqualTo(0x3f6ea5);
        assertThat(back.emission().packed()).isEqualTo(0x102030);
        assertThat(Math.rint(back.shininess())).isEqualTo(30);
        assertThat(back.mirror()).isZero();
        MeshObject read = again(poster.withMaterial(Material.DEFAULT.withTexture(PICTURE)));
        assertThat(((ImageTexture) read.material().texture()).pixels()).containsExactly(PICTURE.pixels());
        TextureCoordinates places = read.textureCoordinates();
        assertThat(places).isNotNull();
        for (int k = 0; k < places.corners().length; k++) { // the poster shows the picture once
            Point corner = read.vertices().get(read.faces()[k / 3][k % 3]);
            assertThat(places.coordinate(places.corners()[k], 0)).isEqualTo(corner.x());
            assertThat(places.coordinate(places.corners()[k], 1)).isEqualTo(corner.y());
        }
    }

    private MeshObject again(MeshObject mesh) throws IOException {
        World world = new World(9, 9, 9, Unit.METRE, Dimension.SPATIAL, Accuracy.EXACT, List.of(new WorldObject(mesh)));
        Path file = folder.resolve("own.glb");
        GlbWriter.write(world, "world", file, done -> {});
        return MeshTriangles.read(file);
    }
}
