package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** Shapes of SDFormat that become others, its older versions, and robots of URDF. */
@Timeout(60)
class SdfShapesTest {
    private static final double INF = Double.POSITIVE_INFINITY;

    @TempDir
    Path folder;

    private Path file(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    private WorldImport read(String pose, String geometry) throws IOException {
        return SdfReader.read(
                file(
                        "t.sdf",
                        "<sdf version=\"1.9\"><model name=\"m\"><static>1</static><pose>" + pose
                                + "</pose><link name=\"l\"><collision name=\"c\"><geometry>" + geometry
                                + "</geometry></collision></link></model></sdf>"),
                List.of());
    }

    private static GeometryObject only(WorldImport read) {
        assertThat(read.skipped()).isEmpty();
        assertThat(read.world().objects()).hasSize(1);
        return read.world().objects().get(0).object();
    }

    private static double ray(WorldImport read, Point from, Point to) throws IOException {
        return read.world().toGeometry().getRayDistance(new Ray(from, to), 0, INF, 0);
    }

    /** Rays down on a surface of which every point satisfies an equation. */
    @Test
    void anEllipsoidIsASolidMeshWithinAFewThousandths() throws IOException {
        WorldImport read = read("0 0 0 0 0 0", "<ellipsoid><radii>1 2 3</radii></ellipsoid>");
        MeshObject mesh = (MeshObject) only(read);
        assertThat(mesh.isSolid()).isTrue();
        for (Point vertex : mesh.vertices()) {
            double z = -vertex.z() / 2; // SDFormat's y
            assertThat(vertex.x() * vertex.x() + vertex.y() * vertex.y() / 9 + z * z)
                    .isCloseTo(1, within(1e-14));
        }
        Geometry geometry = read.world().toGeometry();
        assertThat(geometry.getRayDistance(new Ray(new Point(0.5, 3.5, 0), new Point(0, -1, 0)), 0, INF, 0))
                .isBetween(3.5 - 3 * Math.sqrt(0.75), 3.5 - 3 * Math.sqrt(0.75) + 0.02);
        assertThat(geometry.getRayDistance(new Ray(new Point(0, 0, 2.5), new Point(0, 0, -1)), 0, INF, 0))
                .isEqualTo(0.5);
        assertThat(read.remarks()).singleElement().asString().contains("<ellipsoid> of m::l::c is a solid mesh here");
        assertThat(only(read("0 0 0 0 0 0", "<ellipsoid><radii>2 2 2</radii></ellipsoid>")))
                .isEqualTo(new SphereObject(new Point(), 2).named("m"));
        MeshObject cone = (MeshObject) only(read("0 0 0 0 0 0", "<cone><radius>2</radius><length>6</length></cone>"));
        assertThat(cone.bounds().maxY()).isEqualTo(3);
        assertThat(cone.bounds().minY()).isEqualTo(-3);
        assertThat(cone.bounds().maxX()).isEqualTo(2);
        assertThat(cone.isSolid()).isTrue();
    }

    /** An L, written either way round and closed or not. */
    @Test
    void aPolylineIsExtruded() throws IOException {
        String points = "<point>0 0</point><point>2 0</point><point>2 1</point><point>1 1</point><point>1 3</point>"
                + "<point>0 3</point>";
        String back = "<point>0 0</point><point>0 3</point><point>1 3</point><point>1 1</point><point>2 1</point>"
                + "<point>2 0</point>";
        for (String each : List.of(points, back, points + "<point>0 0</point>")) {
            WorldImport read = read("0 0 1 0 0 0", "<polyline>" + each + "<height>0.5</height></polyline>");
            MeshObject mesh = (MeshObject) only(read);
            assertThat(mesh.isSolid()).isTrue();
            assertThat(ray(read, new Point(0.5, 2, -2.5), new Point(0, -1, 0))).isEqualTo(0.5);
            assertThat(ray(read, new Point(1.5, 2, -2.5), new Point(0, -1, 0))).isEqualTo(INF);
            assertThat(ray(read, new Point(1.5, 0.5, -0.5), new Point(0, 1, 0))).isEqualTo(0.5);
            assertThat(ray(read, new Point(2.5, 1.25, -2), new Point(-1, 0, 0))).isEqualTo(1.5);
        }
        String crossed = "<point>0 0</point><point>2 2</point><point>2 0</point><point>0 2</point><point>1 5</point>";
        for (String wrong : List.of(
                "<point>0 0</point><point>1 0</point><height>1</height>",
                points,
                points + "<height>0</height>",
                points + "<point>1</point><height>1</height>",
                crossed + "<height>1</height>")) {
            assertThat(read("0 0 0 0 0 0", "<polyline>" + wrong + "</polyline>").skipped())
                    .as(wrong)
                    .hasSize(1);
        }
    }

    @Test
    void aPlaneIsAThinBoxUnlessItIsTheGround() throws IOException {
        WorldImport wall = read("3 0 0 0 0 0", "<plane><normal>-2 0 0</normal><size>8 4</size></plane>");
        GeometryObject box = ((ObjectGroup) only(wall)).members().get(0);
        assertThat(((BoxObject) box).height()).isEqualTo(0.1);
        assertThat(ray(wall, new Point(0, 0, 0), new Point(1, 0, 0))).isEqualTo(3);
        assertThat(ray(wall, new Point(3.5, 0, 0), new Point(-1, 0, 0))).isCloseTo(0.4, within(1e-15));
        assertThat(wall.remarks()).singleElement().asString().contains("is a box here, of 8.0 x 4.0 m and 0.1 m thick");
        for (String normal : List.of("0 0 -1", "0 1 0", "1 1 1", "0 -3 0.1")) {
            WorldImport read = read("0 0 2 0 0 0", "<plane><normal>" + normal + "</normal></plane>");
            String[] n = normal.split(" ");
            Point along = new Point(Double.parseDouble(n[0]), Double.parseDouble(n[2]), -Double.parseDouble(n[1]));
            double size = Math.sqrt(along.x() * along.x() + along.y() * along.y() + along.z() * along.z());
            Point unit = new Point(along.x() / size, along.y() / size, along.z() / size);
            Point before = new Point(unit.x(), 2 + unit.y(), unit.z());
            assertThat(ray(read, before, new Point(-unit.x(), -unit.y(), -unit.z())))
                    .as(normal)
                    .isCloseTo(1, within(1e-12));
        }
        WorldImport ground = read("0 0 0 0 0 0", "<plane><normal>0 0 1</normal></plane>");
        assertThat(ground.isWhole()).isTrue();
        assertThat(ground.world().objects())
                .as("nothing gives a world its size")
                .isEmpty();
        assertThat(ground.remarks()).singleElement().asString().contains("is infinite ground");
    }

    @Test
    void partsOfAMesh() throws IOException {
        String mesh = "<mesh id=\"%s\"><source id=\"s%s\"><float_array>%s</float_array></source><vertices id=\"v%s\">"
                + "<input semantic=\"POSITION\" source=\"#s%s\"/></vertices><triangles>"
                + "<input semantic=\"VERTEX\" source=\"#v%s\" offset=\"0\"/><p>0 1 2</p></triangles></mesh>";
        String a = mesh.replace("%s\"><f", "a\"><f")
                .replaceFirst("%s", "a")
                .replaceFirst("%s", "2 2 2 4 2 2 2 6 2")
                .replace("%s", "a");
        String b = mesh.replace("%s\"><f", "b\"><f")
                .replaceFirst("%s", "b")
                .replaceFirst("%s", "0 0 9 1 0 9 0 1 9")
                .replace("%s", "b");
        file(
                "two.dae",
                "<COLLADA><asset><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id=\"ga\">" + a
                        + "</geometry><geometry id=\"gb\">" + b
                        + "</geometry></library_geometries><library_visual_scenes><visual_scene><node name=\"leg\">"
                        + "<instance_geometry url=\"#ga\"/></node><node id=\"top\"><instance_geometry url=\"#gb\"/>"
                        + "</node></visual_scene></library_visual_scenes></COLLADA>");
        String uri = "<mesh><uri>two.dae</uri>%s</mesh>";
        // Gazebo takes Z for up, whatever the file says.
        assertThat(((MeshObject) only(read("0 0 0 0 0 0", uri.formatted("")))).vertices())
                .hasSize(6)
                .contains(new Point(2, 2, -6), new Point(0, 9, 0));
        String leg = "<submesh><name>leg</name><center>%s</center></submesh>";
        assertThat(((MeshObject) only(read("0 0 0 0 0 0", uri.formatted(leg.formatted("false"))))).vertices())
                .containsExactly(new Point(2, 2, -2), new Point(4, 2, -2), new Point(2, 2, -6));
        assertThat(((MeshObject) only(read("0 0 0 0 0 0", uri.formatted(leg.formatted("1") + "<scale>2 1 1</scale>"))))
                        .vertices())
                .containsExactly(new Point(-2, 0, 2), new Point(2, 0, 2), new Point(-2, 0, -2));
        assertThat(only(read("0 0 0 0 0 0", uri.formatted("<submesh><name>top</name></submesh>")))
                        .bounds()
                        .minY())
                .isEqualTo(9);
        assertThat(read("0 0 0 0 0 0", uri.formatted("<submesh><name>arm</name></submesh>"))
                        .skipped())
                .singleElement()
                .asString()
                .contains("there is no node or geometry of this name with a face in the <visual_scene> (got: arm)");
    }

    /** A triangle of the same numbers as that of COLLADA, beside another one, in the parts of an OBJ and of an STL file. */
    @Test
    void partsOfObjAndStl() throws IOException {
        file(
                "two.obj",
                "v 0 0 9\nv 1 0 9\nv 0 1 9\nv 2 2 2\nv 4 2 2\nv 2 6 2\no top\nf 1 2 3\no a leg\ng legs wood\nf 4 5 6\n");
        String facet = "facet normal 0 0 1\nouter loop\nvertex %s\nvertex %s\nvertex %s\nendloop\nendfacet\n";
        file(
                "two.stl",
                "solid top\n" + facet.formatted("0 0 9", "1 0 9", "0 1 9") + "endsolid top\nsolid a leg\n"
                        + facet.formatted("2 2 2", "4 2 2", "2 6 2") + "endsolid\n");
        String part = "<mesh><uri>%s</uri><submesh><name>%s</name><center>%s</center></submesh></mesh>";
        for (String file : List.of("two.obj", "two.stl")) {
            assertThat(((MeshObject) only(read("0 0 0 0 0 0", part.formatted(file, "a leg", "false")))).vertices())
                    .containsExactly(new Point(2, 2, -2), new Point(4, 2, -2), new Point(2, 2, -6));
            assertThat(((MeshObject) only(read("0 0 0 0 0 0", part.formatted(file, "a leg", "true")))).vertices())
                    .containsExactly(new Point(-1, 0, 2), new Point(1, 0, 2), new Point(-1, 0, -2));
            assertThat(read("0 0 0 0 0 0", part.formatted(file, "arm", "true")).skipped())
                    .singleElement()
                    .asString()
                    .contains("of this name with a ", "(got: arm)");
        }
        assertThat(((MeshObject) only(read("0 0 0 0 0 0", part.formatted("two.obj", "wood", "false")))).vertices())
                .hasSize(3);
        byte[] binary = new byte[84 + 50];
        binary[80] = 1;
        Files.write(folder.resolve("binary.stl"), binary);
        assertThat(read("0 0 0 0 0 0", part.formatted("binary.stl", "x", "true"))
                        .skipped())
                .singleElement()
                .asString()
                .contains("a binary STL file has no parts with names");
    }

    /** Gazebo's own worlds name files from the folder around that of the models, which only the models' folder leads to. */
    @Test
    void aPathMayBeginWithTheNameOfAFolderOfModels(@TempDir Path elsewhere) throws IOException {
        Path models = Files.createDirectories(elsewhere.resolve("models"));
        Files.createDirectories(models.resolve("chair/meshes"));
        Files.writeString(models.resolve("chair/meshes/seat.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Path world = file(
                "t.sdf",
                "<sdf version=\"1.9\"><model name=\"m\"><static>1</static><link name=\"l\"><collision name=\"c\"><geometry>"
                        + "<mesh><uri>file://models/chair/meshes/seat.obj</uri></mesh></geometry></collision></link></model></sdf>");
        assertThat(only(SdfReader.read(world, List.of(models)))).isInstanceOf(MeshObject.class);
        assertThat(only(SdfReader.read(world, List.of(elsewhere)))).isInstanceOf(MeshObject.class);
    }

    /** The same world in words of 1.0, of 1.3 and of today. */
    @Test
    void olderVersions() throws IOException {
        String today = "<sdf version=\"1.6\"><world name=\"w\"><model name=\"m\"><static>true</static>"
                + "<pose>1 2 3 0 0 0</pose><link name=\"l\"><pose>0 0 1 0 0 0</pose><collision name=\"b\"><geometry><box>"
                + "<size>1 2 3</size></box></geometry></collision><collision name=\"c\"><pose>5 0 0 0 0 0</pose>"
                + "<geometry><cylinder><radius>1</radius><length>2</length></cylinder></geometry></collision></link>"
                + "</model></world></sdf>";
        String first = "<gazebo version=\"1.0\"><world name=\"w\"><model name=\"m\" static=\"true\">"
                + "<origin pose=\"1 2 3 0 0 0\"/><link name=\"l\"><origin pose=\"0 0 1 0 0 0\"/><collision name=\"b\">"
                + "<geometry><box size=\"1 2 3\"/></geometry></collision><collision name=\"c\">"
                + "<origin pose=\"5 0 0 0 0 0\"/><geometry><cylinder radius=\"1\" length=\"2\"/></geometry></collision>"
                + "</link></model></world></gazebo>";
        String third = today.replace("sdf>", "gazebo>").replace("<sdf version=\"1.6\"", "<gazebo version=\"1.3\"");
        World world = SdfReader.read(file("today.sdf", today), List.of()).world();
        assertThat(world.objects()).hasSize(2);
        for (String old : List.of(first, third)) {
            WorldImport read = WorldImport.read(file("old.world", old), ImportOptions.DEFAULT);
            assertThat(read.skipped()).isEmpty();
            assertThat(read.world()).isEqualTo(world);
        }
    }

    private static final String ROBOT = """
            <robot name="arm" xmlns:xacro="http://wiki.ros.org/xacro">
              <material name="grey"/>
              <link name="base"><visual/><collision><geometry><box size="1 2 3"/></geometry></collision></link>
              <link name="upper"><collision><origin xyz="0 0 0.5" rpy="0 1.5707963267948966 0"/><geometry>
                <cylinder radius="0.1" length="1"/></geometry></collision>
                <collision><geometry><mesh filename="package://robot_description/meshes/t.obj" scale="2 2 2"/>
                </geometry></collision></link>
              <link name="hand"><collision name="ball"><geometry><sphere radius="0.2"/></geometry></collision></link>
              <joint name="elbow" type="revolute"><parent link="upper"/><child link="hand"/><origin xyz="0 0 1"/></joint>
              <joint name="shoulder" type="fixed"><origin xyz="1 0 2" rpy="0 0 1.5707963267948966"/>
                <parent link="base"/><child link="upper"/></joint>
              <gazebo/><transmission/>
            </robot>
            """;

    @Test
    void aRobotOfUrdf() throws IOException {
        file("robot_description/package.xml", "<package/>");
        file("robot_description/meshes/t.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
        Path urdf = file("robot_description/urdf/arm.urdf", ROBOT);
        WorldImport read = WorldImport.read(urdf, ImportOptions.DEFAULT);
        ObjectGroup arm = (ObjectGroup) only(read);
        assertThat(arm.name()).isEqualTo("arm");
        assertThat(arm.isMoveable()).isTrue();
        assertThat(arm.members()).hasSize(4);
        assertThat(arm.members().get(0)).isEqualTo(new BoxObject(new Point(), 1, 3, 2));
        GeometryObject cylinder = arm.members().get(1);
        assertThat(cylinder).isInstanceOf(CylinderObject.class);
        assertThat(cylinder.center()).isEqualTo(new Point(1, 2.5, 0));
        // Its axis lay along the link's X, which a quarter turn took to the base's Y, which is our -Z.
        assertThat(cylinder.bounds().minZ()).isCloseTo(-0.5, within(1e-14));
        assertThat(arm.members().get(3).center()).isEqualTo(new Point(1, 3, 0));
        assertThat(read.passedOver())
                .containsEntry("visual", 1)
                .containsEntry("joint", 2)
                .containsEntry("gazebo", 1);
        // A package elsewhere, in a workspace that is given.
        Path alone = file("elsewhere/arm.urdf", ROBOT);
        assertThat(WorldImport.read(alone, ImportOptions.DEFAULT).skipped())
                .singleElement()
                .asString()
                .contains("left out <collision> \"collision_2\": there is no such file or folder below");
        file("ws/src/repository/robot_description/package.xml", "<package/>");
        file("ws/src/repository/robot_description/meshes/t.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
        assertThat(WorldImport.read(alone, ImportOptions.DEFAULT.withModels(List.of(folder.resolve("ws/src"))))
                        .isWhole())
                .isTrue();
    }

    @Test
    void aRobotWithMistakes() throws IOException {
        Path urdf = file(
                "a.urdf",
                ROBOT.replace("package://robot_description/meshes/t.obj", "no.obj")
                        .replace("<sphere radius=\"0.2\"/>", "<sphere/>")
                        .replace("<gazebo/>", "<xacro:include filename=\"x\"/>")
                        .replace("<transmission/>", "<joint name=\"j\"><child link=\"hand\"/></joint>"));
        WorldImport read = WorldImport.read(urdf, ImportOptions.DEFAULT);
        assertThat(read.world().objects()).hasSize(1);
        assertThat(read.skipped())
                .extracting(each -> each.line() + " " + each.what())
                .containsExactly(
                        "12 <xacro:include>",
                        "12 <joint> \"j\"",
                        "8 <collision> \"ball\"",
                        "6 <collision> \"collision_2\"");
        assertThat(WorldReader.problems(file("b.urdf", "<COLLADA/>")))
                .singleElement()
                .asString()
                .contains("this is COLLADA");
    }
}
