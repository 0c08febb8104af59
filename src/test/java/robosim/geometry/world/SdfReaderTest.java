package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;

@Timeout(60)
class SdfReaderTest {
    private static final String BALL = "<geometry><sphere><radius>0.5</radius></sphere></geometry>";

    @TempDir
    Path folder;

    private Path file(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    private Path world(String content) throws IOException {
        return file("t.sdf", "<sdf version=\"1.11\"><world name=\"w\">\n" + content + "\n</world></sdf>");
    }

    private WorldImport read(String content) throws IOException {
        return SdfReader.read(world(content), List.of());
    }

    private List<GeometryObject> objects(String content) throws IOException {
        return read(content).world().objects().stream().map(WorldObject::object).toList();
    }

    private GeometryObject object(String content) throws IOException {
        List<GeometryObject> objects = objects(content);
        assertThat(objects).hasSize(1);
        return objects.get(0);
    }

    /** A static model of one collision with a geometry at a pose. */
    private static String solid(String pose, String geometry) {
        return "<model name=\"m\"><static>true</static>" + pose + "<link name=\"l\"><collision name=\"c\"><geometry>"
                + geometry + "</geometry></collision></link></model>";
    }

    private static String model(String name, String inside) {
        return "<model name=\"" + name + "\">" + inside + "</model>";
    }

    private static String ball(String link, String pose) {
        return "<link name=\"" + link + "\">" + pose + "<collision name=\"c\">" + BALL + "</collision></link>";
    }

    @Test
    void axesAndSizes() throws IOException {
        assertThat(object(solid("<pose>1 2 3 0 0 0</pose>", "<box><size>4 5 6</size></box>")))
                .isEqualTo(new BoxObject(new Point(1, 3, -2), 4, 6, 5).named("m"));
        assertThat(object(solid("", "<cylinder><radius>2</radius><length>7</length></cylinder>")))
                .isEqualTo(new CylinderObject(new Point(), 2, 7).named("m"));
        assertThat(object(solid("<pose/>", "<sphere><radius>2</radius></sphere>")))
                .isEqualTo(new SphereObject(new Point(), 2).named("m"));
    }

    /** A yaw is a heading; a pitch takes the front down; a roll takes the left up. */
    @Test
    void turns() throws IOException {
        String box = "<box><size>1 2 3</size></box>";
        assertThat(object(solid("<pose degrees=\"true\">0 0 0 0 0 30</pose>", box))
                        .pose())
                .isEqualTo(Pose.of(new Point(), 30));
        assertThat(object(solid("<pose>0 0 0 0 0 1.5707963267948966</pose>", box))
                        .pose())
                .isEqualTo(Pose.of(new Point(), 90));
        assertThat(object(solid("<pose degrees=\"1\">0 0 0 0 90 0</pose>", box))
                        .pose()
                        .rotation())
                .containsExactly(0, 1, 0, -1, 0, 0, 0, 0, 1);
        assertThat(object(solid("<pose degrees=\"1\">0 0 0 90 0 0</pose>", box))
                        .pose()
                        .rotation())
                .containsExactly(1, 0, 0, 0, 0, -1, 0, 1, 0);
        String quarter = "<pose rotation_format=\"quat_xyzw\">1 0 0 0 0 0.7071068 0.7071068</pose>";
        assertThat(object(solid(quarter, box)).pose()).isEqualTo(Pose.of(new Point(1, 0, 0), 90));
        String upsideDown = "<pose rotation_format=\"quat_xyzw\">0 0 0 1e-200 0 0 0</pose>";
        assertThat(object(solid(upsideDown, box)).pose().rotation()).containsExactly(1, 0, 0, 0, -1, 0, 0, 0, -1);
    }

    /** Two turns of 45 degrees are one of 90, and back again is nothing. */
    @Test
    void turnsAboutTheVerticalAreSummed() throws IOException {
        GeometryObject object = object(model(
                "m",
                "<static>1</static><pose degrees=\"true\">0 0 0 0 0 45</pose>"
                        + ball("l", "<pose degrees=\"true\">2 0 0 0 0 45</pose>")));
        assertThat(object.pose().rotation()).containsExactly(0, 0, 1, 0, 1, 0, -1, 0, 0);
        assertThat(object(model(
                                "m",
                                "<static>1</static><pose degrees=\"true\">0 0 0 0 0 33.3</pose>"
                                        + ball("l", "<pose degrees=\"true\">0 0 0 0 0 -33.3</pose>")))
                        .pose())
                .isEqualTo(Pose.ORIGIN);
    }

    @Test
    void framesJointsAndNestedNames() throws IOException {
        List<GeometryObject> objects = objects(model(
                "m",
                "<static>1</static>"
                        + ball("a", "<pose relative_to=\"hook\">1 0 0 0 0 0</pose>")
                        + "<joint name=\"hinge\" type=\"fixed\"><parent>world</parent><child>b</child>"
                        + "<pose>0 0 5 0 0 0</pose></joint>"
                        + ball("b", "<pose relative_to=\"__model__\">0 3 0 0 0 0</pose>")
                        + "<frame name=\"hook\" attached_to=\"hinge\"><pose>10 0 0 0 0 0</pose></frame>"
                        + ball("c", "<pose relative_to=\"in::deep::f\"/>")
                        + model(
                                "in",
                                "<pose relative_to=\"hinge\">0 0 1 0 0 0</pose>" + ball("x", "")
                                        + model("deep", "<frame name=\"f\"><pose>7 7 7 0 0 0</pose></frame>"))));
        assertThat(objects)
                .extracting(GeometryObject::name)
                .containsExactly("m::a::c", "m::b::c", "m::c::c", "m::in::x::c");
        assertThat(objects)
                .extracting(GeometryObject::center)
                .containsExactly(new Point(11, 5, -3), new Point(0, 0, -3), new Point(7, 13, -10), new Point(0, 6, -3));
    }

    @Test
    void worldFramesAndPlacementFrames() throws IOException {
        List<GeometryObject> objects = objects("<frame name=\"dock\"><pose degrees=\"1\">5 0 0 0 0 90</pose></frame>"
                + "<model name=\"p\" placement_frame=\"tip\"><pose relative_to=\"dock\"/><static>1</static>"
                + ball("l", "") + "<frame name=\"tip\"><pose>2 0 0 0 0 0</pose></frame></model>"
                + "<model name=\"q\"><pose relative_to=\"p::tip\">1 0 0 0 0 0</pose><static>1</static>" + ball("l", "")
                + "</model>");
        assertThat(objects).extracting(GeometryObject::center).containsExactly(new Point(5, 0, 2), new Point(5, 0, -1));
    }

    @Test
    void aCollisionCountsFromItsLinkOrAFrame() throws IOException {
        List<GeometryObject> objects = objects(model(
                "m",
                "<static>1</static><frame name=\"f\"><pose>0 0 9 0 0 0</pose></frame><link name=\"l\">"
                        + "<pose>1 0 0 0 0 0</pose>"
                        + "<collision name=\"c\"><pose>0 0 2 0 0 0</pose>" + BALL + "</collision>"
                        + "<collision name=\"d\"><pose relative_to=\"f\">0 0 2 0 0 0</pose>" + BALL + "</collision>"
                        + "</link>"));
        assertThat(objects).extracting(GeometryObject::center).containsExactly(new Point(1, 2, 0), new Point(0, 11, 0));
    }

    /** One shape above the model's own place is the object; beside it, the model's frame is kept by a group. */
    @Test
    void whatMovesIsOneObject() throws IOException {
        assertThat(object(model("r", "<pose>1 0 0 0 0 0</pose>" + ball("l", "<pose>0 0 0.5 0 0 0</pose>"))))
                .isEqualTo(new SphereObject(new Point(1, 0.5, 0), 0.5).moveable("r"));
        assertThat(object(model("r", "<pose>1 0 0 0 0 0</pose>" + ball("l", "<pose>2 0 0 0 0 0</pose>"))))
                .isEqualTo(new ObjectGroup(List.of(new SphereObject(new Point(2, 0, 0), 0.5)))
                        .movedTo(new Point(1, 0, 0))
                        .moveable("r"));
        assertThat(object(model("r", ball("a", "") + ball("b", "<pose>0 0 1 0 0 0</pose>"))))
                .isEqualTo(new ObjectGroup(
                                List.of(new SphereObject(new Point(), 0.5), new SphereObject(new Point(0, 1, 0), 0.5)))
                        .moveable("r"));
    }

    /** What is static in a moving model stays behind; what is in a static model rests, whatever it says. */
    @Test
    void staticWithinMoving() throws IOException {
        List<GeometryObject> objects = objects(model(
                "r",
                "<pose>0 0 1 0 0 0</pose>" + ball("l", "")
                        + model("rail", "<static>1</static><pose>3 0 0 0 0 0</pose>" + ball("l", ""))));
        assertThat(objects)
                .containsExactlyInAnyOrder(
                        new SphereObject(new Point(0, 1, 0), 0.5).moveable("r"),
                        new SphereObject(new Point(3, 1, 0), 0.5).named("r::rail"));
        assertThat(objects(model("s", "<static>1</static>" + model("in", "<static>0</static>" + ball("l", "")))))
                .containsExactly(new SphereObject(new Point(), 0.5).named("s::in"));
    }

    @Test
    void namesAreMadeUniqueAndThatIsSaid() throws IOException {
        String twice = "<collision name=\"c\">" + BALL + "</collision>";
        WorldImport read = read(model("m", "<static>1</static><link name=\"l\">" + twice + twice + twice + "</link>"));
        assertThat(read.world().objects())
                .extracting(each -> each.object().name())
                .containsExactly("m::l::c", "m::l::c (2)", "m::l::c (3)");
        assertThat(read.remarks())
                .hasSize(2)
                .first()
                .isEqualTo(folder.resolve("t.sdf") + ":2: another object is named m::l::c, so this one is named"
                        + " m::l::c (2)");
    }

    @Test
    void includesOverride() throws IOException {
        file(
                "ball/model.config",
                "<model><name>Ball</name><sdf version=\"1.4\">old.sdf</sdf><sdf version=\"1.10\">ball.sdf</sdf></model>");
        file("ball/old.sdf", "<sdf version=\"1.4\"/>");
        file(
                "ball/ball.sdf",
                "<sdf version=\"1.10\"><model name=\"ball\"><pose>0 0 4 0 0 0</pose>"
                        + "<frame name=\"top\"><pose>0 0 0.5 0 0 0</pose></frame>" + ball("l", "") + "</model></sdf>");
        List<GeometryObject> objects = objects("""
                <include><uri>model://ball</uri></include>
                <include><uri>ball/ball.sdf</uri><name>b2</name><static>true</static></include>
                <include><uri>file://ball</uri><name>b3</name><pose>1 0 0 0 0 0</pose></include>
                <include><uri>package://ball/ball.sdf</uri><name>b4</name><placement_frame>top</placement_frame>
                  <pose relative_to="b3">0 0 2 0 0 0</pose><plugin name="p" filename="q"/></include>
                """);
        assertThat(objects)
                .containsExactly(
                        new SphereObject(new Point(0, 4, 0), 0.5).moveable("ball"),
                        new SphereObject(new Point(0, 4, 0), 0.5).named("b2"),
                        new SphereObject(new Point(1, 0, 0), 0.5).moveable("b3"),
                        new SphereObject(new Point(1, 1.5, 0), 0.5).moveable("b4"));
    }

    @Test
    void aMergedModelLendsItsNames() throws IOException {
        file(
                "arm.sdf",
                "<sdf version=\"1.10\"><model name=\"arm\"><static>1</static>"
                        + "<frame name=\"tip\"><pose>0 0 2 0 0 0</pose></frame>"
                        + ball("upper", "<pose relative_to=\"__model__\">1 0 0 0 0 0</pose>")
                        + ball("lower", "<pose relative_to=\"tip\"/>") + "</model></sdf>");
        List<GeometryObject> objects = objects(model(
                "m",
                "<static>1</static>" + ball("base", "<pose relative_to=\"upper\"/>")
                        + "<include merge=\"true\"><uri>arm.sdf</uri><pose>0 10 0 0 0 0</pose></include>"));
        assertThat(objects)
                .extracting(GeometryObject::name)
                .containsExactly("m::base::c", "m::upper::c", "m::lower::c");
        assertThat(objects)
                .extracting(GeometryObject::center)
                .containsExactly(new Point(1, 0, -10), new Point(1, 0, -10), new Point(0, 2, -10));
        List<GeometryObject> placed = objects(model(
                "m",
                "<static>1</static><include merge=\"true\"><uri>arm.sdf</uri><placement_frame>tip</placement_frame>"
                        + "<pose>0 10 0 0 0 0</pose></include>"));
        assertThat(placed)
                .extracting(GeometryObject::center)
                .containsExactly(new Point(1, -2, -10), new Point(0, 0, -10));
    }

    /** Names are looked up when all of a scope is there, whatever stands before whatever. */
    @Test
    void aMergedModelStandsBeforeASiblingThatAnEarlierPoseCountsFrom() throws IOException {
        file("arm.sdf", "<sdf version=\"1.10\"><model name=\"arm\">" + ball("upper", "") + "</model></sdf>");
        String arm =
                "<include merge=\"true\"><uri>arm.sdf</uri><pose relative_to=\"late\">0 0 1 0 0 0</pose></include>";
        String base = ball("base", "<pose relative_to=\"late\">1 0 0 0 0 0</pose>");
        String late = "<frame name=\"late\"><pose>0 10 0 0 0 0</pose></frame>";
        for (String content : List.of(base + arm + late, arm + base + late, late + arm + base, base + late + arm)) {
            assertThat(objects(model("m", "<static>1</static>" + content)))
                    .as(content)
                    .extracting(GeometryObject::name, GeometryObject::center)
                    .containsExactlyInAnyOrder(
                            tuple("m::base::c", new Point(1, 0, -10)), tuple("m::upper::c", new Point(0, 1, -10)));
        }
        // In a world too, and with a placement frame.
        String model = model("early", "<pose relative_to=\"late\"/><static>1</static>" + ball("l", ""));
        assertThat(objects(model
                        + "<model name=\"n\"><static>1</static><include merge=\"true\"><uri>arm.sdf</uri>"
                        + "<placement_frame>upper</placement_frame><pose relative_to=\"end\"/></include>"
                        + "<frame name=\"end\"><pose>0 0 3 0 0 0</pose></frame></model>"
                        + late))
                .extracting(GeometryObject::center)
                .containsExactlyInAnyOrder(new Point(0, 0, -10), new Point(0, 3, 0));
    }

    @Test
    void meshesInTheirScale() throws IOException {
        file("shapes/tri.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 1 2 4 3\n");
        String mesh = "<mesh><uri>shapes/tri.obj</uri>%s</mesh>";
        MeshObject plain = (MeshObject) object(solid("", mesh.formatted("")));
        assertThat(plain.vertices())
                .containsExactly(new Point(1, 0, 0), new Point(0, 0, -1), new Point(0, 1, 0), new Point(1, 1, -1));
        MeshObject large =
                (MeshObject) object(solid("<pose>0 0 1 0 0 0</pose>", mesh.formatted("<scale>2 3 4</scale>")));
        assertThat(large.vertices())
                .containsExactly(new Point(2, 0, 0), new Point(0, 0, -3), new Point(0, 4, 0), new Point(2, 4, -3));
        assertThat(large.center()).isEqualTo(new Point(0, 1, 0));
        assertThat(large.faces()).isDeepEqualTo(plain.faces());
        MeshObject mirrored = (MeshObject) object(solid("", mesh.formatted("<scale>-1 1 1</scale>")));
        assertThat(mirrored.faces()[0]).containsExactly(0, 2, 1);
    }

    @Test
    void whatIsLeftOutIsNamed() throws IOException {
        WorldImport read = read("""
                <actor name="walker"><skin/></actor>
                <population name="wood"><model name="tree"/></population>
                <state world_name="w"/>
                <colision/>
                <custom:thing xmlns:custom="urn:x" name="y"><model name="hidden"/></custom:thing>
                <include><uri>model://sun</uri></include>
                <model name="m"><static>1</static><link name="l"><collision name="c"><geometry>
                <image><uri>h.png</uri></image></geometry></collision>
                <collision name="e"><geometry><empty/></geometry></collision></link></model>
                """);
        assertThat(read.world().objects()).isEmpty();
        assertThat(read.skipped())
                .extracting(each -> each.line() + " " + each.what() + ": " + each.reason())
                .containsExactly(
                        "2 <actor> \"walker\": an actor is moved by a script",
                        "3 <population> \"wood\": it places copies of a model at random",
                        "5 <colision>: SDFormat has no <colision> in <world>; check the spelling",
                        "6 <custom:thing> \"y\": an extension of SDFormat of unknown meaning",
                        "9 <image> of m::l::c: this shape is not supported; use boxes, cylinders or a mesh");
        assertThat(read.remarks()).isEmpty();
        assertThat(read.world().light().lights()).hasSize(1);
        assertThat(read.read()).doesNotContainKey("actor").containsEntry("collision", 2);
    }

    /** A house of which one thing after another is wrong: each costs itself, and is named once. */
    @Test
    void oneBadPartCostsThatPart() throws IOException {
        file("bad.sdf", "<sdf version=\"1.6\"><model");
        file("two/model.sdf", "<sdf version=\"1.6\"><model name=\"a\"/><model name=\"b\"/></sdf>");
        WorldImport read = read(model("a", "<static>1</static>" + ball("l", "")) + "\n"
                + "<include><uri>model://gone</uri><pose>1 2  3 0 0 0</pose></include>\n"
                + "<include><uri>bad.sdf</uri></include>\n"
                + "<include><uri>two</uri></include>\n"
                + "<model name=\"m\"><link name=\"l\"><collision name=\"x\"><pose>1</pose>" + BALL + "</collision>\n"
                + "<collision name=\"y\">" + BALL + "</collision></link>\n"
                + "<link name=\"k\"><pose relative_to=\"z\"/><collision name=\"c\">" + BALL + "</collision></link>\n"
                + "<link name=\"j\"><pose relative_to=\"k\"/><collision name=\"c\">" + BALL
                + "</collision></link></model>\n"
                + "<model name=\"m\"/>\n"
                + model("b", "<pose/><pose>9 9 9 0 0 0</pose><static>1</static>" + ball("l", "")));
        assertThat(read.world().objects())
                .extracting(each -> each.object().name())
                .containsExactly("a", "m", "b");
        assertThat(read.world().objects().get(2).object().center()).isEqualTo(new Point());
        assertThat(read.skipped())
                .extracting(each -> each.line() + " " + each.what())
                .containsExactly(
                        "3 <include> of model://gone at 1 2 3 0 0 0",
                        "4 <include> of bad.sdf",
                        "5 <include> of two",
                        "8 <link> \"k\"",
                        "8 <link> \"j\"",
                        "6 <collision> \"x\"");
        assertThat(read.remarks())
                .anySatisfy(
                        each -> assertThat(each).contains(":11: left out <pose>: <model> must have only one <pose>"))
                .anySatisfy(each -> assertThat(each).contains(":10: names must be unique in the world"));
        assertThat(read.skipped().get(1).reason())
                .startsWith(folder.toRealPath().resolve("bad.sdf") + ":1:");
        assertThat(read.skipped().get(3).reason()).startsWith("there is no such frame in model m");
    }

    /** A hundred thousand links, each placed by the one before, and the first by nothing that exists. */
    @Test
    void aLongChainFromNowhere() throws IOException {
        StringBuilder text = new StringBuilder(ball("right", ""));
        int count = 100_000;
        for (int k = count; k > 0; k--) {
            text.append("<link name=\"f")
                    .append(k)
                    .append("\"><pose relative_to=\"f")
                    .append(k - 1)
                    .append("\"/></link>\n");
        }
        WorldImport read = read(model("m", text.toString()));
        assertThat(read.skipped()).hasSize(count);
        assertThat(read.world().objects()).hasSize(1);
    }

    /** Only a file's name is wanted of it. */
    @Test
    void aModelConfigIsReadLeniently() throws IOException {
        String model = "<sdf version=\"1.6\">" + model("m", ball("l", "")) + "</sdf>";
        file("m/model.sdf", model);
        file("m/other.sdf", model.replace("\"m\"", "\"other\""));
        for (String config : List.of(
                "<model><sdf>other.sdf</sdf></model>",
                "<model><sdf version=\"two\"> other.sdf </sdf></model>",
                "<model><sdf version=\"2.0\">other.sdf</sdf><extra/></model>",
                "<model><sdf version=\"1.5\">other.sdf</sdf></model",
                "<!-- & --><model><name>A & B</name></model>",
                "<model><name>A</name></model>",
                "<model><sdf version=\"1.5\">gone.sdf</sdf></model>",
                "")) {
            file("m/model.config", config);
            WorldImport read = read("<include><uri>model://m</uri></include>");
            assertThat(read.isWhole()).isTrue();
            String name = config.contains("other") ? "other" : "m";
            assertThat(read.world().objects())
                    .as(config)
                    .singleElement()
                    .satisfies(each -> assertThat(each.object().name()).isEqualTo(name));
            boolean isMended = config.contains("A & B");
            int remarks = config.endsWith("</model>") && name.equals("other") ? 0 : isMended ? 2 : 1;
            assertThat(read.remarks()).as(config).hasSize(remarks);
        }
    }

    /** As Gazebo Classic reads them; the first is meant by the name. */
    @Test
    void modelsAndLinksOfOneName() throws IOException {
        WorldImport read = read(model("m", "<static>1</static>" + ball("l", "") + ball("l", "<pose>3 0 0 0 0 0</pose>"))
                + model("m", "<pose>0 5 0 0 0 0</pose>" + ball("l", ""))
                + model("n", "<pose relative_to=\"m\">0 0 1 0 0 0</pose>" + ball("l", "")));
        assertThat(read.isWhole()).isTrue();
        assertThat(read.world().objects())
                .extracting(each -> each.object().name(), each -> each.object().center())
                .containsExactly(
                        tuple("m::l::c", new Point(0, 0, 0)),
                        tuple("m::l::c (2)", new Point(3, 0, 0)),
                        tuple("m", new Point(0, 0, -5)),
                        tuple("n", new Point(0, 1, 0)));
        assertThat(read.remarks())
                .anySatisfy(each -> assertThat(each).contains("names must be unique in m; rename this"))
                .anySatisfy(each -> assertThat(each)
                        .contains(
                                "names must be unique in the world;",
                                "both are read, and poses relative to m are to the first"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '^',
            value = {
                "<model/>|<model> must have a name",
                "<model name=\"m\"><link name=\"l\"><pose>1 2 3</pose></link></model>|<pose> must be 6 numbers (got: 3)",
                "<model name=\"m\"><link name=\"l\"><pose>1 2 3 4 5 x</pose></link></model>|<pose>: a number must be decimal and finite",
                "<model name=\"m\"><link name=\"l\"><pose rotation_format=\"quat_xyzw\">0 0 0 0 0 0 0</pose></link></model>|<pose>: a quaternion must not be zero",
                "<model name=\"m\"><link name=\"l\"><pose rotation_format=\"quat\">0</pose></link></model>|rotation_format must be euler_rpy or quat_xyzw (got: quat)",
                "<model name=\"m\"><link name=\"l\"><pose frame=\"x\">0 0 0 0 0 0</pose></link></model>|there is no such frame in model m; name a link",
                "<model name=\"m\"><link name=\"l\"><pose relative_to=\"x\"/></link></model>|there is no such frame in model m; name a link",
                "<model name=\"m\"><pose relative_to=\"x\"/></model>|there is no such frame in the world",
                "<model name=\"m\"><pose>1e40 0 0 0 0 0</pose></model>|<pose>: x must be a number from -2^100",
                "<model name=\"m\"><static>yes</static></model>|<static> must be true, false, 1 or 0 (got: yes)",
                "<link name=\"l\"/>|",
                "<frame name=\"f\"/><frame name=\"f\"/>|names must be unique in the world",
                "<model name=\"m\"><frame name=\"a\" attached_to=\"b\"/><frame name=\"b\" attached_to=\"a\"/><link name=\"l\"><pose relative_to=\"a\"/></link></model>|poses must not be relative to each other in a cycle",
                "<include><uri></uri></include>|<uri> must be a path",
                "<include/>|<include> must have <uri>",
                "<include><uri>t.sdf</uri></include>|a file must not include itself",
                "<include><uri>../../etc/passwd</uri></include>|",
                "<include><uri>no.sdf</uri></include>|there is no such file or folder below",
                "<include><uri>model://no</uri><placement_frame>x</placement_frame></include>|there is no such file or folder"
            })
    void mistakesCostWhatHasThem(String content, String problem) throws IOException {
        // What is right beside it is read.
        WorldImport read = read(content + model("right", "<static>1</static>" + ball("l", "")));
        assertThat(read.world().objects())
                .extracting(each -> each.object().name())
                .contains("right");
        assertThat(read.skipped())
                .isNotEmpty()
                .allSatisfy(each -> assertThat(each.line()).isEqualTo(2));
        assertThat(read.skipped())
                .extracting(Skipped::reason)
                .anySatisfy(reason -> assertThat(reason).contains(problem == null ? "" : problem));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<box><size>1 -1 1</size></box>|<box>: length must be a number from 0",
                "<box/>|<box> must have <size>",
                "<cylinder><radius>1</radius></cylinder>|<cylinder> must have <length>",
                "<plane><normal>0 0 0</normal></plane>|<normal> must not be zero",
                "<mesh><uri>a.obj</uri><submesh><name>x</name></submesh></mesh>|there is no such file or folder below",
                "<mesh><uri>a.obj</uri></mesh>|there is no such file or folder below",
                "<box><size>1 1 1</size></box><sphere><radius>1</radius></sphere>|<geometry> must contain one shape (got: 2)",
                "|<geometry> must contain one shape (got: 0)"
            })
    void mistakesOfShapesAreNamed(String shape, String problem) throws IOException {
        WorldImport read = read(solid("", shape == null ? "" : shape) + model("right", ball("l", "")));
        assertThat(read.world().objects()).hasSize(1);
        assertThat(read.skipped())
                .singleElement()
                .asString()
                .startsWith(folder.resolve("t.sdf") + ":2: left out ")
                .contains(problem);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<world/>|:1:9: the root of SDFormat must be <sdf> (got: <world>)",
                "<sdf/>|:1:7: version of <sdf> must be 1.0 to 1.12 (got: none)",
                "<gazebo version='1.3'/>|<sdf> must have a <world> or a <model> (got: none)",
                "<sdf version='2.0'/>|version of <sdf> must be 1.0 to 1.12 (got: 2.0)",
                "<sdf version='1.6'/>|<sdf> must have a <world> or a <model> (got: none)",
                "<!DOCTYPE sdf [<!ENTITY x 'y'>]><sdf version='1.6'/>|a document type is not allowed",
                "<sdf version='1.6'><model name='&x;'/></sdf>|this is not well-formed XML: The entity \"x\" was referenced",
                "<sdf version='1.6'>|this is not well-formed XML"
            })
    void otherFilesAreRefused(String text, String problem) throws IOException {
        Path file = file("other.sdf", text);
        assertThatThrownBy(() -> SdfReader.read(file, List.of()))
                .isInstanceOf(WorldException.class)
                .hasMessageStartingWith(file + ":1:")
                .hasMessageContaining(problem);
    }

    @Test
    void aMissingFileAndAMissingFolder() {
        assertThatThrownBy(() -> SdfReader.read(folder.resolve("no.sdf"), List.of()))
                .hasMessage(folder.resolve("no.sdf") + ": there is no such file; check the path");
        assertThatThrownBy(() -> WorldImport.read(folder, ImportOptions.DEFAULT))
                .hasMessage(
                        folder + ": a folder must be a model's, with model.config; else name a file in it (got: none)");
    }

    /** A robot of visuals alone does not move, which no other message reports. */
    @Test
    void aMovingModelThatIsOnlySeenIsTold() throws IOException {
        String seen = "<link name='l'><visual name='v'>" + BALL + "</visual></link>";
        WorldImport read = read("<model name='wall'>" + "<link name='l'><collision name='c'>" + BALL
                + "</collision></link></model>\n<model name='ghost'>" + seen
                + "</model><model name='road'><static>1</static>"
                + seen + "</model><model name='empty'><link name='l'/></model>");
        assertThat(read.isWhole()).isTrue();
        assertThat(read.remarks())
                .singleElement()
                .asString()
                .endsWith(": <model> \"ghost\" has visuals and no collisions, so it is scenery, which does not move");
        assertThat(read.world().objects()).hasSize(1);
        assertThat(read.world().scenery()).hasSize(2);
    }
}
