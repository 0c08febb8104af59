package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Effort;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

@Timeout(120)
class ColladaReaderTest {
    private static final String TRIANGLES =
            "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 2</p></triangles>";

    @TempDir
    Path folder;

    /** A file with the geometry g, of vertices at 1 0 0, 0 1 0, 0 0 1 and 1 1 0. */
    private static String dae(String asset, String primitives, String scene) {
        return "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\""
                + " version=\"1.4.1\"><asset>" + asset + "</asset>\n<library_geometries><geometry id=\"g\""
                + " name=\"shape\"><mesh><source id=\"s\"><float_array id=\"a\" count=\"12\">1 0 0 0 1 0 0 0 1\n1 1 0"
                + "</float_array><technique_common><accessor source=\"#a\" count=\"4\" stride=\"3\"/>"
                + "</technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#s\"/>"
                + "</vertices>\n" + primitives + "</mesh></geometry></library_geometries>\n" + scene
                + "</COLLADA>";
    }

    private static String scene(String nodes) {
        return "<library_visual_scenes><visual_scene id=\"w\">" + nodes + "</visual_scene></library_visual_scenes>"
                + "<scene><instance_visual_scene url=\"#w\"/></scene>";
    }

    private static String node(String transforms) {
        return "<node>" + transforms + "<instance_geometry url=\"#g\"/></node>";
    }

    private static MeshObject read(String text) throws IOException {
        return WorldReader.readMesh(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "t.dae", 1);
    }

    private static List<Point> placed(String transforms) throws IOException {
        return read(dae("", TRIANGLES, scene(node(transforms)))).vertices();
    }

    @Test
    void unitsAndTheAxisThatPointsUp() throws IOException {
        String plain = scene(node(""));
        assertThat(read(dae("", TRIANGLES, plain)).vertices())
                .containsExactly(new Point(1, 0, 0), new Point(0, 1, 0), new Point(0, 0, 1));
        assertThat(read(dae("<unit meter=\"0.25\"/><up_axis>Y_UP</up_axis>", TRIANGLES, plain))
                        .vertices())
                .containsExactly(new Point(0.25, 0, 0), new Point(0, 0.25, 0), new Point(0, 0, 0.25));
        assertThat(read(dae("<up_axis> Z_UP </up_axis>", TRIANGLES, plain)).vertices())
                .containsExactly(new Point(1, 0, 0), new Point(0, 0, -1), new Point(0, 1, 0));
        assertThat(read(dae("<up_axis>X_UP</up_axis>", TRIANGLES, plain)).vertices())
                .containsExactly(new Point(0, 1, 0), new Point(-1, 0, 0), new Point(0, 0, 1));
        Path file = Files.writeString(folder.resolve("t.dae"), dae("<unit meter=\"0.5\"/>", TRIANGLES, plain));
        assertThat(WorldReader.readMesh(file, 10).vertices().get(0)).isEqualTo(new Point(5, 0, 0));
    }

    /** Transforms apply from the last to the first, then those of the nodes around. */
    @Test
    void transforms() throws IOException {
        assertThat(placed("<translate>1 2 3</translate><scale>2 3 4</scale>"))
                .containsExactly(new Point(3, 2, 3), new Point(1, 5, 3), new Point(1, 2, 7));
        assertThat(placed("<rotate>0 0 2 90</rotate><translate>5 0 0</translate>"))
                .containsExactly(new Point(0, 6, 0), new Point(-1, 5, 0), new Point(0, 5, 1));
        assertThat(placed("<rotate>1 1 1 120</rotate>").get(0).y()).isCloseTo(1, within(1e-15));
        assertThat(placed("<matrix>0 -1 0 7 1 0 0 8 0 0 1 9\n0 0 0 1</matrix>"))
                .containsExactly(new Point(7, 9, 9), new Point(6, 8, 9), new Point(7, 8, 10));
        MeshObject nested = read(dae(
                "",
                TRIANGLES,
                scene("<node><translate>10 0 0</translate>" + node("<rotate>0 1 0 -90</rotate>") + "</node>")));
        assertThat(nested.vertices()).containsExactly(new Point(10, 0, 1), new Point(10, 1, 0), new Point(9, 0, 0));
    }

    @Test
    void aMirrorTurnsTheFaces() throws IOException {
        MeshObject mesh = read(dae(
                "",
                "<polylist><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><vcount>3 4</vcount>"
                        + "<p>0 1 2 0 3 1 2</p></polylist>",
                scene(node("<scale>-1 1 1</scale>"))));
        assertThat(mesh.vertices())
                .containsExactly(new Point(-1, 0, 0), new Point(0, 1, 0), new Point(0, 0, 1), new Point(-1, 1, 0));
        assertThat(mesh.faces()).isDeepEqualTo(new int[][] {{0, 2, 1}, {0, 2, 1, 3}});
    }

    @Test
    void primitives() throws IOException {
        String input = "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/>"
                + "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>";
        String scene = scene(node(""));
        for (String triangle : List.of(
                "<triangles>" + input + "<p>0 9 1 9 2 9</p></triangles>",
                "<polylist>" + input + "<p>0 9 1 9 2 9</p><vcount>3</vcount></polylist>",
                "<polygons>" + input + "<p>0 9 1 9 2 9</p></polygons>",
                "<tristrips>" + input + "<p>0 9 1 9 2 9</p></tristrips>",
                "<trifans>" + input + "<p>0 9 1 9 2 9</p></trifans>",
                "<lines>" + input + "<p>0 9 1 9</p></lines>" + TRIANGLES,
                "<polylist>" + input + "<vcount>1 2 3</vcount><p>3 9 3 9 1 9 0 9 1 9 2 9</p></polylist>")) {
            MeshObject mesh = read(dae("", triangle, scene));
            assertThat(mesh.faces()).as(triangle).isDeepEqualTo(new int[][] {{0, 1, 2}});
            assertThat(mesh.vertices()).containsExactly(new Point(1, 0, 0), new Point(0, 1, 0), new Point(0, 0, 1));
        }
        assertThat(read(dae("", "<tristrips>" + input + "<p>0 9 1 9 2 9 3 9</p></tristrips>", scene))
                        .faces())
                .isDeepEqualTo(new int[][] {{0, 1, 2}, {1, 3, 2}});
        assertThat(read(dae("", "<trifans>" + input + "<p>0 9 1 9 2 9 3 9</p></trifans>", scene))
                        .faces())
                .isDeepEqualTo(new int[][] {{0, 1, 2}, {0, 2, 3}});
        assertThat(read(dae("", TRIANGLES + TRIANGLES, scene)).faces()).hasDimensions(2, 3);
    }

    /** A bow tie of five corners is no polygon that can be cut; simulators draw a fan. */
    @Test
    void aPolygonThatCrossesItselfIsAFan() throws IOException {
        String text = dae(
                        "",
                        "<polygons><input semantic=\"VERTEX\" offset=\"0\"/><p>0 1 2 3 4</p></polygons>",
                        scene(node("")))
                .replace("1 0 0 0 1 0 0 0 1\n1 1 0", "0 0 0 2 2 0 2 0 0 0 2 0 1 5 0")
                .replace("count=\"4\"", "count=\"5\"");
        assertThat(read(text).faces()).isDeepEqualTo(new int[][] {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
    }

    @Test
    void instancesOfNodesAndSkins() throws IOException {
        String library = "<library_nodes><node id=\"n\"><translate>0 5 0</translate>"
                + "<instance_geometry url=\"#g\"/></node></library_nodes>";
        MeshObject twice = read(dae(
                "",
                TRIANGLES,
                library
                        + scene("<node><instance_node url=\"#n\"/></node><node><translate>3 0 0</translate>"
                                + "<instance_node url=\"#n\"/></node>")));
        assertThat(twice.vertices()).hasSize(6).contains(new Point(1, 5, 0), new Point(4, 5, 0));
        String skin = "<library_controllers><controller id=\"c\"><skin source=\"#g\"><bind_shape_matrix>"
                + "2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1</bind_shape_matrix></skin></controller></library_controllers>";
        assertThat(read(dae("", TRIANGLES, skin + scene("<node><instance_controller url=\"#c\"/></node>")))
                        .vertices())
                .containsExactly(new Point(2, 0, 0), new Point(0, 2, 0), new Point(0, 0, 2));
        // A scene that nobody shows is not there, and one that needs no naming is the first.
        String other = "<library_visual_scenes><visual_scene>" + node("") + "</visual_scene></library_visual_scenes>";
        assertThat(read(dae("", TRIANGLES, other)).vertices()).hasSize(3);
        assertThat(read(dae("", TRIANGLES, other + scene(node("") + node("<translate>1 0 0</translate>"))))
                        .vertices())
                .hasSize(6);
    }

    /** Numbers that are not used may be anything: a normal is often none. */
    @Test
    void normalsMayBeNan() throws IOException {
        String normals = "<source id=\"n\"><float_array>nan -1.#IND 0</float_array></source>";
        assertThat(read(dae("", normals + TRIANGLES, scene(node("")))).vertices())
                .hasSize(3);
    }

    /** As the model of a lidar that many robots have. */
    @Test
    void whatGazeboDoesNotMind() throws IOException {
        String text = dae("", TRIANGLES, scene(node("")));
        Path file = Files.writeString(
                folder.resolve("a.dae"), text.replace("<node>", "<node id=\"<SketchUp>\" name='A & B'>"));
        assertThat(WorldReader.readMesh(file)).isEqualTo(read(text));
    }

    @Test
    void aPointerOfGitLfsIsNamed() throws IOException {
        for (String name : List.of("a.dae", "a.stl", "a.obj")) {
            Path file = Files.writeString(
                    folder.resolve(name), "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n");
            assertThatThrownBy(() -> WorldReader.read(file))
                    .hasMessage(file
                            + ": this is not the file but a pointer of Git LFS to it; fetch it: git lfs pull (got: "
                            + name + ")");
        }
    }

    /** The view that SketchUp saves has a transform of NaN or a look-at, and shows nothing. */
    @Test
    void aNodeThatShowsNothingMayHaveAnyTransform() throws IOException {
        String view = "<node><matrix>NaN 0 0</matrix><node><lookat>1 2 3</lookat><node/></node></node>";
        MeshObject plain = read(dae("", TRIANGLES, scene(node(""))));
        assertThat(read(dae("", TRIANGLES, scene(view + node(""))))).isEqualTo(plain);
        assertThat(read(dae("", TRIANGLES, scene("<node>" + view + node("") + "</node>"))))
                .isEqualTo(plain);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "offset=\"0\"/>|offset=\"0\"/><ph/>|5|polygons with holes are not supported",
                "0 1 2</p>|0 1 4</p>|5|<p> must have whole numbers from 0 and below 4, the number of vertices (got: 4.0)",
                "0 1 2</p>|0 1 0.5</p>|5|(got: 0.5)",
                "0 1 2</p>|0 1 x</p>|5|<p>: a number must be decimal and finite",
                "0 1 2</p>|0 1</p>|5|triangles must have 3 corners each (got: 2 corners in all)",
                "VERTEX|TEXCOORD|5|<triangles> must have <input semantic=\"VERTEX\"",
                "offset=\"0\"|offset=\"3\"|5|<p> must have 4 indices for each corner (got: 3)",
                "offset=\"0\"|offset=\"99999999\"|5|offset of <input> must be at most 1000",
                "count=\"4\"|count=\"5\"|3|<accessor> must take at least 3 numbers for each vertex",
                "stride=\"3\"|stride=\"2\"|3|<accessor> must take at least 3 numbers for each vertex",
                "1 1 0<|1 1 1e300<|3|<float_array>: z must be a number from -2^100",
                "1 1 0<|1 1 nan<|3|<float_array>: a number must be decimal and finite",
                "POSITION|NORMAL|4|<vertices> must have <input semantic=\"POSITION\">",
                "url=\"#g\"|url=\"other.dae#g\"|6|<instance_geometry> must refer to an element of this file",
                "url=\"#g\"|url=\"#w\"|6|<instance_geometry> must refer to a <geometry> (got: <visual_scene>)",
                "url=\"#w\"|url=\"#g\"|2|a COLLADA file must show at least one face in its <visual_scene>",
                "<node>|<node><lookat>0 0 0 0 0 0 0 0 0</lookat>|6|<lookat> is not supported in a <node>",
                "<node>|<node><matrix>1 0 0</matrix>|6|<matrix> must have 16 numbers (got: 3)",
                "<node>|<node><rotate>0 0 0 5</rotate>|6|the axis of <rotate> must not be zero",
                "<node>|<node><scale>1e90 1e90 1e90</scale><scale>1 1 1</scale>|3|<geometry>: a vertex, once placed",
                "<asset>|<asset><unit meter=\"0\"/>|2|meter of <unit> must be above 0 (got: 0)",
                "<asset>|<asset><unit meter=\"inch\"/>|2|meter of <unit>: a number must be decimal",
                "<node>|<!--|6|this is not well-formed XML",
                "<?xml version=\"1.0\"?>|<!DOCTYPE COLLADA [<!ENTITY x 'y'>]>|1|a document type is not allowed",
                "<node>|<node><instance_node url=\"#w\"/>|6|<instance_node> must refer to a <node> (got: <visual_scene>)",
                "<node>|<node id=\"n\"><instance_node url=\"#n\"/>|6|no node may contain itself",
                "<instance_geometry url=\"#g\"/>||2|a COLLADA file must show at least one face in its <visual_scene>"
            })
    void mistakesAreNamed(String found, String instead, int line, String message) {
        String text = dae("", TRIANGLES, scene(node("")));
        String changed = text.replace(found, instead == null ? "" : instead);
        assertThat(changed).isNotEqualTo(text);
        assertThatThrownBy(() -> read(changed))
                .isInstanceOf(WorldException.class)
                .hasMessageStartingWith("t.dae:" + line + ":")
                .hasMessageContaining(message);
    }

    /** Each node shows the next twice: two to the fiftieth meshes, were they not counted. */
    @Test
    void instancesThatGrowWithoutEnd() {
        StringBuilder nodes = new StringBuilder("<library_nodes>");
        for (int k = 0; k < 50; k++) {
            nodes.append("<node id=\"n").append(k).append("\">");
            nodes.append(("<instance_node url=\"#n" + (k + 1) + "\"/>").repeat(2))
                    .append("</node>");
        }
        nodes.append("<node id=\"n50\"><instance_geometry url=\"#g\"/></node></library_nodes>");
        String text = dae("", TRIANGLES, nodes + scene("<node><instance_node url=\"#n0\"/></node>"));
        assertThatThrownBy(() -> read(text)).hasMessageContaining("a scene must have at most 200000 nodes");
        // A hundred thousand instances of a mesh of a thousand faces.
        String many = dae("", TRIANGLES.replace("<p>0 1 2", "<p>" + "0 1 2 ".repeat(1000)), scene(node("")))
                .replace("<instance_geometry url=\"#g\"/>", "<instance_geometry url=\"#g\"/>".repeat(10_000));
        assertThatThrownBy(() -> read(many)).hasMessageContaining("together must have at most 5000000 faces");
    }

    @Test
    void whatIsTooLongIsRefused() {
        String corners = "0 1 2 ".repeat(400);
        assertThatThrownBy(() -> read(dae(
                        "",
                        "<polygons><input semantic=\"VERTEX\" offset=\"0\"/><p>" + corners + "</p></polygons>",
                        scene(node("")))))
                .hasMessageContaining("a polygon must have at most 1000 corners; cut it into smaller ones (got: 1200)");
        assertThatThrownBy(() -> read(dae("", TRIANGLES, scene("<node>".repeat(300)))))
                .hasMessageContaining("elements must be nested at most 200 deep");
        assertThatThrownBy(() -> read(dae("", TRIANGLES, scene("<node name=\"" + "x".repeat(1001) + "\"/>"))))
                .hasMessageContaining("name of <node> must have at most 1000 characters; shorten it (got: 1001)");
        String digits = dae("", TRIANGLES, scene(node(""))).replace("1 1 0<", "1 1 " + "0".repeat(3_000_000) + "<");
        assertThatThrownBy(() -> read(digits)).hasMessageContaining("a number must be decimal and finite");
        String endless = "0 ".repeat(20_000_001);
        assertThatThrownBy(() -> read(dae("", TRIANGLES, "").replace("1 0 0 0 1 0 0 0 1\n1 1 0", endless)))
                .hasMessageContaining("a file must have at most 20000000 numbers");
    }

    /** Real files with bytes changed, cut out and doubled: each is read or refused as a file, and nothing else happens. */
    @Test
    void brokenFilesAreReadOrRefused() throws IOException {
        SplittableRandom random = new SplittableRandom(22);
        Path real = Path.of("src/test/resources/robosim/geometry/world/sdf");
        int read = 0;
        int refused = 0;
        for (String name : List.of("turtlebot3_world/meshes/wall.dae", "turtlebot3_world/meshes/hexagon.dae")) {
            String whole = Files.readString(real.resolve(name));
            assertThat(read(whole).faces().length).isGreaterThan(10);
            for (int k = 0; k < Effort.cases(1000); k++) {
                String text = whole;
                for (int changes = random.nextInt(3); changes >= 0; changes--) {
                    int from = random.nextInt(text.length());
                    int to = Math.min(text.length(), from + random.nextInt(1, 40));
                    text = switch (random.nextInt(5)) {
                        case 0 -> text.substring(0, from) + (char) random.nextInt(256) + text.substring(from + 1);
                        case 1 -> text.substring(0, from) + text.substring(to);
                        case 2 -> text.substring(0, to) + text.substring(from);
                        case 3 -> text.substring(0, from) + random.nextInt(-9, 999) + " " + text.substring(from);
                        default -> text.replace("#ID" + random.nextInt(9), "#ID" + random.nextInt(9));
                    };
                }
                try {
                    assertThat(read(text).faces()).isNotEmpty();
                    read++;
                } catch (WorldException e) {
                    assertThat(e).hasMessageStartingWith("t.dae:");
                    refused++;
                }
            }
        }
        assertThat(read).isGreaterThan(Effort.cases(200));
        assertThat(refused).isGreaterThan(Effort.cases(400));
    }

    /** In a world: metres, upright; the same surface in a file of this module. */
    @Test
    void aFileIsAWorldAndAPartOfOne() throws IOException {
        Path file = folder.resolve("t.dae");
        Files.writeString(file, dae("<up_axis>Z_UP</up_axis>", TRIANGLES, scene(node(""))));
        WorldImport read =
                WorldImport.read(file, new ImportOptions(2, 1, ImportOptions.Up.Z, List.of())); // the file knows better
        assertThat(read.format()).isEqualTo("COLLADA");
        assertThat(read.world().unit()).isEqualTo(Unit.METRE);
        MeshObject mesh = (MeshObject) read.world().objects().get(0).object();
        assertThat(mesh.name()).isEqualTo("t");
        assertThat(mesh.vertices()).containsExactly(new Point(1, 0, 0), new Point(0, 0, -1), new Point(0, 1, 0));
        assertThat(mesh.pose().rotation()).containsExactly(1, 0, 0, 0, 1, 0, 0, 0, 1);
        Path xml = Files.writeString(
                folder.resolve("w.xml"),
                "<world xmlns=\"urn:robosim:world:1\" width=\"9\" height=\"9\" length=\"9\"><mesh file=\"t.dae\""
                        + " scale=\"2\"/></world>");
        MeshObject large = (MeshObject) WorldReader.read(xml).objects().get(0).object();
        assertThat(large.vertices()).containsExactly(new Point(2, 0, 0), new Point(0, 0, -2), new Point(0, 2, 0));
    }
}
