package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where URDF may stand, and macros of xacro. */
class UrdfFilesTest {
    private static final String ROBOT = "<?xml version='1.0'?>\n<!-- " + "licence ".repeat(300) + "-->\n"
            + "<robot name='r'><link name='l'><collision><geometry><sphere radius='1'/></geometry></collision></link></robot>";

    @TempDir
    Path folder;

    private Path file(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    @ParameterizedTest
    @CsvSource({"robot.urdf", "model.sdf", "robot.xml"})
    void aModelConfigMayNameIt(String name) throws IOException {
        file("models/r/model.config", "<model><sdf>" + name + "</sdf></model>");
        file("models/r/" + name, ROBOT);
        Path world = file(
                "w.sdf",
                "<sdf version='1.6'><world name='w'><include><uri>model://r</uri>"
                        + "<pose>1 2 3 0 0 0</pose></include></world></sdf>");
        WorldImport read = SdfReader.read(world, List.of(folder.resolve("models")));
        assertThat(read.skipped()).isEmpty();
        assertThat(read.world().objects().get(0).object().center().x()).isEqualTo(1);
        assertThat(WorldImport.read(folder.resolve("models/r"), ImportOptions.DEFAULT)
                        .isWhole())
                .isTrue();
    }

    @Test
    void aFileIsWhatItsRootSays() throws IOException {
        assertThat(WorldImport.read(file("a.sdf", ROBOT), ImportOptions.DEFAULT).isWhole())
                .isTrue();
        assertThat(WorldImport.read(
                                file(
                                        "a.urdf",
                                        "<sdf version='1.6'><model name='m'><link name='l'><collision name='c'>"
                                                + "<geometry><sphere><radius>1</radius></sphere></geometry></collision></link>"
                                                + "</model></sdf>"),
                                ImportOptions.DEFAULT)
                        .isWhole())
                .isTrue();
        // And a mistake in it is told by its line.
        assertThatThrownBy(() ->
                        WorldImport.read(file("b.sdf", "<robot name='r'>\n<link></robot>"), ImportOptions.DEFAULT))
                .hasMessageContaining("b.sdf:2:9: this is not well-formed XML");
    }

    @Test
    void macrosAreNamedOnce() throws IOException {
        WorldImport read = WorldImport.read(
                file(
                        "depot.sdf",
                        "<sdf version='1.6' xmlns:xacro='x'><world name='w'>\n<xacro:arg name='headless'/>\n<xacro:unless"
                                + " value='$(arg headless)'><plugin/></xacro:unless><model name='m'><xacro:x/><link name='l'>"
                                + "<collision name='c'><geometry><sphere><radius>1</radius></sphere></geometry></collision>"
                                + "</link></model></world></sdf>"),
                ImportOptions.DEFAULT);
        assertThat(read.world().objects()).hasSize(1);
        assertThat(read.skipped())
                .singleElement()
                .asString()
                .endsWith(
                        "depot.sdf:2: left out <xacro:arg> and 2 more: macros are not carried out; run the file through"
                                + " xacro first: xacro depot.sdf > NEW.sdf");
    }

    @ParameterizedTest
    @CsvSource({"robot.urdf.xacro,NEW.urdf", "world.sdf.xacro,NEW.sdf", "world.world.XACRO,NEW.sdf"})
    void aFileOfMacrosIsRefused(String name, String result) throws IOException {
        Path file = file(name, ROBOT);
        assertThatThrownBy(() -> WorldImport.read(file, ImportOptions.DEFAULT))
                .isInstanceOf(WorldException.class)
                .hasMessage(file + ": macros are not carried out; run the file through xacro first: xacro " + name
                        + " > " + result + " (got: .xacro)");
    }

    @Test
    void aModelOfMacrosIsLeftOut() throws IOException {
        file("r/model.config", "<model><sdf>r.urdf.xacro</sdf></model>");
        file("r/r.urdf.xacro", ROBOT);
        WorldImport read = SdfReader.read(
                file("w.sdf", "<sdf version='1.6'><world name='w'><include><uri>r</uri></include></world></sdf>"),
                List.of());
        assertThat(read.skipped())
                .singleElement()
                .asString()
                .contains("left out <include> of r: ", "run the file through xacro first: xacro r.urdf.xacro > r.urdf");
    }

    private WorldImport robot(String wheel, String joint) throws IOException {
        return WorldImport.read(
                file(
                        "cart.urdf",
                        "<robot name='cart'><link name='base'><collision><geometry><box size='2 1 1'/></geometry></collision>"
                                + "</link>\n<link name='wheel'><collision>" + wheel + "</collision></link>\n" + joint
                                + "\n</robot>"),
                ImportOptions.DEFAULT);
    }

    private static final String WHEEL = "<geometry><sphere radius='0.5'/></geometry>";

    private static String joint(String child, String origin) {
        return "<joint name='axle' type='continuous'><parent link='base'/><child link='" + child + "'/><origin "
                + origin + "/></joint>";
    }

    @Test
    void itIsToldAsUrdf() throws IOException {
        WorldImport read = robot(WHEEL, joint("wheel", "xyz='5 0 0'"));
        assertThat(read.lines(9)).first().asString().startsWith("Read URDF: ");
        assertThat(read.isWhole()).isTrue();
        assertThat(read.remarks()).isEmpty();
        assertThat(read.world().objects().get(0).object().bounds().maxX()).isEqualTo(5.5);
    }

    @Test
    void aJointThatCarriesNoLinkIsTold() throws IOException {
        WorldImport read = robot(WHEEL, joint("whel", "xyz='5 0 0'"));
        assertThat(read.skipped())
                .singleElement()
                .asString()
                .endsWith("cart.urdf:3: left out <joint> \"axle\": <child> must name a link of the robot (got: whel)");
        assertThat(read.remarks())
                .singleElement()
                .asString()
                .endsWith("cart.urdf:2: no joint places <link> \"wheel\", so it is at the robot's origin; ROS refuses a"
                        + " robot with more than one such link");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "xyz='5 0'|xyz of <origin> must be 3 numbers (got: 2)",
                "rpy='90'|rpy of <origin> must be 3 numbers (got: 1)"
            })
    void anOriginOfOtherThanThreeNumbersIsTold(String origin, String reason) throws IOException {
        assertThat(robot(WHEEL, joint("wheel", origin)).skipped())
                .singleElement()
                .asString()
                .endsWith("cart.urdf:3: left out <link> \"wheel\": " + reason);
        assertThat(robot("<origin " + origin + "/>" + WHEEL, joint("wheel", "xyz='5 0 0'"))
                        .skipped())
                .singleElement()
                .asString()
                .endsWith("cart.urdf:2: left out <collision> \"collision\": " + reason);
    }

    @ParameterizedTest
    @CsvSource({
        "<cylinder radius='1'/>,cylinder,length",
        "<capsule length='1'/>,capsule,radius",
        "<sphere/>,sphere,radius",
        "<box/>,box,size",
        "<mesh/>,mesh,filename"
    })
    void aShapeWithoutItsSizeIsTold(String shape, String name, String needed) throws IOException {
        WorldImport read = robot("<geometry>" + shape + "</geometry>", joint("wheel", "xyz='5 0 0'"));
        assertThat(read.skipped())
                .singleElement()
                .asString()
                .endsWith("cart.urdf:2: left out <collision> \"collision\": <" + name + "> must have the attribute "
                        + needed + " (got: none)");
    }

    @Test
    void aCapsuleHasAttributesToo() throws IOException {
        WorldImport read =
                robot("<geometry><capsule radius='1' length='2'/></geometry>", joint("wheel", "xyz='5 0 0'"));
        assertThat(read.skipped()).isEmpty();
        assertThat(read.world().objects().get(0).object().bounds().maxY()).isEqualTo(2);
    }

    @Test
    void whatXacroWouldComputeIsTold() throws IOException {
        WorldImport read = robot("<geometry><sphere radius='${r}'/></geometry>", joint("wheel", "xyz='5 0 0'"));
        assertThat(read.skipped())
                .extracting(Skipped::toString)
                .anyMatch(line ->
                        line.endsWith("cart.urdf:2: left out radius=\"${r}\": macros are not carried out; run the"
                                + " file through xacro first: xacro cart.urdf > NEW.urdf"));
    }
}
