package robosim.geometry.world;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.image.PngWriter;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.material.Color;
import robosim.geometry.material.ImageTexture;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.ColorFrame;

class SdfVisualsTest {
    @TempDir
    private Path folder;

    private GeometryObject only(String name, String text) throws IOException, WorldException {
        Path file = folder.resolve(name);
        Files.writeString(file, text);
        WorldImport read = WorldImport.read(file, ImportOptions.DEFAULT);
        assertThat(read.world().objects()).hasSize(1);
        return read.world().objects().get(0).object();
    }

    private static String model(String isStatic, String inLink) {
        return "<sdf version=\"1.9\"><model name=\"m\"><static>" + isStatic
                + "</static><pose>2 0 1 0 0 1.5707963267948966</pose><link name=\"l\"><collision name=\"c\"><pose>0 0"
                + " 0.5 0 0 0</pose><geometry><box><size>1 1"
                + " 1</size></box></geometry></collision>" + inLink + "</link></model></sdf>";
    }

    private static final String BALL =
            "<visual name=\"v\"><pose>1 0 0 0 0 0</pose><geometry><sphere><radius>0.25</radius>"
                    + "</sphere></geometry><material><script><name>Gazebo/Red</name></script></material></visual>";

    @Test
    void visualsAreWhereTheirLinkPutsThemAndChangeNoDistance() throws IOException, WorldException {
        for (String isStatic : List.of("true", "false")) {
            GeometryObject object = only("m.sdf", model(isStatic, BALL));
            assertThat(object).isInstanceOf(BoxObject.class);
            assertThat(object.visuals()).hasSize(1);
            GeometryObject seen = object.seen();
            assertThat(seen).isNotNull();
            // One metre along the model's X, which is turned to the left: in SDFormat (2, 1, 1), here (2, 1, -1).
            assertThat(seen.bounds().minX()).isCloseTo(1.75, within());
            assertThat(seen.bounds().maxY()).isCloseTo(1.25, within());
            assertThat(seen.bounds().minZ()).isCloseTo(-1.25, within());
            assertThat(object.visuals().get(0).material().color()).isEqualTo(Color.parse("#ff0000"));

            Geometry world = new Geometry(20, 20, 20);
            world.addObject(object);
            Geometry plain = new Geometry(20, 20, 20);
            plain.addObject(object.withVisuals(null));
            for (Point way : List.of(new Point(2, 1, -1), new Point(2, 1.5, 0), new Point(2, 1.9, 0.4))) {
                Ray ray = new Ray(new Point(), way);
                assertThat(world.getRayDistance(ray, 0, 9, 0)).isEqualTo(plain.getRayDistance(ray, 0, 9, 0));
            }
        }
    }

    private static Offset<Double> within() {
        return Offset.offset(1e-12);
    }

    @Test
    void picturesShowTheVisualInPlaceOfTheShape() throws IOException, WorldException {
        GeometryObject object = only("m.sdf", model("false", BALL));
        Geometry world = new Geometry(20, 20, 20);
        world.addObject(object);
        ColorFrame frame = new ColorFrame();
        ColorCamera camera = ColorCamera.of(21, 21, 20);
        camera.at(Pose.of(new Point(-3, 1, -1), 0)).render(world, frame); // towards the ball
        int ball = frame.pixel(10, 10);
        assertThat(ball >> 16 & 0xff).isGreaterThan(2 * (ball & 0xff));
        camera.at(Pose.of(new Point(-3, 1.5, 0.2), 0)).render(world, frame); // towards the shape, and past it
        int empty = frame.pixel(10, 10);
        camera.render(new Geometry(20, 20, 20), frame);
        assertThat(empty).isEqualTo(frame.pixel(10, 10));
    }

    @Test
    void whatLooksLikeItsShapeHasNoVisuals() throws IOException, WorldException {
        String same = "<visual name=\"v\"><pose>0 0 0.5 0 0 0</pose><geometry><box><size>1 1"
                + " 1</size></box></geometry></visual>";
        assertThat(only("m.sdf", model("true", same)).visuals()).isNull();
        assertThat(only("m.sdf", model("false", same)).visuals()).isNull();
        String missing = "<visual name=\"v\"><geometry><mesh><uri>nowhere.dae</uri></mesh></geometry></visual>";
        assertThat(only("m.sdf", model("true", missing)).visuals()).isNull();
    }

    @Test
    void worldFilesAndSerializationKeepVisuals() throws IOException, WorldException, ClassNotFoundException {
        GeometryObject chair = only("m.sdf", model("false", BALL));
        GeometryObject hidden =
                new BoxObject(new Point(0, 0, 4), 1, 1, 1).named("hidden").withVisuals(List.of());
        World world = new World(20, 20, 20, List.of(new WorldObject(chair), new WorldObject(hidden)));
        Path file = folder.resolve("w.xml");
        Files.writeString(file, WorldWriter.toXml(world));
        assertThat(WorldReader.read(file)).isEqualTo(world);
        assertThat(chair).isNotEqualTo(chair.withVisuals(null));
        assertThat(hidden.seen()).isNull();

        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(chair);
            out.writeObject(world.toGeometry().snapshot());
        }
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            assertThat(in.readObject()).isEqualTo(chair);
            Snapshot read = (Snapshot) in.readObject();
            assertThat(read.objects()).isEqualTo(List.of(chair, hidden));
            assertThat(read.asSeen().objects()).isEqualTo(List.of(chair.seen()));
        }
    }

    @Test
    void urdfHasVisualsWithTheColoursOfTheRobot() throws IOException, WorldException {
        GeometryObject robot = only("r.urdf", """
            <robot name="r"><material name="paint"><color rgba="0 0 1 1"/></material><link name="base">
            <visual><origin xyz="0 0 0.5" rpy="0 0 0"/><geometry><cylinder radius="0.1" length="1"/></geometry>
            <material name="paint"/></visual>
            <collision><geometry><box size="1 1 0.2"/></geometry></collision></link></robot>
            """);
        assertThat(robot.visuals()).hasSize(1);
        assertThat(robot.visuals().get(0).material().color()).isEqualTo(Color.parse("#0000ff"));
        GeometryObject seen = robot.seen();
        assertThat(seen).isNotNull();
        assertThat(seen.bounds().maxY()).isCloseTo(1, within());
    }

    @Test
    void colladaHasColoursAndPictures() throws IOException, WorldException {
        Files.writeString(folder.resolve("two.dae"), """
            <COLLADA version="1.4.1"><asset><unit meter="1"/><up_axis>Z_UP</up_axis></asset>
            <library_images><image id="img"><init_from>wood.png</init_from></image></library_images>
            <library_effects>
            <effect id="e1"><profile_COMMON><technique sid="t"><phong><diffuse><color>1 0 0 1</color></diffuse></phong></technique></profile_COMMON></effect>
            <effect id="e2"><profile_COMMON><newparam sid="surf"><surface type="2D"><init_from>img</init_from></surface></newparam>
            <newparam sid="samp"><sampler2D><source>surf</source></sampler2D></newparam>
            <technique sid="t"><lambert><diffuse><texture texture="samp" texcoord="UV"/></diffuse></lambert></technique></profile_COMMON></effect>
            </library_effects>
            <library_materials><material id="m1"><instance_effect url="#e1"/></material><material id="m2"><instance_effect url="#e2"/></material></library_materials>
            <library_geometries><geometry id="g"><mesh>
            <source id="p"><float_array count="12">0 0 0 1 0 0 1 1 0 0 1 0</float_array></source>
            <source id="uv"><float_array count="8">0 0 1 0 1 1 0 1</float_array></source>
            <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
            <triangles material="a" count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
            <triangles material="b" count="1"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="TEXCOORD" source="#uv" offset="1"/><p>0 0 2 2 3 3</p></triangles>
            </mesh></geometry></library_geometries>
            <library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"><bind_material><technique_common>
            <instance_material symbol="a" target="#m1"/><instance_material symbol="b" target="#m2"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
            <scene><instance_visual_scene url="#s"/></scene></COLLADA>
            """);
        GeometryObject plain = only("a.sdf", mesh());
        assertThat(plain.material().color()).as("without its picture").isNotEqualTo(Color.BLACK);
        try (OutputStream out = Files.newOutputStream(folder.resolve("wood.png"))) {
            PngWriter.writeColour(out, 2, 1, new int[] {0x804000, 0x402000});
        }
        GeometryObject seen = only("a.sdf", mesh());
        assertThat(seen.material().texture()).isInstanceOf(ImageTexture.class);
        assertThat(((ImageTexture) seen.material().texture()).width()).isEqualTo(2);
        assertThat(seen.material().color()).as("of the face without a picture").isEqualTo(Color.parse("#ff0000"));
        TriangleMesh surface = ((MeshObject) seen).triangles();
        assertThat(List.of(surface.isTextured(0), surface.isTextured(1))).containsExactlyInAnyOrder(true, false);
    }

    private static String mesh() {
        return "<sdf version=\"1.9\"><model name=\"m\"><static>true</static><link name=\"l\"><collision"
                + " name=\"c\"><geometry><mesh><uri>two.dae</uri></mesh></geometry></collision></link></model></sdf>";
    }

    /** A model without collisions is seen where its poses put it, and is in the way of nothing. */
    @Test
    void visualsAloneAreScenery() throws IOException, WorldException {
        String place = "<pose>2 0 1 0 0 1.5707963267948966</pose>";
        for (String isStatic : List.of("true", "false")) {
            Path file = folder.resolve("s.sdf");
            Files.writeString(
                    file,
                    "<sdf version=\"1.9\"><world name=\"w\"><model name=\"box\"><static>1</static><link name=\"l\"><collision"
                            + " name=\"c\"><geometry><box><size>1 1 1</size></box></geometry></collision></link></model>"
                            + "<model name=\"m\"><static>" + isStatic + "</static>" + place + "<link name=\"l\">" + BALL
                            + "</link></model></world></sdf>");
            World world = WorldImport.read(file, ImportOptions.DEFAULT).world();
            assertThat(world.objects()).hasSize(1);
            GeometryObject ball = world.scenery().get(0);
            assertThat(world.scenery()).hasSize(1);
            assertThat(ball.bounds().minX()).isCloseTo(1.75, within());
            assertThat(ball.bounds().maxY()).isCloseTo(1.25, within());
            assertThat(ball.bounds().minZ()).isCloseTo(-1.25, within());
            assertThat(world.toGeometry().objects()).hasSize(1);
            String text = WorldWriter.toXml(world);
            assertThat(text).contains("<scenery>");
            World read = WorldReader.read(new ByteArrayInputStream(text.getBytes(UTF_8)), "s.xml", null);
            assertThat(read).isEqualTo(world);
            assertThat(read.withScenery(List.of())).isNotEqualTo(world);
        }
    }

    @Test
    void sceneryIsStaticAndHasNoName() {
        BoxObject box = new BoxObject(new Point(), 1, 1, 1);
        for (GeometryObject wrong : List.of(box.named("a"), box.moveable("a"), box.withVisuals(List.of()))) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> new World(9, 9, 9, List.of()).withScenery(List.of(wrong)))
                    .withMessageStartingWith("scenery must be static");
        }
    }
}
