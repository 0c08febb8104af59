package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.zip.GZIPInputStream;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.xpath.XPathFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Document;
import robosim.geometry.Geometry;
import robosim.geometry.material.Material;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.model.SphereObject;

/** Files of SDFormat that were made for simulators, counted by XPath beside the reader. */
class SdfRealFilesTest {
    private static final Path SDF = Path.of("src/test/resources/robosim/geometry/world/sdf");

    @TempDir
    Path folder;

    private static WorldImport read(Path file) throws WorldException {
        return SdfReader.read(file, List.of());
    }

    private static int count(Document document, String path) throws Exception {
        return XPathFactory.newDefaultInstance()
                .newXPath()
                .evaluateExpression("count(" + path + ")", document, Double.class)
                .intValue();
    }

    private Path shapes3000() throws IOException {
        Path file = folder.resolve("3k_shapes.sdf");
        try (InputStream in = new GZIPInputStream(Files.newInputStream(SDF.resolve("3k_shapes.sdf.gz")))) {
            Files.copy(in, file);
        }
        return file;
    }

    /** What is read and what is left out is all that the file has. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "shapes.sdf",
                "nested_model.sdf",
                "export_occupancy_grid.sdf",
                "inner_walls/model.sdf",
                "turtlebot3_world/model.sdf",
                "3k_shapes.sdf"
            })
    void allIsAccountedFor(String name) throws Exception {
        Path file = name.equals("3k_shapes.sdf") ? shapes3000() : SDF.resolve(name);
        Document document =
                DocumentBuilderFactory.newDefaultInstance().newDocumentBuilder().parse(file.toFile());
        WorldImport read = read(file);
        for (String kind : List.of("model", "link", "collision")) {
            assertThat(read.read()).as("%s", kind).containsEntry(kind, count(document, "//" + kind));
        }
        int shapes = 0;
        for (String shape : List.of("box", "cylinder", "sphere", "capsule", "mesh", "cone", "ellipsoid", "plane")) {
            int read1 = read.read().getOrDefault(shape, 0);
            long skipped = read.skipped().stream()
                    .filter(each -> each.what().startsWith("<" + shape + ">"))
                    .count();
            assertThat(read1 + skipped).as("%s", shape).isEqualTo(count(document, "//collision/geometry/" + shape));
            shapes += read1;
        }
        List<String> ground = read.remarks().stream()
                .filter(each -> each.contains("is infinite ground"))
                .toList();
        assertThat(ground).hasSize(count(document, "//collision/geometry/plane"));
        assertThat(shapes + read.skipped().size())
                .isEqualTo(count(document, "//collision"))
                .isPositive();
        for (String other : List.of("visual", "inertial", "plugin", "light", "joint")) {
            assertThat(read.passedOver().getOrDefault(other, 0))
                    .as("%s", other)
                    .isEqualTo(count(document, "//world/" + other)
                            + count(document, "//link/" + other)
                            + count(document, "//model/" + other));
        }
        Geometry geometry = read.world().toGeometry(); // nothing reaches beyond the border
        assertThat(geometry.width()).isEqualTo(read.world().width());
    }

    @Test
    void threeThousandShapes() throws Exception {
        List<WorldObject> objects = read(shapes3000()).world().objects();
        assertThat(objects).hasSize(3004);
        int boxes = 0;
        int cylinders = 0;
        int spheres = 0;
        for (WorldObject each : objects) {
            GeometryObject object = each.object();
            assertThat(object.isMoveable()).isNotEqualTo("ground_plane".equals(object.name()));
            boxes += object instanceof BoxObject ? 1 : 0;
            cylinders += object instanceof CylinderObject ? 1 : 0;
            spheres += object instanceof SphereObject ? 1 : 0;
        }
        assertThat(List.of(boxes, cylinders, spheres)).containsExactly(1002, 1001, 1001);
    }

    @Test
    void theShapesAreWhereTheyAre() throws Exception {
        WorldImport read = read(SDF.resolve("shapes.sdf"));
        assertThat(read.world().unit()).isEqualTo(Unit.METRE);
        assertThat(read.world().objects())
                .extracting(WorldObject::color)
                .containsExactly(null, "#ff0000", "#00ff00", "#0000ff", "#ffff00", "#ff00ff", "#ff7800");
        assertThat(read.world().objects())
                .extracting(each -> each.object().withMaterial(Material.DEFAULT))
                .satisfiesExactly(
                        ground -> assertThat(ground)
                                .isEqualTo(new BoxObject(new Point(0, -0.0625, 0), 4, 0.125, 12).named("ground_plane")),
                        box -> assertThat(box).isEqualTo(new BoxObject(new Point(0, 0.5, 0), 1, 1, 1).moveable("box")),
                        cylinder -> assertThat(cylinder)
                                .isEqualTo(new CylinderObject(new Point(0, 0.5, 1.5), 0.5, 1).moveable("cylinder")),
                        sphere -> assertThat(sphere)
                                .isEqualTo(new SphereObject(new Point(0, 0.5, -1.5), 0.5).moveable("sphere")),
                        capsule -> assertThat(capsule)
                                .isEqualTo(new CapsuleObject(new Point(0, 0.5, 3), 0.2, 0.6).moveable("capsule")),
                        ellipsoid -> assertThat(ellipsoid).isInstanceOf(MeshObject.class),
                        cone -> assertThat(cone).isInstanceOf(MeshObject.class));
        assertThat(read.skipped()).isEmpty();
        assertThat(read.remarks())
                .satisfiesExactlyInAnyOrder(
                        ground -> assertThat(ground).contains(":36: <plane> of ", "is infinite ground"),
                        ellipsoid -> assertThat(ellipsoid).contains(":225: "),
                        cone -> assertThat(cone).contains(":253: "));
    }

    /** Rays at places that the file's numbers give: nine columns of radius 0.15, 1.1 apart. */
    @Test
    void raysThroughTheColumns() throws Exception {
        for (String name : List.of("turtlebot3_world/model.sdf", "turtlebot3_world/turtlebot3_world.world")) {
            WorldImport read = read(SDF.resolve(name));
            assertThat(read.world().objects()).hasSize(name.endsWith(".world") ? 16 : 15); // with the ground
            World all = read.world();
            List<WorldObject> columns = all.objects().stream()
                    .filter(each -> each.object() instanceof CylinderObject)
                    .toList();
            assertThat(columns).hasSize(9);
            Geometry geometry = new World(
                            all.width(),
                            all.height(),
                            all.length(),
                            all.unit(),
                            all.dimension(),
                            all.accuracy(),
                            columns)
                    .toGeometry();
            double inf = Double.POSITIVE_INFINITY;
            for (double row : new double[] {-1.1, 0, 1.1}) {
                Ray east = new Ray(new Point(-2.5, 0.25, row), new Point(1, 0, 0));
                assertThat(geometry.getRayDistance(east, 0, inf, 0)).isCloseTo(1.25, within(1e-15));
                Ray aside = new Ray(new Point(-2.5, 0.25, row + 0.09), new Point(1, 0, 0));
                assertThat(geometry.getRayDistance(aside, 0, inf, 0))
                        .isCloseTo(1.4 - 0.12, within(1e-14)); // 9, 12, 15: a right angle
                Ray between = new Ray(new Point(-2.5, 0.25, row + 0.16), new Point(1, 0, 0));
                assertThat(geometry.getRayDistance(between, 0, inf, 0)).isEqualTo(inf);
                Ray above = new Ray(new Point(-2.5, 0.51, row), new Point(1, 0, 0));
                assertThat(geometry.getRayDistance(above, 0, inf, 0)).isEqualTo(inf);
            }
        }
    }

    /** The outer wall, a mesh in inches of which the file says Y is up, and for which Gazebo takes Z nevertheless. */
    @Test
    void raysAtTheOuterWall() throws Exception {
        Geometry geometry =
                read(SDF.resolve("turtlebot3_world/model.sdf")).world().toGeometry();
        double inf = Double.POSITIVE_INFINITY;
        Ray west = new Ray(new Point(-2.4, 0.4, 0.55), new Point(-1, 0, 0));
        Ray east = new Ray(new Point(-3.2, 0.4, 0.55), new Point(1, 0, 0));
        double inside = geometry.getRayDistance(west, 0, inf, 0);
        double outside = geometry.getRayDistance(east, 0, inf, 0);
        assertThat(inside + outside).as("from both sides of its inner face").isLessThanOrEqualTo(0.8);
        assertThat(-2.4 - inside).as("inner face").isBetween(-3.0, -2.4);
        Ray above = new Ray(new Point(-2.4, 1, 0.55), new Point(-1, 0, 0));
        assertThat(geometry.getRayDistance(above, 0, inf, 0)).isEqualTo(inf);
    }

    /** A floor of 68 triangles and a chair in centimetres, by the vertices of their files times 0.01. */
    @Test
    void meshesOfAHouse() throws Exception {
        for (String name : List.of("FloorB_01", "ChairA_01")) {
            Path model = SDF.resolve("small_house/aws_robomaker_residential_" + name);
            WorldImport read = WorldImport.read(model, ImportOptions.DEFAULT);
            assertThat(read.isWhole()).isTrue();
            assertThat(read.read()).containsEntry("mesh", 1);
        }
    }

    /** A wall of 1 x 0.15 x 0.5 m at (1.9, 0.4), and one at (-0.5, -2) that was turned by -1.5708, which is no right angle. */
    @Test
    void raysAtTheInnerWalls() throws Exception {
        Geometry geometry = read(SDF.resolve("inner_walls/model.sdf")).world().toGeometry();
        double inf = Double.POSITIVE_INFINITY;
        Ray down = new Ray(new Point(1.9, 3, -0.4), new Point(0, -1, 0));
        assertThat(geometry.getRayDistance(down, 0, inf, 0)).isEqualTo(2.5);
        Ray along = new Ray(new Point(1.9, 0.25, 0.5), new Point(0, 0, -1));
        assertThat(geometry.getRayDistance(along, 0, inf, 0)).isCloseTo(0.9 - 0.075, within(1e-15));
        Ray turned = new Ray(new Point(-2, 0.25, 2), new Point(1, 0, 0));
        double off = 1.5708 - Math.PI / 2;
        assertThat(geometry.getRayDistance(turned, 0, inf, 0))
                .isCloseTo(1.5 - 0.075 / StrictMath.cos(off), within(1e-15))
                .isNotCloseTo(1.425, within(1e-13));
    }

    @Test
    void theNestedBoxIsInTheMovingModel() throws Exception {
        List<WorldObject> objects =
                read(SDF.resolve("nested_model.sdf")).world().objects();
        assertThat(objects).hasSize(2);
        assertThat(objects.get(0).object().name()).isEqualTo("ground_plane");
        ObjectGroup group = (ObjectGroup) objects.get(1).object();
        assertThat(group.name()).isEqualTo("model_00");
        assertThat(group.center()).isEqualTo(new Point(0, 0.5, 0));
        GeometryObject box = group.members().get(1);
        assertThat(box.center()).isEqualTo(new Point(1.25, 0, 0));
        assertThat(box.pose().heading()).isCloseTo(StrictMath.toDegrees(0.785398), within(1e-13));
    }

    @Test
    void aStaticModelRests() throws Exception {
        List<WorldObject> objects =
                read(SDF.resolve("export_occupancy_grid.sdf")).world().objects();
        assertThat(objects)
                .extracting(each -> each.object().withMaterial(Material.DEFAULT))
                .containsExactly(
                        new BoxObject(new Point(-1, 0.5, 1), 0.1, 0.1, 0.1).named("model_with_lidar"),
                        new BoxObject(new Point(1, 0.5, -1), 1, 1, 1).moveable("cube"),
                        new BoxObject(new Point(0, -0.0625, 0), 6, 0.125, 6).named("ground_plane"));
    }

    /** An element is named gz::system_priority, and no prefix is declared. */
    @Test
    void namesWithColons() throws Exception {
        assertThat(read(SDF.resolve("sensors.sdf")).world().objects()).isNotEmpty();
    }

    /** A light and a ground are at the addresses, which are not followed: nothing solid is missing. */
    @Test
    void sunAndGroundAreNotMissing() throws Exception {
        WorldImport read = read(SDF.resolve("turtlebot3_world/turtlebot3_world.world"));
        assertThat(read.isWhole()).isTrue();
        assertThat(read.remarks())
                .satisfiesExactly(
                        ground -> assertThat(ground).contains(":46: <plane> of ground_plane", "infinite ground"));
        assertThat(read.world().light().lights()).hasSize(1);
    }

    @Test
    void aModelIsFoundByItsFolderAndByItsManifest() throws Exception {
        WorldImport byFile = read(SDF.resolve("inner_walls/model.sdf"));
        for (String name : List.of("inner_walls", "inner_walls/model.config")) {
            WorldImport read = WorldImport.read(SDF.resolve(name), ImportOptions.DEFAULT);
            assertThat(read.world()).isEqualTo(byFile.world());
            assertThat(read.read()).isEqualTo(Map.of("model", 1, "link", 7, "collision", 7, "box", 7));
        }
    }

    /** Two models from a folder of models, one of them twice. */
    @Test
    void aWorldOfModelsFromAFolder() throws Exception {
        Path file = Files.writeString(folder.resolve("two.sdf"), """
                <sdf version="1.7"><world name="w">
                  <include><uri>model://inner_walls</uri></include>
                  <include><name>more</name><uri>model://inner_walls/model.sdf</uri><pose>10 0 0 0 0 0</pose></include>
                  <include><uri>model://turtlebot3_world</uri></include>
                </world></sdf>
                """);
        assertThat(read(file).skipped())
                .extracting(Skipped::toString)
                .satisfiesExactly(
                        first -> assertThat(first)
                                .startsWith(
                                        file + ":2: left out <include> of model://inner_walls: there is no such file"
                                                + " or folder below ")
                                .endsWith("check the name, or give the folder that contains the model: --models DIR,"
                                        + " or ImportOptions.withModels"
                                        + " (got: model://inner_walls)"),
                        second -> assertThat(second)
                                .startsWith(
                                        file + ":3: left out <include> of model://inner_walls/model.sdf at 10 0 0 0 0"
                                                + " 0: there is no such file"),
                        third -> assertThat(third).startsWith(file + ":4: left out <include> of model://turtlebot3"));
        WorldImport read = SdfReader.read(file, List.of(SDF));
        assertThat(read.world().objects()).hasSize(7 + 7 + 15);
        assertThat(read.skipped()).isEmpty();
        Point here = read.world().objects().get(3).object().center();
        Point there = read.world().objects().get(10).object().center();
        assertThat(there).isEqualTo(new Point(here.x() + 10, here.y(), here.z()));
        assertThat(read.world().objects().get(10).object().name())
                .isEqualTo("more::inner_wall_4::inner_wall_4_collision");
    }
}
