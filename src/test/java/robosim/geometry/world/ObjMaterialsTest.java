package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.image.PngWriter;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.material.Material;
import robosim.geometry.material.Texture;
import robosim.geometry.material.TextureCoordinates;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Materials and texture coordinates of OBJ files and their MTL files, read and written. */
class ObjMaterialsTest {
    private static final String SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n";
    private static final ImageTexture IMAGE = new ImageTexture(2, 1, new int[] {0xff0000, 0x0000ff}, 1, 1);

    @TempDir
    Path folder;

    private void file(String name, String text) throws IOException {
        Files.createDirectories(folder.resolve(name).getParent());
        Files.writeString(folder.resolve(name), text);
    }

    private void picture(String name) throws IOException {
        Files.createDirectories(folder.resolve(name).getParent());
        try (OutputStream out = Files.newOutputStream(folder.resolve(name))) {
            PngWriter.writeColour(out, IMAGE.width(), IMAGE.height(), IMAGE.pixels());
        }
    }

    private MeshObject read(String mtl, String obj) throws IOException {
        file("m.mtl", mtl);
        file("m.obj", "mtllib m.mtl\n" + SQUARE + obj);
        return WorldReader.readMesh(folder.resolve("m.obj"));
    }

    @Test
    void readsWhatAMaterialSays() throws IOException {
        Material material = read("""
                # of a program
                Kd 1 1 1
                newmtl other
                Kd 0 1 0
                newmtl a name with spaces
                \tKa 0.1 0.1 0.1
                Kd 0.25 0.5 1.5
                Ks 0.1 0.75 0.2 # beside it
                Ns 96.5
                Ke 0.5
                d 1.0
                illum 2
                map_Bump -bm 0.5 bump.png
                """, "usemtl a name with spaces\nf 1 2 3\n").material();
        assertThat(material)
                .isEqualTo(Material.of(new Color(0.25, 0.5, 1))
                        .withSpecular(0.75)
                        .withShininess(96.5)
                        .withEmission(new Color(0.5, 0.5, 0.5)));
    }

    @Test
    void whatIsNotThereIsTheDefault() throws IOException {
        assertThat(read("newmtl a\nKd 1 0 0\n", "usemtl b\nf 1 2 3\n")
                        .material()
                        .isDefault())
                .isTrue();
        assertThat(read("newmtl a\nKd 1 0 0\n", "usemtl\nf 1 2 3\n").material().isDefault())
                .isTrue();
        file("m.obj", "mtllib none.mtl ../../m.mtl\n" + SQUARE + "usemtl a\nf 1 2 3\n");
        assertThat(WorldReader.readMesh(folder.resolve("m.obj")).material().isDefault())
                .isTrue();
        byte[] bytes = ("mtllib m.mtl\n" + SQUARE + "usemtl a\nf 1 2 3\n").getBytes(StandardCharsets.UTF_8);
        assertThat(WorldReader.readMesh(new ByteArrayInputStream(bytes), "m.obj", 1)
                        .material()
                        .isDefault())
                .isTrue();
        assertThat(read("newmtl a\nNs 0\n", "usemtl a\nf 1 2 3\n").material().shininess())
                .isEqualTo(1);
    }

    @Test
    void severalLibrariesAndNamesWithSpaces() throws IOException {
        file("a b.mtl", "newmtl x\nKd 1 0 0\n");
        file("c.mtl", "newmtl x\nKd 0 1 0\nnewmtl \u00fc\nKd 0 0 1\n");
        file("m.obj", "mtllib a b.mtl\nmtllib no.mtl c.mtl\n" + SQUARE + "usemtl x\nf 1 2 3\n");
        assertThat(WorldReader.readMesh(folder.resolve("m.obj")).material().color())
                .isEqualTo(new Color(1, 0, 0));
        file("m.obj", "mtllib c.mtl\n" + SQUARE + "usemtl \u00fc\nf 1 2 3\n");
        assertThat(WorldReader.readMesh(folder.resolve("m.obj")).material().color())
                .isEqualTo(new Color(0, 0, 1));
    }

    @Test
    void textureCoordinatesBelongToCorners() throws IOException {
        picture("m.png");
        MeshObject mesh = read("newmtl a\nmap_Kd m.png\n", """
                vt 0 0
                vt 1 0 0.5
                vt 1 1
                vt 0.25
                vt nan 0
                usemtl a
                f 1/1 2/2/7 3/3 4/-2
                f 1/1 2/2 5/5
                f 1/1 2//1 5/1
                f 1/1 2/2 5/99
                f 1 2 5
                """);
        assertThat(mesh.material()).isEqualTo(Material.DEFAULT.withTexture(IMAGE));
        assertThat(mesh.textureCoordinates())
                .isEqualTo(new TextureCoordinates(
                        new double[] {0, 0, 1, 0, 1, 1, 0.25, 0, 0, 0},
                        new int[] {0, 1, 2, 3, 0, 1, -1, 0, -1, 0, 0, 1, -1, -1, -1, -1}));
        assertThat(mesh.faces()).isDeepEqualTo(new int[][] {{0, 1, 2, 3}, {0, 1, 4}, {0, 1, 4}, {0, 1, 4}, {0, 1, 4}});
    }

    /** A pentagon whose hole is joined by an edge that is used twice, so that two corners have one vertex and two points. */
    @Test
    void aPolygonIsCutWithItsTextureCoordinates() throws IOException {
        picture("m.png");
        StringBuilder obj = new StringBuilder("mtllib m.mtl\n");
        double[][] corners = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {2, 2}, {2, 4}, {4, 4}, {4, 2}};
        for (double[] corner : corners) {
            obj.append("v ").append(corner[0]).append(' ').append(corner[1]).append(" 0\n");
        }
        int[] outline = {1, 2, 3, 4, 1, 5, 6, 7, 8, 5};
        for (int k = 0; k < outline.length; k++) {
            double[] corner = corners[outline[k] - 1];
            obj.append("vt ")
                    .append(corner[0] / 6)
                    .append(' ')
                    .append(corner[1] / 6 + (k > 4 ? 10 : 0))
                    .append('\n');
        }
        obj.append("usemtl a\nf");
        for (int k = 0; k < outline.length; k++) {
            obj.append(' ').append(outline[k]).append('/').append(k + 1);
        }
        file("m.mtl", "newmtl a\nmap_Kd m.png\n");
        file("m.obj", obj + "\n");
        TriangleMesh triangles = WorldReader.readMesh(folder.resolve("m.obj")).triangles();
        assertThat(triangles.size()).isEqualTo(8);
        for (int t = 0; t < 8; t++) {
            assertThat(triangles.isTextured(t)).isTrue();
            for (int k = 0; k < 3; k++) {
                int vertex = triangles.vertex(t, k);
                assertThat(triangles.textured(t, k, 0)).isEqualTo(triangles.coordinate(vertex, 0) / 6);
                assertThat(triangles.textured(t, k, 1))
                        .isEqualTo(triangles.coordinate(vertex, 1) / 6 + (vertex < 4 ? 0 : 10));
            }
        }
    }

    @Test
    void severalColorsBecomeATexture() throws IOException {
        MeshObject mesh = read(
                "newmtl r\nKd 1 0 0\nKs .5 .5 .5\nnewmtl g\nKd 0 1 0\nnewmtl b\nKd 0 0 1\n",
                "vt 0 0\nusemtl g\nf 1/1 2/1 3/1 4/1\nusemtl r\nf 1 2 5\nf 2 3 5\nusemtl g\nusemtl r\nf 3 4 5\n");
        Material material = mesh.material();
        assertThat(material.specular()).as("of most faces").isEqualTo(0.5);
        ImageTexture palette = (ImageTexture) java.util.Objects.requireNonNull(material.texture());
        assertThat(palette.width()).isEqualTo(2);
        int[] expected = {0x00ff00, 0x00ff00, 0xff0000, 0xff0000, 0xff0000};
        for (int t = 0; t < 5; t++) {
            for (int k = 0; k < 3; k++) {
                double u = mesh.triangles().textured(t, k, 0) * palette.width();
                assertThat(u - Math.floor(u)).as("the middle of a pixel").isEqualTo(0.5);
                assertThat(palette.pixel((int) u, 0)).isEqualTo(expected[t]);
                assertThat(mesh.triangles().textured(t, k, 1)).isEqualTo(0.5);
            }
        }
        assertThat(read("newmtl r\nKd 1 0 0\nnewmtl s\nKd 1 0 0\n", "usemtl r\nf 1 2 3\nusemtl s\nf 1 2 4\n")
                        .material())
                .as("one colour")
                .isEqualTo(Material.of(new Color(1, 0, 0)));
    }

    @Test
    void facesWithoutThePictureAreOfTheirColor() throws IOException {
        picture("m.png");
        MeshObject mesh = read(
                "newmtl p\nmap_Kd m.png\nnewmtl c\nKd 0 1 0\n",
                "vt 0 0\nvt 1 1\nusemtl p\nf 1/1 2/1 3/2\nusemtl c\nf 1/1 2/2 5/1\nf 2/1 3/1 5/1\n");
        assertThat(mesh.material()).isEqualTo(Material.of(new Color(0, 1, 0)).withTexture(IMAGE));
        assertThat(mesh.triangles().isTextured(0)).isTrue();
        assertThat(mesh.triangles().isTextured(1)).isFalse();
        assertThat(mesh.triangles().isTextured(2)).isFalse();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            map_Kd no.png                        | m.mtl:2: map_Kd of material a: there is no such picture in
            map_Kd -clamp on -s 1 1 1 no file.png | (got: no file.png)
            map_Kd -o 1 no.png                   | (got: no.png)
            map_Kd                               | a picture must be a path with / relative to the file that names it (got: )
            map_Kd ../m.mtl/m.png                | there is no such picture
            map_Kd text.png                      | text.png: the picture could not be read; save it as PNG
            Kd 1 0                               | m.mtl:2: Kd must have three numbers, red, green and blue (got: 2)
            Kd red                               | m.mtl:2: a number must be decimal and finite, like 12, -0.5 or 1.5e-3 (got: red)
            Ns                                   | m.mtl:2: shininess must be a number from 1 to 1000000 (got: NaN)
            """)
    void whatIsWrongIsRefusedWithItsLine(String statement, String message) throws IOException {
        file("text.png", "no picture");
        assertThatThrownBy(() -> read("newmtl a\n" + statement + "\n", "usemtl a\nf 1 2 3\n"))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining(message);
    }

    /** What robots meet does not depend on it. */
    @Test
    void anImportLeavesOutAPictureByName() throws IOException {
        file("m.mtl", "newmtl a\nKd 1 0 0\nmap_Kd no.png\n");
        file("m.obj", "mtllib m.mtl\n" + SQUARE + "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
        WorldImport read = WorldImport.read(folder.resolve("m.obj"), ImportOptions.DEFAULT);
        assertThat(read.world().objects().get(0).object().material()).isEqualTo(Material.of(new Color(1, 0, 0)));
        assertThat(read.skipped()).hasSize(1);
        assertThat(read.skipped().get(0).toString())
                .contains("m.mtl:3: left out map_Kd of material a: there is no such picture in")
                .contains("(got: no.png)");
        file(
                "m.sdf",
                "<sdf version='1.9'><model name='m'><static>1</static><link name='l'><collision name='c'><geometry><mesh>"
                        + "<uri>m.obj</uri></mesh></geometry></collision></link></model></sdf>");
        WorldImport model = WorldImport.read(folder.resolve("m.sdf"), ImportOptions.DEFAULT);
        assertThat(model.world().objects().get(0).object().material()).isEqualTo(Material.of(new Color(1, 0, 0)));
        assertThat(model.skipped()).extracting(Skipped::what).containsExactly("map_Kd of material a");
    }

    /** Where Gazebo looks for it, too. */
    @Test
    void aPictureAmongTheTexturesOfAModel() throws IOException {
        picture("models/car/materials/textures/p.png");
        file("models/car/model.config", "<model><sdf>model.sdf</sdf></model>");
        file(
                "models/car/model.sdf",
                "<sdf version='1.6'><model name='m'><link name='l'><collision name='c'><geometry><mesh><uri>meshes/m.obj</uri>"
                        + "</mesh></geometry></collision></link></model></sdf>");
        file("models/car/meshes/m.obj", "mtllib m.mtl\n" + SQUARE + "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
        for (String name : List.of("p.png", "model://car/materials/textures/p.png")) {
            file("models/car/meshes/m.mtl", "newmtl a\nmap_Kd " + name + "\n");
            WorldImport read = WorldImport.read(
                    folder.resolve("models/car"), ImportOptions.DEFAULT.withModels(List.of(folder.resolve("models"))));
            assertThat(read.skipped()).isEmpty();
            assertThat(read.world().objects().get(0).object().material().texture())
                    .isInstanceOf(ImageTexture.class);
        }
        file("models/car/meshes/m.mtl", "newmtl a\nmap_Kd model://car/../../secret.png\n");
        picture("secret.png");
        assertThat(WorldImport.read(
                                folder.resolve("models/car"),
                                ImportOptions.DEFAULT.withModels(List.of(folder.resolve("models"))))
                        .skipped())
                .hasSize(1);
    }

    /** Programs for Windows write backslashes. */
    @Test
    void pathsMayHaveBackslashes() throws IOException {
        file("materials/m.mtl", "newmtl a\nKd 0 0 1\nmap_Kd -clamp on .\\m.png\n");
        picture("materials/m.png");
        file("m.obj", "mtllib .\\materials\\m.mtl\n" + SQUARE + "usemtl a\nf 1 2 3\n");
        assertThat(WorldReader.readMesh(folder.resolve("m.obj")).material().texture())
                .isNotNull();
    }

    @Test
    void aMaterialThatNobodyUsesNeedsNoPicture() throws IOException {
        assertThat(read("newmtl a\nmap_Kd no.png\nnewmtl b\nKd 0 0 1\n", "usemtl b\nf 1 2 3\n")
                        .material()
                        .color())
                .isEqualTo(new Color(0, 0, 1));
    }

    /** A world's folder, or a model's, is the tree in which its pictures may be. */
    @Test
    void aPictureBelowTheWorldMayBeBesideTheMesh() throws IOException {
        picture("textures/m.png");
        file("meshes/m.mtl", "newmtl a\nmap_Kd ../textures/m.png\n");
        file("meshes/m.obj", "mtllib m.mtl\n" + SQUARE + "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
        file(
                "w.xml",
                "<world xmlns='urn:robosim:world:1' width='9' height='9' length='9'><mesh file='meshes/m.obj'/>"
                        + "<mesh file='meshes/m.obj' color='#ff0000'/><mesh file='meshes/m.obj' center='1 0 0'/></world>");
        List<WorldObject> objects = WorldReader.read(folder.resolve("w.xml")).objects();
        MeshObject first = (MeshObject) objects.get(0).object();
        MeshObject red = (MeshObject) objects.get(1).object();
        assertThat(first.material()).isEqualTo(Material.DEFAULT.withTexture(IMAGE));
        assertThat(first.textureCoordinates()).isNotNull();
        assertThat(red.material()).isEqualTo(Material.of(new Color(1, 0, 0)));
        assertThat(red.textureCoordinates()).as("of no use without a picture").isNull();
        assertThat(((MeshObject) objects.get(2).object()).triangles()).isSameAs(first.triangles());
        assertThatThrownBy(() -> WorldReader.readMesh(folder.resolve("meshes/m.obj")))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("a picture must be below the folder of the file that is read; move it there"
                        + " (got: ../textures/m.png)");
    }

    @Test
    void worldsAreWrittenWithTheirMaterials() throws IOException {
        MeshObject poster = new MeshObject(
                        List.of(new Point(), new Point(2, 0, 0), new Point(2, 1, 0), new Point(0, 1, 0)),
                        new int[][] {{0, 1, 2, 3}, {0, 1, 2}})
                .withTextureCoordinates(
                        new TextureCoordinates(new double[] {0, 0, 1, 0, 1, 1, 0, 1}, new int[] {0, 1, 2, 3, 0, -1, 2}))
                .withMaterial(Material.DEFAULT.withTexture(IMAGE.tiled(2, 1)));
        GeometryObject box = new BoxObject(new Point(), 1, 1, 1);
        Material red = Material.of(Color.parse("#ff0000"))
                .withSpecular(0.5)
                .withShininess(50)
                .withMirror(0.5);
        Material checked = Material.DEFAULT
                .withTexture(new Texture.Checker(new Color(0, 1, 0), Color.BLACK, 1))
                .withEmission(new Color(0, 0, 1));
        ObjectGroup group = new ObjectGroup(List.of(box, box.withMaterial(checked))).withMaterial(red);
        List<WorldObject> objects =
                List.of(new WorldObject(box), new WorldObject(poster), new WorldObject(group), new WorldObject(poster));
        WorldWriter.writeObj(new World(9, 9, 9, objects), folder.resolve("a b.obj"), done -> {});
        assertThat(Files.readString(folder.resolve("a b.mtl"))).isEqualTo("""
                # materials of a b.obj
                newmtl material_1
                Kd 0.8 0.8 0.8
                Ks 0.1 0.1 0.1
                Ns 16
                illum 2
                newmtl material_2
                Kd 0.8 0.8 0.8
                Ks 0.1 0.1 0.1
                Ns 16
                illum 2
                map_Kd a b_1.png
                newmtl material_3
                Kd 1 0 0
                Ks 0.5 0.5 0.5
                Ns 50
                illum 3
                newmtl material_4
                Kd 0 1 0
                Ks 0.1 0.1 0.1
                Ns 16
                Ke 0 0 1
                illum 2
                """);
        String obj = Files.readString(folder.resolve("a b.obj"));
        assertThat(obj.lines().filter(line -> line.startsWith("usemtl") || line.startsWith("mtllib")))
                .containsExactly(
                        "mtllib a b.mtl",
                        "usemtl material_2",
                        "usemtl material_3",
                        "usemtl material_4",
                        "usemtl material_2");
        assertThat(obj.lines().filter(line -> line.contains("/")))
                .containsExactly("f 9/1 10/2 11/3 12/4", "f 9/1 10 11/3", "f 29/5 30/6 31/7 32/8", "f 29/5 30 31/7");
        MeshObject again = WorldReader.readMesh(folder.resolve("a b.obj"));
        assertThat(again.material().texture()).isEqualTo(IMAGE);
    }

    @Test
    void aWorldWithoutMaterialsIsOneFile() throws IOException {
        World world = new World(9, 9, 9, List.of(new WorldObject(new SphereObject(new Point(), 1))));
        WorldWriter.writeObj(world, folder.resolve("w.obj"), done -> {});
        assertThat(folder).isDirectoryContaining(file -> file.endsWith("w.obj"));
        assertThat(Files.exists(folder.resolve("w.mtl"))).isFalse();
        assertThat(Files.readString(folder.resolve("w.obj"))).doesNotContain("mtl");
    }
}
