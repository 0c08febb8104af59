package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.SequenceInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.shared.CountedStream;

class WorldReaderTest {
    private static final String OPEN = "<world xmlns=\"urn:robosim:world:1\" width=\"9\" height=\"9\" length=\"9\"";

    private static World read(String xml) throws WorldException {
        return read(xml, null);
    }

    private static World read(String xml, @Nullable Path base) throws WorldException {
        return WorldReader.read(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "t.xml", base);
    }

    private static GeometryObject object(String xml) throws WorldException {
        return read(OPEN + ">" + xml + "</world>").objects().get(0).object();
    }

    private static WorldException refusal(String xml) {
        WorldException refusal = catchThrowableOfType(WorldException.class, () -> read(xml));
        assertThat(refusal).as("refusal of %s", xml).isNotNull();
        return refusal;
    }

    @Test
    void readsHulls(@TempDir Path folder) throws WorldException, IOException {
        String points = "0 0 0  2 0 0  0 2 0  0 0 2  0.5 0.5 0.5";
        MeshObject hull =
                (MeshObject) object("<mesh hull='true' name='a' center='1 2 3'><bounds><sphere radius='9'/></bounds>"
                        + "<vertices>" + points + "</vertices></mesh>");
        assertThat(hull.isSolid()).isTrue();
        assertThat(hull.faces()).hasDimensions(4, 3);
        assertThat(hull.boundingVolume()).isEqualTo(new SphereObject(new Point(0, 0, 0), 9));
        assertThat(hull.center()).isEqualTo(new Point(1, 2, 3));
        Files.writeString(folder.resolve("open.obj"), "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 2 3\nf 1 2 4\n");
        String xml = OPEN + "><mesh hull='true' file='open.obj' scale='0.5'/></world>";
        MeshObject read = (MeshObject) read(xml, folder).objects().get(0).object();
        assertThat(read.isSolid()).isTrue();
        assertThat(read.bounds().maxX()).isCloseTo(1, within(1e-9));
        Files.writeString(folder.resolve("many.obj"), "v 0 0 1\n".repeat(16_384) + "v 1 0 0\nf 1 2 16385\n");
        assertThatThrownBy(() -> read(OPEN + "><mesh hull='true' file='many.obj'/></world>", folder))
                .hasMessageContaining("must have at most 16384 vertices")
                .hasMessageContaining("(got: 16385)");
    }

    @Test
    void readsEverythingThatAFileCanSay() throws WorldException {
        World world = read("""
                <?xml version="1.0"?>
                <!-- The settings come first. -->
                <w:world xmlns:w="urn:robosim:world:1" width="40" height="300cm" length="3e4mm" unit="m"
                         dimension="PLANAR" accuracy="DOP">
                  <w:box width="1" height="2" length="25cm"/>
                  <w:cylinder name="robot 1" moveable="true" center="1 -20mm 0.5" heading="30" radius=".25" height="5"
                              color="#FF8800">
                    <w:sonar count="16" min="5cm" max="4" width="15"/>
                    <w:sonar count="3" first="-20" step="20"/>
                  </w:cylinder>
                  <w:sphere name="ball" turned="10 20" radius="0"/>
                  <w:mesh solid="1">
                    <w:bounds><w:sphere radius="3"/></w:bounds>
                    <w:vertices>0 0 0 1 0 0  0 1 0 0 0 1m</w:vertices>
                    <w:triangles>0 2 1 0 1 3</w:triangles>
                    <w:triangles>
                      <!-- and the other two -->
                      0 3 2 1 2 3
                    </w:triangles>
                  </w:mesh>
                  <w:group center="5 0 0" rotation="1 0 0 0 0 -1 0 1 0">
                    <w:box width="1" height="1" length="1"/>
                    <w:group><w:sphere radius="2" center="1 2 3"/></w:group>
                  </w:group>
                </w:world>
                """);
        MeshObject tetrahedron = new MeshObject(
                List.of(new Point(), new Point(1, 0, 0), new Point(0, 1, 0), new Point(0, 0, 1)),
                new int[][] {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
                new SphereObject(new Point(), 3));
        assertThat(world)
                .isEqualTo(new World(
                        40,
                        3,
                        30,
                        Unit.METRE,
                        Dimension.PLANAR,
                        Accuracy.DOP,
                        List.of(
                                new WorldObject(new BoxObject(new Point(), 1, 2, 0.25)),
                                new WorldObject(
                                        new CylinderObject(new Point(1, -0.02, 0.5), 0.25, 5)
                                                .turned(0, 30)
                                                .moveable("robot 1"),
                                        "#ff8800",
                                        List.of(
                                                new SonarRing(16, 0, 22.5, 0.05, 4, 15),
                                                new SonarRing(3, -20, 20, 0, Double.POSITIVE_INFINITY, 0))),
                                new WorldObject(new SphereObject(new Point(), 0)
                                        .turned(10, 20)
                                        .named("ball")),
                                new WorldObject(tetrahedron.solid()),
                                new WorldObject(new ObjectGroup(List.of(
                                                new BoxObject(new Point(), 1, 1, 1),
                                                new ObjectGroup(List.of(new SphereObject(new Point(1, 2, 3), 2)))))
                                        .movedTo(new Point(5, 0, 0))
                                        .oriented(new double[] {1, 0, 0, 0, 0, -1, 0, 1, 0})))));
    }

    @Test
    void defaultsAreThoseOfTheGeometry() throws WorldException {
        assertThat(read(OPEN + "/>")).isEqualTo(new World(9, 9, 9, List.of()));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "<bo/>|2|6|<bo> is not allowed in <world>; allowed here: <material>, <lighting>, <scenery>, <box>, <cylinder>, <sphere>, <capsule>, <mesh>, <group>",
                "<sonar count='1'/>|2|19|<sonar> is not allowed in <world>; allowed here: <material>, <lighting>, <scenery>, <box>",
                "<box xmlns='other'/>|2|21|<box> of the namespace \"other\" is not allowed",
                "<box width='1' height='1' length='1'>~~<box width='1' height='1' length='1'/></box>|3|39|"
                        + "<box> is not allowed in <box>; allowed here: <visual>",
                "<box height='1' length='1'/>|2|29|<box> needs the attribute width",
                "<box width='1' height='1' length='1' colour='#000000'/>|2|56|<box> has no attribute colour",
                "<box width='abc' height='1' length='1'/>|2|41|width of <box> must be a length of at least 0,",
                "<box width='-1' height='1' length='1'/>|2|40|(got: -1)",
                "<box width='NaN' height='1' length='1'/>|2|41|(got: NaN)",
                "<box width='0x1p3' height='1' length='1'/>|2|43|(got: 0x1p3)",
                "<box width='1d' height='1' length='1'/>|2|40|(got: 1d)",
                "<box width='1 2' height='1' length='1'/>|2|41|(got: 1 2)",
                "<box width='' height='1' length='1'/>|2|38|(got: )",
                "<sphere radius='1mi'/>|2|23|or ft, like 0.25 or 25cm (got: 1mi)",
                "<sphere radius='1cm'/>|2|23|add unit=\"m\" to <world>, or omit this unit (got: 1cm)",
                "<sphere radius='1e400'/>|2|25|radius: a number must be decimal and finite, like 12, -0.5 or 1.5e-3 (got: 1e400)",
                "<sphere radius='1e40'/>|2|24|radius must be a number from 0 to 2^100 (got: 1.0E40)",
                "<sphere center='1 2' radius='1'/>|2|34|center of <sphere> must be three lengths x y z",
                "<sphere center='1 2 3 4' radius='1'/>|2|38|three lengths x y z, like 1 0 -2.5 or 1m 0 -25cm (got: 1 2 3 4)",
                "<sphere turned='5' radius='1'/>|2|32|turned of <sphere> must be two numbers rx ry in degrees",
                "<sphere heading='1' turned='5 5' radius='1'/>|2|46|may be given; remove the others (got: 2)",
                "<sphere rotation='1 0 0 0 1 0 0 0 2' radius='1'/>|2|50|orthonormal to 1e-9 (got: [1.0, 0.0,",
                "<sphere rotation='1 0 0' radius='1'/>|2|38|nine numbers, row by row",
                "<sphere moveable='yes' radius='1'/>|2|36|moveable of <sphere> must be true or false (got: yes)",
                "<sphere moveable='true' radius='1'/>|2|37|a moveable object must have a name; add name=\"...\"",
                "<sphere name=' ' radius='1'/>|2|30|name of <sphere> must be text of at most 1000 characters",
                "<sphere color='red' radius='1'/>|2|33|color of <sphere> must be # and six hexadecimal digits",
                "<sphere radius='1'/>~~<sphere radius='1' name='a'/>~~~~<sphere radius='1' name='a'/>|5|30|"
                        + "rename this object or the one in line 3 (got twice: a)",
                "<sphere name='a' radius='1'><sonar count='0'/></sphere>|2|47|count of <sonar> must be a whole number from 1",
                "<sphere name='a' radius='1'><sonar count='4' min='3' max='2'/></sphere>|2|63|max must be at least min, 3.0",
                "<sphere name='a' radius='1'><sonar count='4' width='180'/></sphere>|2|59|width must be 0 to below 180",
                "<sphere radius='1'><sonar count='4'/></sphere>|2|20|an object with sonars must have a name",
                "<group/>|2|9|<group> is not complete; add <bounds>, <box>",
                "<group><bounds/></group>|2|17|<bounds> is not complete; add <box>, <cylinder>, <sphere>",
                "<group><bounds><mesh/></bounds></group>|2|23|<mesh> is not allowed in <bounds>",
                "<group><bounds><sphere radius='1'/></bounds><sphere radius='2'/></group>|2|8|boundingVolume must enclose its",
                "<group><sphere radius='2' colour='#ffffff'/></group>|2|45|<sphere> has no attribute colour",
                "hello|2|14|<world> cannot contain text",
                "<sphere radius='1'>~~hello</sphere>|3|15|<sphere> cannot contain text",
                "<mesh/>|2|8|a mesh must have vertices with triangles or quads, vertices with hull=\"true\", or a file (got: neither)",
                "<mesh><vertices>0 0 0</vertices></mesh>|2|7|or a file (got: vertices alone)",
                "<mesh hull='true'/>|2|20|or a file (got: neither)",
                "<mesh hull='true'><vertices>0 0 0</vertices><quads>0 0 0 0</quads></mesh>|2|19|must have vertices alone; remove",
                "<mesh hull='true' scale='2'><vertices>0 0 0</vertices></mesh>|2|29|scale applies only to a mesh from a file",
                "<sphere layers='' radius='1'/>|2|31|layers of <sphere> must be names without spaces, separated",
                "<mesh><vertices>0 0~~ 0 1,5 0 0</vertices><triangles>0 1 2</triangles></mesh>|3|7|(got: 1,5)",
                "<mesh><vertices>0 0~~ 0 1</vertices><triangles>0 1 2</triangles></mesh>|2|17|"
                        + "x y z of each vertex are needed (got: 4 numbers)",
                "<mesh><vertices>0 0 0</vertices><triangles>~~0 0~~0 0.5 0 0</triangles></mesh>|4|6|"
                        + "an index must be a whole number of at least 0 (got: 0.5)",
                "<mesh><vertices>0 0 0</vertices><triangles>0 0 -1</triangles></mesh>|2|50|an index must be a whole number of at least 0 (got: -1)",
                "<mesh><vertices>0 0 0</vertices><quads>0 0 0</quads></mesh>|2|40|4 indices for each face are needed",
                "<mesh><vertices>0 0 0</vertices><triangles>0 0 1</triangles></mesh>|2|7|faces[0] must have indices from 0 to 0",
                "<mesh><vertices>0 0 0 1 0 0 0 1 0</vertices><triangles>0 1 2</triangles><bounds><sphere radius='9'/>"
                        + "</bounds></mesh>|2|81|<bounds> is not allowed in <mesh>; allowed here: <triangles>",
                "<mesh solid='true'><vertices>0 0 0 1 0 0 0 1 0</vertices><triangles>0 1 2</triangles></mesh>|2|20|"
                        + "a solid mesh must be closed",
                "<mesh file='a.obj'/>|2|21|a world from a stream without a folder cannot use files",
                "<mesh scale='2'><vertices>0 0 0</vertices><quads>0 0 0 0</quads></mesh>|2|17|scale applies only to a mesh from a file",
                "<box width='1'|2|15|this is not well-formed XML",
                "<group>|2|10|this is not well-formed XML",
                "<mesh><vertices>~~0 0 <!-- ~~ --> x 1 2</vertices><quads/></mesh>|4|0|(got: x)",
                "<mesh><vertices>~~0 0 <!-- ~~ -->~~ 5~~ x 1 2</vertices><quads/></mesh>|6|3|(got: x)",
                "<mesh><vertices><![CDATA[0 0]]> x 1 2</vertices><quads/></mesh>|2|0|(got: x)",
                "&foo;|2|6|\"foo\" was referenced, but not declared",
            })
    void refusesWithPlaceAndRemedy(String body, int line, int column, String message) {
        WorldException refusal = refusal(OPEN + ">\n" + body.replace("~~", "\n") + "</world>");
        assertThat(refusal).hasMessageContaining(message);
        assertThat(refusal.getMessage()).startsWith("t.xml:" + line + (column == 0 ? ": " : ":" + column + ": "));
        assertThat(refusal.source()).isEqualTo("t.xml");
        assertThat(refusal.line()).isEqualTo(line);
        assertThat(refusal.column()).isEqualTo(column);
    }

    /** The parser hands long texts over in pieces; no line may be lost between them. */
    @Test
    void countsTheLinesOfLongTexts() {
        SplittableRandom random = new SplittableRandom(2);
        int columns = 0;
        for (int run = 0; run < 100; run++) {
            int wrong = 1 + random.nextInt(3000);
            StringBuilder text = new StringBuilder(OPEN + "><mesh><vertices>\n"); // line 1
            for (int k = 2; k < wrong + 2; k++) {
                text.append("%s %s 0.25%s\n".formatted(random.nextDouble(), k, " ".repeat(random.nextInt(9))));
            }
            text.append("1 x2 3\n".repeat(2)).append("</vertices><quads/></mesh></world>");
            WorldException refusal = refusal(text.toString());
            assertThat(refusal).hasMessageContaining("(got: x2)");
            assertThat(refusal.line()).isEqualTo(wrong + 2);
            assertThat(refusal.column()).isIn(0, 5);
            columns += refusal.column() == 5 ? 1 : 0;
        }
        assertThat(columns).isGreaterThan(90);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<world width='1'/>|the root must be <world xmlns=\"urn:robosim:world:1\" ...>",
                "<box xmlns='urn:robosim:world:1'/>|the root must be <world",
                "''|not well-formed XML",
                "<world xmlns='urn:robosim:world:1' width='1' height='0' length='1'/>|<world>: height must be above 0",
                "hello|not well-formed XML",
                "<world xmlns='urn:robosim:world:1' width='1' height='1'/>|<world> needs the attribute length",
                "<world xmlns='urn:robosim:world:1' width='1' height='1' length='1' unit='yd'/>|must be km, m, cm, mm, in or ft",
                "<world xmlns='urn:robosim:world:1' width='1' height='1' length='1' dimension='2'/>|PLANAR or SPATIAL",
                "<world xmlns='urn:robosim:world:1' width='1' height='1' length='1' accuracy='x'/>|SPHERE, AABB, OBB, DOP or EXACT",
            })
    void refusesAnotherRoot(String xml, String message) {
        assertThat(refusal(xml)).hasMessageStartingWith("t.xml:1:").hasMessageContaining(message);
    }

    @Test
    void speaksOneLanguageEverywhere() {
        Locale before = Locale.getDefault();
        try {
            for (Locale locale : List.of(Locale.FRANCE, Locale.GERMANY, Locale.JAPAN, Locale.CHINA)) {
                Locale.setDefault(locale);
                assertThat(refusal(OPEN + "><box width='x' height='1' length='1'/></world>"))
                        .hasMessageContaining("width of <box> must be a length");
                assertThat(refusal(OPEN + "><box>")).hasMessageContaining("needs the attribute width");
                assertThat(refusal(OPEN + "><group>"))
                        .hasMessageContaining(
                                "it ends before its elements do; a closing tag is missing, or the file was cut off");
            }
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void refusesAnotherTypeForAnElement() {
        String type =
                " xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' xmlns='urn:robosim:world:1' xsi:type='worldBox'";
        assertThat(refusal(OPEN + "><group><box" + type
                        + " width='1' height='1' length='1' color='#ffffff'/></group></world>"))
                .hasMessageContaining("t.xml:1:")
                .hasMessageContaining("worldBox");
    }

    @Test
    void refusesBytesThatAreNoText() {
        byte[] latin = (OPEN + "><sphere radius='1' name='caf\u00e9'/></world>").getBytes(StandardCharsets.ISO_8859_1);
        assertThatThrownBy(() -> WorldReader.read(new ByteArrayInputStream(latin), "t.xml", null))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("t.xml:1")
                .hasMessageContaining("UTF-8");
    }

    // Hostile files.

    @Test
    void refusesADocumentTypeAndAllThatItCouldDo(@TempDir Path folder) throws IOException {
        Path secret = Files.writeString(folder.resolve("secret.txt"), "the secret");
        StringBuilder laughs = new StringBuilder("<!DOCTYPE world [<!ENTITY a0 \"ha\">");
        for (int k = 1; k < 30; k++) {
            laughs.append(
                    "<!ENTITY a%d \"%s\">".formatted(k, "&a%d;".formatted(k - 1).repeat(10)));
        }
        String named = "><sphere radius='1' name='";
        for (String xml : List.of(
                laughs + "]>" + OPEN + named + "&a29;'/></world>",
                "<!DOCTYPE world [<!ENTITY x SYSTEM \"" + secret.toUri() + "\">]>" + OPEN + ">&x;</world>",
                "<!DOCTYPE world SYSTEM \"" + secret.toUri() + "\">" + OPEN + "/>",
                "<!DOCTYPE world [<!ENTITY % x SYSTEM \"http://localhost:1/x\">%x;]>" + OPEN + "/>")) {
            assertThat(refusal(xml))
                    .hasMessageContaining("t.xml:1:10: a document type is not allowed; remove <!DOCTYPE ...>")
                    .hasMessageNotContaining("secret.txt")
                    .hasMessageNotContaining("the secret");
        }
    }

    @Test
    void followsNoAddressInAFile(@TempDir Path folder) throws IOException {
        Path other = Files.writeString(folder.resolve("other.xml"), "<box/>");
        String include = "<xi:include xmlns:xi='http://www.w3.org/2001/XInclude' href='" + other.toUri() + "'/>";
        assertThat(refusal(OPEN + ">" + include + "</world>")).hasMessageContaining("<include> of the namespace");
        String hint = " xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' xsi:schemaLocation='urn:robosim:world:1 "
                + "http://localhost:1/evil.xsd'";
        assertThatNoProblem(OPEN + hint + "/>");
    }

    private static void assertThatNoProblem(String xml) {
        try {
            assertThat(read(xml).objects()).isEmpty();
        } catch (WorldException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void refusesWhatIsTooLong() {
        String million = "9".repeat(1_000_000);
        assertThat(refusal(OPEN + "><sphere radius='" + million + "'/></world>"))
                .hasMessage(
                        "t.xml:1:1000087: radius of <sphere> must have at most 1000 characters; shorten it (got: 1000000)");
        assertThat(refusal(OPEN + "><mesh><vertices>" + million + "</vertices></mesh></world>"))
                .hasMessageContaining("a number must be decimal")
                .satisfies(e -> assertThat(e.getMessage()).hasSizeLessThan(400));
        assertThat(refusal(OPEN + "><sphere radius='1e999999999'/></world>"))
                .hasMessageContaining("(got: 1e999999999)");
        assertThat(refusal(OPEN + " unit='m'><sphere radius='" + "9".repeat(101) + "mm'/></world>"))
                .hasMessageContaining("a number must be decimal");
        StringBuilder attributes = new StringBuilder();
        for (int k = 0; k < 20_000; k++) {
            attributes.append(" a").append(k).append("=''");
        }
        assertThat(refusal(OPEN + attributes + "/>").getMessage()).hasSizeLessThan(400);
    }

    @Test
    void refusesGroupsThatGoTooDeep() throws WorldException {
        String inner = "<sphere radius='1'/>";
        assertThat(read(OPEN + ">" + "<group>".repeat(50) + inner + "</group>".repeat(50) + "</world>")
                        .objects())
                .hasSize(1);
        assertThat(refusal(OPEN + ">" + "<group>".repeat(100_000)))
                .hasMessageContaining("groups must be nested at most 50 deep");
    }

    @Test
    void refusesTooManyObjects() {
        String thousand = "<sphere radius='1'/>".repeat(1000);
        InputStream many = new SequenceInputStream(Collections.enumeration(Stream.concat(
                        Stream.of(OPEN + ">"), Stream.generate(() -> thousand).limit(201))
                .map(text -> new ByteArrayInputStream(text.getBytes(StandardCharsets.US_ASCII)))
                .toList()));
        assertThatThrownBy(() -> WorldReader.read(many, "t.xml", null))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining(
                        "a world must have at most 200000 objects; split it, or make one mesh of many (got: more)");
    }

    @Test
    void refusesAStreamThatDoesNotEnd() {
        InputStream endless = new InputStream() {
            @Override
            public int read() {
                return ' ';
            }

            @Override
            public int read(byte[] target, int from, int length) {
                Arrays.fill(target, from, from + length, (byte) ' ');
                return length;
            }
        };
        assertThatThrownBy(() -> CountedStream.bounded(endless).transferTo(OutputStream.nullOutputStream()))
                .isInstanceOf(IOException.class)
                .hasMessage(
                        "a file must have at most 134217728 bytes; split it in several files, or simplify what is in it (got: more)");
        assertThatThrownBy(() -> WorldReader.read(endless, "t.xml", null))
                .isInstanceOf(WorldException.class)
                .hasMessage(
                        "t.xml:1: a tag with its attributes, a comment, or the space before the first tag must have at"
                                + " most 4194304 bytes; keep large meshes in files of their own (got: more)");
        assertThatThrownBy(() -> WorldReader.readMesh(endless, "t.obj", 1))
                .isInstanceOf(WorldException.class)
                .hasMessage(
                        "t.obj:1: a statement must have at most 100000 characters; end lines with a line feed, and split larger polygons (got: more)");
    }

    @Test
    void namesAStreamThatFails() {
        InputStream broken = new InputStream() {
            @Override
            public int read() throws IOException {
                throw new IOException("the disk is on fire");
            }
        };
        assertThatThrownBy(() -> WorldReader.read(broken, "t.xml", null))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("t.xml")
                .hasMessageContaining("the disk is on fire");
    }

    // Files.

    @Test
    void readsMeshesOfTheWorldsFolder(@TempDir Path folder) throws IOException {
        Files.createDirectories(folder.resolve("worlds/meshes"));
        Files.writeString(
                folder.resolve("worlds/meshes/tetra.obj"),
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        String mesh = "<mesh file='meshes/tetra.obj' scale='%s' %s/>";
        Path file = Files.writeString(
                folder.resolve("worlds/world.xml"),
                OPEN + ">" + mesh.formatted("2", "center='1 0 0'") + mesh.formatted("2", "heading='5'")
                        + mesh.formatted("1", "solid='true'")
                        + mesh.formatted("1", "").replace("/>", "><bounds><sphere radius='2'/></bounds></mesh>")
                        + "</world>");
        World world = WorldReader.read(file);
        MeshObject first = (MeshObject) world.objects().get(0).object();
        MeshObject second = (MeshObject) world.objects().get(1).object();
        MeshObject third = (MeshObject) world.objects().get(2).object();
        MeshObject fourth = (MeshObject) world.objects().get(3).object();
        assertThat(first.vertices()).contains(new Point(0, 2, 0)).hasSize(4);
        assertThat(second.triangles()).isSameAs(first.triangles());
        assertThat(third.isSolid()).isTrue();
        World again = read(WorldWriter.toXml(world));
        assertThat(((MeshObject) again.objects().get(1).object()).triangles())
                .as("shared by meshes that are written out too")
                .isSameAs(((MeshObject) again.objects().get(0).object()).triangles());
        assertThat(third.vertices()).contains(new Point(0, 1, 0));
        assertThat(fourth.boundingVolume()).isEqualTo(new SphereObject(new Point(), 2));
        assertThat(read(WorldWriter.toXml(world))).isEqualTo(world);
    }

    @Test
    void neverReadsOutsideTheWorldsFolder(@TempDir Path folder) throws IOException {
        Path worlds = Files.createDirectories(folder.resolve("worlds"));
        String obj = "v 0 0 0\nf 1 1 1\n";
        Path outside = Files.writeString(folder.resolve("outside.obj"), obj);
        Files.writeString(folder.resolve("worlds-2.obj"), obj);
        Files.createSymbolicLink(worlds.resolve("link.obj"), outside);
        for (String file : List.of(
                "../outside.obj",
                outside.toString(),
                "a/../../outside.obj",
                "link.obj",
                "..\\outside.obj",
                "../worlds-2.obj")) {
            String xml = OPEN + "><mesh file='" + file + "'/></world>";
            assertThatThrownBy(() -> read(xml, worlds))
                    .isInstanceOf(WorldException.class)
                    .hasMessageContaining("stay inside it (got: " + file + ")");
        }
        for (String file : List.of("missing.obj", ".", "sub/missing.obj")) {
            assertThatThrownBy(() -> read(OPEN + ">\n<mesh file='" + file + "'/></world>", worlds))
                    .isInstanceOf(WorldException.class)
                    .hasMessageStartingWith("t.xml:2:")
                    .hasMessageContaining("there is no such mesh file in " + worlds)
                    .hasMessageContaining("check the path (got: " + file + ")");
        }
        Files.writeString(worlds.resolve("bad.obj"), "v 0 0 0\nv 0 0\n");
        assertThatThrownBy(() -> read(OPEN + ">\n<mesh file='bad.obj'/></world>", worlds))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("bad.obj:2: a vertex must have x y z (got: v 0 0)");
    }

    @Test
    void namesAFileThatIsNotThere(@TempDir Path folder) {
        assertThatThrownBy(() -> WorldReader.read(folder.resolve("no.xml")))
                .isInstanceOf(WorldException.class)
                .hasMessage(folder.resolve("no.xml") + ": there is no such file; check the path");
        assertThatThrownBy(() -> WorldReader.read(folder))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("a folder must be a model's, with model.config");
    }

    @Test
    void numbersAreTheNearestDoubles() throws WorldException {
        assertThat(((SphereObject) object("<sphere radius='0.1'/>")).radius()).isEqualTo(0.1);
        assertThat(((SphereObject) object("<sphere radius='4.9e-324'/>")).radius())
                .isEqualTo(Double.MIN_VALUE);
        assertThat(object("<sphere center=' 1   -.5\n+2.e1 ' radius='0'/>").center())
                .isEqualTo(new Point(1, -0.5, 20));
    }
}
