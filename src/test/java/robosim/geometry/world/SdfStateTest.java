package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Worlds that were saved from the window of Gazebo Classic. */
class SdfStateTest {
    private static final String QUARTER = "1.5707963267948966";

    @TempDir
    Path folder;

    private WorldImport read(String content) throws IOException {
        Path file = Files.writeString(
                folder.resolve("t.world"), "<sdf version='1.6'><world name='w'>\n" + content + "\n</world></sdf>");
        return SdfReader.read(file, List.of());
    }

    private static List<GeometryObject> objects(WorldImport read) {
        return read.world().objects().stream().map(WorldObject::object).toList();
    }

    private static String link(String name, String pose, String shape) {
        return "<link name='" + name + "'>" + pose + "<collision name='c'><geometry>" + shape
                + "</geometry></collision></link>";
    }

    private static final String BOX = "<box><size>1 2 3</size></box>";
    private static final String BALL = "<sphere><radius>1</radius></sphere>";

    @Test
    void modelsStandWhereTheStateHasThem() throws IOException {
        WorldImport read = read("<model name='box'><pose>9 9 9 0 0 0</pose><static>1</static>" + link("l", "", BOX)
                + "</model><model name='stays'><pose>7 0 0 0 0 0</pose>" + link("l", "", BALL) + "</model>\n"
                + "<state world_name='w'><sim_time>1 2</sim_time><real_time>0 0</real_time><iterations>9</iterations>"
                + "<model name='box'><pose frame=''>1 2 3 0 0 " + QUARTER + "</pose><scale>1 1 1</scale><link name='l'>"
                + "<pose frame=''>1 2 3 0 0 " + QUARTER + "</pose><velocity>0 0 0 0 0 0</velocity></link></model>"
                + "<light name='sun'><pose>0 0 10 0 -0 0</pose></light></state>");
        assertThat(objects(read))
                .containsExactly(
                        new BoxObject(new Point(1, 3, -2), 1, 3, 2)
                                .turned(0, 90)
                                .named("box"),
                        new SphereObject(new Point(7, 0, 0), 1).moveable("stays"));
        assertThat(read.isWhole()).isTrue();
        assertThat(read.remarks())
                .singleElement()
                .asString()
                .contains("t.world:3: the <state> has the poses of 1 model, which stand there as in Gazebo Classic");
    }

    @Test
    void linksAndModelsWithinModelsHavePosesInTheWorldToo() throws IOException {
        WorldImport read = read("<model name='m'>" + link("a", "", BALL)
                + link("b", "<pose>1 0 0 0 0 0</pose>", BALL)
                + "<model name='n'><pose>5 0 0 0 0 0</pose>" + link("l", "<pose>1 0 0 0 0 0</pose>", BALL)
                + "</model></model><state world_name='w'><model name='m'><pose>2 0 0 0 0 " + QUARTER + "</pose>"
                + "<link name='b'><pose>2 0 4 0 0 0</pose></link>"
                + "<model name='n'><pose>2 3 0 0 0 0</pose></model></model></state>");
        ObjectGroup group = (ObjectGroup) objects(read).get(0);
        assertThat(group.center()).isEqualTo(new Point(2, 0, 0));
        assertThat(group.heading()).isEqualTo(90);
        // In the frame of the model, which looks along the world's Y.
        assertThat(group.members())
                .extracting(GeometryObject::center)
                .containsExactly(new Point(0, 0, 0), new Point(0, 4, 0), new Point(3, 0, 1));
    }

    /** A collision whose pose is relative to a frame is fixed to its link nevertheless. */
    @Test
    void whatIsFixedToALinkMovesWithIt() throws IOException {
        WorldImport read = read(
                "<model name='m'><frame name='f'><pose>0 0 1 0 0 0</pose></frame>"
                        + "<link name='l'><pose>1 0 0 0 0 0</pose><collision name='c'><pose relative_to='f'>1 0 0 0 0 0</pose>"
                        + "<geometry>" + BALL + "</geometry></collision></link>" + link("k", "", BALL) + "</model>"
                        + "<state world_name='w'><model name='m'><link name='l'><pose>5 5 5 0 0 0</pose></link></model></state>");
        // A model without a pose is at the world's origin.
        ObjectGroup group = (ObjectGroup) objects(read).get(0);
        assertThat(group.members().get(0).center()).isEqualTo(new Point(5, 6, -5));
    }

    @Test
    void scales() throws IOException {
        Files.writeString(folder.resolve("t.obj"), "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
        StringBuilder models = new StringBuilder();
        StringBuilder state = new StringBuilder("<state world_name='w'>");
        List<String> shapes = List.of(
                BOX,
                BALL,
                "<cylinder><radius>1</radius><length>2</length></cylinder>",
                "<mesh><uri>t.obj</uri><scale>1 1 10</scale></mesh>",
                "<ellipsoid><radii>1 2 3</radii></ellipsoid>");
        for (int k = 0; k < shapes.size(); k++) {
            models.append("<model name='m" + k + "'>" + link("l", "", shapes.get(k)) + "</model>");
            state.append("<model name='m" + k + "'><pose>0 0 0 0 0 0</pose><scale>2 3 4</scale></model>");
        }
        WorldImport read = read(models + "\n" + state + "</state>");
        assertThat(objects(read).subList(0, 3))
                .containsExactly(
                        new BoxObject(new Point(), 2, 12, 6).moveable("m0"),
                        new SphereObject(new Point(), 4).moveable("m1"),
                        new CylinderObject(new Point(), 3, 8).moveable("m2"));
        assertThat(((MeshObject) objects(read).get(3)).vertices())
                .containsExactly(new Point(2, 0, 0), new Point(0, 0, -3), new Point(0, 40, 0));
        assertThat(read.skipped())
                .singleElement()
                .asString()
                .contains("left out the scale of <ellipsoid> of m4::l::c: a saved <state> scales only boxes");
    }

    @Test
    void whatIsInsertedDeletedUnknownOrWrong() throws IOException {
        WorldImport read = read("<model name='gone'>" + link("l", "", BALL) + "</model><model name='m'>"
                + link("l", "", BALL) + "</model>\n<state world_name='w'>\n"
                + "<insertions><model name='new'>" + link("l", "", BOX) + "</model></insertions>\n"
                + "<deletions><name>gone</name><name>never</name></deletions>\n"
                + "<model name='new'><pose>3 0 0 0 0 0</pose></model><model name='gone'/><model name='other'/>\n"
                + "<model name='m'><pose>1 2</pose></model><model name='m'><scale>0 1 1</scale></model></state>\n"
                + "<state world_name='w'><model name='m'><pose>9 9 9 0 0 0</pose></model></state>");
        assertThat(objects(read))
                .containsExactly(
                        new SphereObject(new Point(), 1).moveable("m"),
                        new BoxObject(new Point(3, 0, 0), 1, 3, 2).moveable("new"));
        assertThat(read.skipped())
                .extracting(each -> each.line() + " " + each.what() + ": " + each.reason())
                .containsExactly(
                        "7 the <state> of m: <pose> must be 6 numbers (got: 2)",
                        "7 the <state> of m: <scale> must be above 0 (got: 0 1 1)");
        assertThat(read.remarks())
                .satisfiesExactly(
                        placed -> assertThat(placed).contains(":3: the <state> has the poses of 2 models"),
                        unknown -> assertThat(unknown)
                                .contains(":3: the <state> also has what the world has not, which is ignored: other"),
                        deleted -> assertThat(deleted).contains("not in the world, as the <state> says: gone"));
    }
}
