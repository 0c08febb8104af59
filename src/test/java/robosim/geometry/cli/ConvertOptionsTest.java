package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.world.WorldReader;

/** Options of {@code convert} that not every format has a use for. */
@Timeout(60)
class ConvertOptionsTest extends CommandRun {
    private static final Path SHAPES = Path.of("src/test/resources/robosim/geometry/world/sdf/shapes.sdf");

    /** An option that means nothing to the file is told, and changes nothing. */
    @Test
    void optionsOfOtherFormatsAreTold() throws IOException {
        Path xml = folder.resolve("w.xml");
        assertThat(run("convert", SHAPES, xml, "--scale", "2", "--up", "y", "--centred"))
                .isEqualTo(ExitCodes.FINE);
        assertThat(err.toString().lines())
                .containsExactly(
                        "warning: --centred is for maps and changes nothing here (got: SDFormat)",
                        "warning: --scale is for meshes that are read by themselves and changes nothing here (got: SDFormat)",
                        "warning: --up is for meshes that are read by themselves and changes nothing here (got: SDFormat)");
        assertThat(run("convert", xml, folder.resolve("w2.xml"), "--wall-height", "2"))
                .isEqualTo(ExitCodes.FINE);
        assertThat(err.toString()).contains("--wall-height is for maps");
        Path mesh = Files.writeString(folder.resolve("m.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        assertThat(run("convert", mesh, folder.resolve("m.xml"), "--scale", "2", "--up", "z"))
                .isEqualTo(ExitCodes.FINE);
        assertThat(err.toString()).isEmpty();
        // A file that includes others may include a mesh, to which the option means something.
        Path outer = Files.writeString(
                folder.resolve("outer.xml"),
                "<world xmlns='urn:robosim:world:1' width='9' height='9' length='9'><include file='m.obj'/></world>");
        assertThat(run("convert", outer, folder.resolve("o.xml"), "--scale", "2"))
                .as(err.toString())
                .isEqualTo(ExitCodes.FINE);
        assertThat(err.toString()).isEmpty();
    }

    /** A map has no heights, so that they do not count unless that is asked for, here or by a world that includes it. */
    @Test
    void theDimensionOfAMap() throws IOException {
        Path map = Path.of("src/test/resources/robosim/geometry/world/maps/TenByTen.yaml");
        for (String kind : new String[] {"", "planar", "spatial"}) {
            Path xml = folder.resolve("map.xml");
            assertThat(kind.isEmpty() ? run("convert", map, xml) : run("convert", map, xml, "--dimension", kind))
                    .as(err.toString())
                    .isZero();
            assertThat(Files.readString(xml))
                    .contains("dimension=\"" + (kind.equals("spatial") ? "SPATIAL" : "PLANAR") + "\"");
        }
        Path shapes = folder.resolve("shapes.xml");
        assertThat(run("convert", SHAPES, shapes)).isZero();
        assertThat(Files.readString(shapes)).contains("dimension=\"SPATIAL\"", "ground_plane");
        assertThat(run("convert", SHAPES, shapes, "--dimension", "planar")).isZero();
        assertThat(Files.readString(shapes)).contains("dimension=\"PLANAR\"").doesNotContain("ground_plane");
        for (String name : new String[] {"TenByTen.yaml", "TenByTen.pgm"}) {
            Files.copy(map.resolveSibling(name), folder.resolve(name));
        }
        for (String dimension : new String[] {"PLANAR", "SPATIAL"}) {
            Path outer = Files.writeString(
                    folder.resolve("outer.xml"),
                    "<world xmlns=\"urn:robosim:world:1\" width=\"40\" height=\"4\" length=\"40\" dimension=\""
                            + dimension + "\"><include file=\"TenByTen.yaml\"/></world>");
            assertThat(WorldReader.read(outer).dimension()).hasToString(dimension);
        }
    }

    /** A command that needs a world lists all that is wrong with its file, as check does. */
    @Test
    void allProblemsAreListed() throws IOException {
        Path file = Files.writeString(folder.resolve("both.xml"), """
                <world xmlns="urn:robosim:world:1" width="10" height="2" length="10">
                  <wall center="0 0 -4" width="9" height="1" length="0.1"/>
                  <cylinder name="a" radius="0.2" hight="1"/>
                  <ball radius="1"/>
                </world>
                """);
        for (String[] command : new String[][] {
            {"convert", file.toString(), folder.resolve("o.xml").toString()},
            {"drive", file.toString()},
            {"add", file.toString(), folder.resolve("o.xml").toString(), "disc:0.3@0,0"}
        }) {
            err.getBuffer().setLength(0);
            assertThat(run((Object[]) command)).isEqualTo(ExitCodes.UNUSABLE);
            assertThat(err.toString().lines().filter(line -> line.startsWith(file + ":")))
                    .as(command[0])
                    .satisfiesExactly(
                            wall -> assertThat(wall).contains(":2:", "<wall> is not allowed"),
                            hight -> assertThat(hight).contains(":3:", "hight"),
                            height -> assertThat(height).contains(":3:", "height"),
                            ball -> assertThat(ball).contains(":4:", "<ball> is not allowed"));
        }
    }

    /** Robots that stand on nothing are reported; in this world it is the ground that is missing. */
    @Test
    void fallsAreReported() throws IOException {
        Path lab = Files.writeString(folder.resolve("lab.sdf"), """
                <sdf version='1.6'><world name='w'><model name='m'><static>1</static><pose>2 0 0.5 0 0 0</pose><link name='l'>
                <collision name='c'><geometry><box><size>0.1 4 1</size></box></geometry></collision></link></model>
                </world></sdf>
                """);
        Path world = folder.resolve("lab.xml");
        assertThat(run("add", lab, world, "scout=disc:0.2x0.3@0,0"))
                .as(err.toString())
                .isZero();
        assertThat(err.toString())
                .containsPattern(
                        "warning: \"scout\" stands on nothing: where bodies move it falls .* to the lower border");
        assertThat(run("check", world)).as(out.toString()).isZero();
        assertThat(out.toString()).contains("falls     \"scout\" stands on nothing: ", "verdict   fine");
        assertThat(run("check", "--json", world)).isZero();
        assertThat(out.toString()).containsPattern("\"falls\":\\[\\{\"robot\":\"scout\",\"drop\":");
        Files.writeString(
                lab,
                Files.readString(lab)
                        .replace("</world>", "<include><uri>model://ground_plane</uri></include></world>"));
        err.getBuffer().setLength(0);
        assertThat(run("add", lab, world, "scout=disc:0.2x0.3@0,0"))
                .as(err.toString())
                .isZero();
        assertThat(err.toString()).doesNotContain("falls");
        assertThat(run("check", world)).as(out.toString()).isZero();
        out.getBuffer().setLength(0);
        assertThat(run("check", "--json", world)).isZero();
        assertThat(out.toString()).contains("\"falls\":[]");
    }
}
