package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.world.ImportOptions;
import robosim.geometry.world.WorldImport;
import robosim.geometry.world.WorldReader;

@Tag("clock")
@Timeout(60)
class ConvertCommandTest extends CommandRun {
    private static final Path FILES = Path.of("src/test/resources/robosim/geometry/world");

    /** A ball, and three things that no world has. */
    private Path incomplete() throws IOException {
        return Files.writeString(folder.resolve("incomplete.sdf"), """
                <sdf version='1.7'><world name='w'>
                <model name='m'><link name='l'><collision name='c'><geometry><sphere><radius>1</radius></sphere>
                </geometry></collision></link></model>
                <actor name='a'/>
                <actor name='b'/>
                <model name='n'><link name='l'><collision name='c'><geometry><image/></geometry></collision></link></model>
                </world></sdf>
                """);
    }

    @Test
    void sdfBecomesAWorld() throws IOException {
        Path in = FILES.resolve("sdf/shapes.sdf");
        Path xml = folder.resolve("shapes.xml");
        assertThat(run("convert", in, xml)).isEqualTo(ExitCodes.FINE);
        assertThat(err.toString()).isEmpty();
        assertThat(out.toString().lines())
                .hasSize(6)
                .contains(
                        "Read SDFormat: box 1, capsule 1, collision 7, cone 1, cylinder 1, ellipsoid 1, link 7, model 7, plane 1,"
                                + " sphere 1")
                .anySatisfy(line -> assertThat(line)
                        .startsWith("Wrote " + xml + ": 7 objects, 6 of them moveable; the world is 4 x 4 x "));
        assertThat(WorldReader.read(xml))
                .isEqualTo(WorldImport.read(in, ImportOptions.DEFAULT).world());
        assertThat(Files.list(folder)).containsExactly(xml);
    }

    @Test
    void strictWritesNothingWhereSomethingIsLeftOut() throws IOException {
        Path xml = Files.writeString(folder.resolve("old.xml"), "old");
        assertThat(run("convert", "--strict", incomplete(), xml)).isEqualTo(ExitCodes.FINDINGS);
        assertThat(out.toString()).contains("Wrote nothing: --strict was given, and 3 would be left out");
        assertThat(xml).hasContent("old");
        assertThat(run("convert", "--strict", FILES.resolve("sdf/inner_walls"), xml))
                .isEqualTo(ExitCodes.FINE);
        assertThat(WorldReader.read(xml).objects()).hasSize(7);
    }

    @Test
    void theOptionsReachTheReaders() throws IOException {
        Path xml = folder.resolve("w.xml");
        Path map = FILES.resolve("maps/tb3_sandbox.yaml");
        assertThat(run("convert", map, xml, "--wall-height", "0.5")).isZero();
        assertThat(WorldReader.read(xml))
                .isEqualTo(WorldImport.read(map, new ImportOptions(0.5, 1, ImportOptions.Up.Y, List.of()))
                        .world());
        Path stl = FILES.resolve("20mm-xyz-cube.stl");
        assertThat(run("convert", stl, xml, "--scale", "0.001", "--up", "z")).isZero();
        assertThat(WorldReader.read(xml))
                .isEqualTo(WorldImport.read(stl, new ImportOptions(2, 0.001, ImportOptions.Up.Z, List.of()))
                        .world());
        Path sdf = Files.writeString(
                folder.resolve("w.sdf"),
                "<sdf version='1.7'><world name='w'><include><uri>model://inner_walls</uri></include></world></sdf>");
        assertThat(run("convert", sdf, xml)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString())
                .startsWith(sdf + ": nothing in it is solid, so the world would be empty; ")
                .contains(
                        sdf + ":1: left out <include> of model://inner_walls: there is no such file or folder below ",
                        "give the folder that contains the model: --models DIR, or ImportOptions.withModels"
                                + " (got: model://inner_walls)");
        assertThat(run("convert", sdf, xml, "--models", FILES.resolve("sdf"))).isZero();
        assertThat(WorldReader.read(xml).objects()).hasSize(7);
    }

    @Test
    void trianglesForOtherViewers() throws IOException {
        Path obj = folder.resolve("rooms.obj");
        assertThat(run("convert", "worlds/rooms.xml", obj)).isZero();
        assertThat(out.toString()).contains("Read world: object 113", "Wrote " + obj + ": 113 objects, 8 of them");
        assertThat(WorldReader.readMesh(obj).faces().length).isGreaterThan(5000);
    }

    @Test
    void manyThingsLeftOutAreCutShort() throws IOException {
        StringBuilder text = new StringBuilder("<sdf version='1.7'><world name='w'>");
        text.append("<model name='m'><link name='l'><collision name='c'><geometry><sphere><radius>1</radius></sphere>"
                + "</geometry></collision></link></model>");
        // Each for a reason of its own, else they would share a line.
        for (int k = 0; k < 30; k++) {
            text.append(
                    "<model name='m" + k + "'><link name='l'><pose relative_to='no'>0 0 0 0 0 0</pose></link></model>");
        }
        text.append("</world></sdf>");
        Path sdf = Files.writeString(folder.resolve("w.sdf"), text);
        Path xml = folder.resolve("w.xml");
        assertThat(run("convert", sdf, xml)).isEqualTo(ExitCodes.PARTIAL);
        assertThat(out.toString().lines().filter(line -> line.contains("left out")))
                .hasSize(20);
        assertThat(out.toString()).contains("... and 10 more");
        assertThat(run("convert", sdf, xml, "--all")).isEqualTo(ExitCodes.PARTIAL);
        assertThat(out.toString().lines().filter(line -> line.contains("left out")))
                .hasSize(30);
    }

    private Path broken() throws IOException {
        return Files.writeString(folder.resolve("broken.sdf"), "<sdf version='1.6'>\n<model name=m/></sdf>");
    }

    /** The commands that want a world take the file as it is, and tell what is not in the world. */
    @Test
    void otherCommandsTakeTheFilesToo() throws IOException {
        Path sdf = incomplete();
        Path picture = folder.resolve("shapes.svg");
        assertThat(run("render", sdf, "-o", picture)).isZero();
        assertThat(Files.readString(picture)).contains("sphere");
        assertThat(err.toString().lines())
                .hasSize(3)
                .first()
                .asString()
                .startsWith(sdf + ":4: left out <actor> \"a\": ");
        assertThat(run("check", FILES.resolve("maps/TenByTen.yaml"))).isZero();
        assertThat(err.toString()).isEmpty();
        assertThat(run("check", sdf)).isEqualTo(ExitCodes.FINDINGS);
        assertThat(out.toString().lines().filter(line -> line.startsWith("skipped   " + sdf + ":")))
                .hasSize(3);
        assertThat(out.toString()).contains("verdict   FINDINGS: 3 left out of the file");
        Path broken = broken();
        assertThat(run("check", broken)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith(broken + ":2:13: ");
    }

    /** What a file has and its world has not is no world that is fine. */
    @Test
    void checkTellsWhatIsLeftOut() throws IOException {
        Path sdf = incomplete();
        assertThat(run("check", "--json", sdf)).isEqualTo(ExitCodes.FINDINGS);
        assertThat(out.toString())
                .contains("\"valid\":true,\"fine\":false,\"problems\":[],\"skipped\":[{\"file\":\"", "\"line\":6,")
                .contains("\"what\":\"<image> of n::l::c\",\"reason\":\"");
        assertThat(err.toString()).isEmpty();
        assertThat(run("check", "--json", FILES.resolve("sdf/inner_walls/model.sdf")))
                .isZero();
        assertThat(out.toString()).contains("\"fine\":true,", "\"skipped\":[]");
    }

    /** What every Gazebo has with it is not missing, whether it is there or not. */
    @Test
    void sunAndGroundAreANote() throws IOException {
        Path sdf = Files.writeString(folder.resolve("w.sdf"), """
                <sdf version="1.6"><world name="w">
                <include><uri>model://sun</uri></include>
                <include><uri>model://ground_plane</uri></include>
                <model name="m"><static>1</static><link name="l"><collision name="c"><geometry>
                <box><size>1 1 1</size></box></geometry></collision></link></model>
                </world></sdf>
                """);
        assertThat(run("check", sdf)).as(out.toString()).isEqualTo(ExitCodes.FINE);
        assertThat(out.toString())
                .contains(
                        "note      " + sdf
                                + ":3: <plane> of ground_plane::link::collision is infinite ground, and a box here",
                        "verdict   fine")
                .doesNotContain("skipped");
        assertThat(run("check", "--json", sdf)).isEqualTo(ExitCodes.FINE);
        assertThat(out.toString()).contains("\"fine\":true", "\"skipped\":[],\"notes\":[\"" + sdf + ":3: <plane>");
        assertThat(run("convert", "--strict", sdf, folder.resolve("w.xml"))).isEqualTo(ExitCodes.FINE);
        assertThat(out.toString()).contains(sdf + ":3: <plane> of ground_plane::link::collision is infinite ground");

        Path ground = Files.createDirectories(folder.resolve("models/ground_plane"));
        Files.writeString(ground.resolve("model.config"), "<model><sdf version='1.6'>model.sdf</sdf></model>");
        Files.writeString(ground.resolve("model.sdf"), """
                <sdf version="1.6"><model name="ground_plane"><static>1</static><link name="link"><collision name="c">
                <geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link></model></sdf>
                """);
        assertThat(run("check", sdf, "--models", folder.resolve("models"))).isEqualTo(ExitCodes.FINE);
        assertThat(out.toString())
                .contains("model.sdf:2: <plane> of ground_plane::link::c is infinite ground, ")
                .doesNotContain("skipped");
        // Any other that is not there is left out, and that is told by the exit code.
        Files.writeString(sdf, Files.readString(sdf).replace("model://sun", "model://moon"));
        assertThat(run("check", sdf)).isEqualTo(ExitCodes.FINDINGS);
        Path xml = folder.resolve("moon.xml");
        assertThat(run("convert", "--strict", sdf, xml)).isEqualTo(ExitCodes.FINDINGS);
        assertThat(xml).doesNotExist();
        assertThat(run("convert", sdf, xml)).isEqualTo(ExitCodes.PARTIAL);
        assertThat(out.toString()).contains(sdf + ":2: left out <include> of model://moon: there is no such file");
        assertThat(xml).exists();
    }

    /** What overwrites its own input has lost it where anything was left out. */
    @Test
    void aFileIsNotConvertedOntoItself() throws IOException {
        Path xml = folder.resolve("rooms.xml");
        Files.copy(Path.of("worlds/rooms.xml"), xml);
        Path link = Files.createSymbolicLink(folder.resolve("link.xml"), xml);
        for (Path out : new Path[] {xml, folder.resolve("./rooms.xml"), link}) {
            assertThat(run("convert", xml, out)).isEqualTo(ExitCodes.UNUSABLE);
            assertThat(err.toString())
                    .startsWith("OUT must not be a file that is read, which it would overwrite; name another (got: ");
        }
        assertThat(xml).hasSameTextualContentAs(Path.of("worlds/rooms.xml"));
    }

    /** A mesh that a world refers to is input too. */
    @Test
    void aFileIsNotConvertedOntoAMeshOfIt() throws IOException {
        Path mesh = Files.writeString(folder.resolve("part.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Path xml = Files.writeString(folder.resolve("w.xml"), """
                <world xmlns="urn:robosim:world:1" width="9" height="9" length="9">
                  <mesh file="part.obj" center="0 0 0"/>
                </world>""");
        assertThat(run("convert", xml, mesh)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString())
                .contains("OUT must not be a file that is read")
                .contains(mesh.toString());
        assertThat(mesh).content().startsWith("v 0 0 0");
        assertThat(run("convert", xml, folder.resolve("other.obj"))).isZero();
    }

    /** A world without its walls is no world that is fine. */
    @Test
    void sdfOfWhichNothingIsLoadedIsAnError() throws IOException {
        Path sdf = Files.writeString(folder.resolve("w.sdf"), """
                <sdf version="1.6"><world name="w">
                <model name="m"><static>1</static><link name="l"><collision name="c"><geometry>
                <mesh><uri>model://m/wall.fbx</uri></mesh></geometry></collision></link></model>
                <include><uri>https://fuel.gazebosim.org/1.0/a/models/b</uri></include>
                </world></sdf>
                """);
        Path xml = folder.resolve("w.xml");
        for (List<Object> line : List.<List<Object>>of(
                List.of("convert", sdf, xml), List.of("check", sdf), List.of("render", sdf, "-o", folder + "/w.svg"))) {
            assertThat(run(line.toArray())).as(line.toString()).isEqualTo(ExitCodes.UNUSABLE);
            assertThat(err.toString())
                    .startsWith(sdf + ": nothing in it is solid, so the world would be empty; ")
                    .contains("w.sdf:3: left out <mesh> of m::l::c: ", "network addresses are not followed");
        }
        assertThat(xml).doesNotExist();
    }

    /** Only the name of the model's file is wanted of it, and people write what they like into a description. */
    @Test
    void aBrokenDescriptionRefusesNoWorld() throws IOException {
        Path model = Files.createDirectories(folder.resolve("models/wall"));
        String box = Files.readString(FILES.resolve("sdf/inner_walls/model.sdf"));
        Files.writeString(model.resolve("model.sdf"), box);
        Files.writeString(model.resolve("new.sdf"), box.replace("<static>1</static>", "<static>true</static>"));
        Path sdf = Files.writeString(
                folder.resolve("w.sdf"),
                "<sdf version='1.7'><world name='w'><include><uri>model://wall</uri></include></world></sdf>");
        Path config = model.resolve("model.config");
        String broken = "<description>Walls & doors</description>";
        String named = "<sdf version='1.6'>new.sdf</sdf>";
        for (String text : new String[] {named + broken, broken + named, broken}) {
            Files.writeString(config, "<model><name>wall</name>\n" + text + "</model>");
            assertThat(run("check", sdf, "--models", folder.resolve("models")))
                    .as(text)
                    .isEqualTo(ExitCodes.FINE);
            assertThat(out.toString())
                    .contains(
                            "objects   7: ",
                            "note      " + config.toRealPath() + ":2:",
                            "an & that is not written as &amp;",
                            text.contains(named) ? "" : "it names no file; model.sdf was used");
        }
        assertThat(run("convert", model, folder.resolve("w.xml"))).isZero();
        assertThat(out.toString()).contains("model.sdf was used");
        Files.delete(model.resolve("model.sdf"));
        assertThat(run("check", sdf, "--models", folder.resolve("models"))).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("model.config:2:", "this is not well-formed XML");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "w.xml|<?xml version='1.0'?><!-- x --><sdf version='1.6'/>|this is SDFormat; give it a name that ends in .sdf",
                "w.sdf|<world xmlns='urn:robosim:world:1'/>|this is a world of this module; give it a name that ends in .xml",
                "w.xml|<robot name='r'/>|this is URDF",
                "w.xml|<COLLADA/>|this is COLLADA; give it a name that ends in .dae",
                "w.world|<!DOCTYPE html><html/>|this is a web page",
                "w|P5 3 2 255 aaaaaa|this is an image (PNM); a ROS map is read from its .yaml file",
                "w.yaml|%PDF-1.4|this is a PDF",
                "w.sdf|PK\u0003\u0004 zip|this is an archive",
                "w.obj|solid x|this is STL; give it a name that ends in .stl",
                "w.stl|# x;v 0 0 0;|this is Wavefront OBJ; give it a name that ends in .obj",
                "w.txt|image: a.pgm;resolution: 1|this is a ROS map; give it a name that ends in .yaml",
                "w.json|{\"type\":\"scenario\"}|this is JSON; recordings of this module end in .jsonl",
                "w.xml|ply;format ascii|this is PLY",
                "w.xml|glTF|this is glTF",
                "w.yaml|<a/>|this is XML, with the root <a>",
            })
    void aFileOfAnotherFormatIsToldByWhatItIs(String name, String text, String message) throws IOException {
        Path file = Files.writeString(folder.resolve(name), text.replace(';', '\n'));
        for (List<Object> line :
                List.<List<Object>>of(List.of("check", file), List.of("render", file, "-o", folder + "/w.svg"))) {
            assertThat(run(line.toArray())).isEqualTo(ExitCodes.UNUSABLE);
            assertThat(err.toString()).startsWith(file + ": " + message).contains("(got: " + name + ")");
        }
    }

    @Test
    void renderTakesFoldersOfModels() throws IOException {
        Path sdf = Files.writeString(
                folder.resolve("w.sdf"),
                "<sdf version='1.7'><world name='w'><include><uri>model://inner_walls</uri></include></world></sdf>");
        Path picture = folder.resolve("w.svg");
        assertThat(run("render", sdf, "-o", picture)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(run("render", sdf, "-o", picture, "--models", FILES.resolve("sdf")))
                .isZero();
        assertThat(run("render", sdf, "-o", picture, "--models", "no")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("--models must be a folder that exists (got: no)");
        assertThat(run("view", sdf, "--models", "no")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("--models must be a folder that exists (got: no)");
    }

    @Test
    void aPipeIsNotWaitedFor() throws Exception {
        Path pipe = folder.resolve("w.xml");
        Path recording = folder.resolve("r.scenario.jsonl");
        Assumptions.assumeTrue(
                new ProcessBuilder("mkfifo", recording.toString()).start().waitFor() == 0);
        Assumptions.assumeTrue(
                new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() == 0);
        for (List<Object> line : List.<List<Object>>of(
                List.of("check", pipe),
                List.of("convert", pipe, folder + "/v.xml"),
                List.of("render", pipe, "-o", folder + "/w.svg"),
                List.of("view", pipe),
                List.of("view", recording),
                List.of("sweep", recording),
                List.of("replay", recording))) {
            assertThat(run(line.toArray())).as(line.toString()).isEqualTo(ExitCodes.UNUSABLE);
            assertThat(err.toString()).contains("regular file");
        }
    }

    @Test
    void checkTakesFoldersOfModels() throws IOException {
        Path sdf = Files.writeString(
                folder.resolve("w.sdf"),
                "<sdf version='1.7'><world name='w'><include><uri>model://inner_walls</uri></include></world></sdf>");
        assertThat(run("check", sdf)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("give the folder that contains the model", "1 problem");
        assertThat(run("check", sdf, "--models", FILES.resolve("sdf"))).isZero();
        assertThat(out.toString()).contains("objects   7: ", "verdict   fine");
        assertThat(run("check", sdf, "--models", "no")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("--models must be a folder that exists (got: no)");
    }

    @Test
    void badUsageAndBadFiles() throws IOException {
        Path xml = folder.resolve("w.xml");
        assertThat(run("convert", "no.sdf", xml)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("IN must be a file that exists; check the path (got: no.sdf)");
        assertThat(run("convert", FILES.resolve("sdf/shapes.sdf"), folder.resolve("w.png")))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("OUT must end in .xml, .glb or .obj (got: ");
        assertThat(run("convert", FILES.resolve("sdf/shapes.sdf"), Files.createDirectory(folder.resolve("d.xml"))))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("OUT must be a file, not a folder (got: ");
        assertThat(run("convert", FILES.resolve("sdf/shapes.sdf"), xml, "--scale", "0"))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("scale must be a number above 0, up to 2^100 (got: 0.0)");
        assertThat(run("convert", FILES.resolve("sdf/shapes.sdf"), xml, "--models", "no"))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith("--models must be a folder that exists (got: no)");
        Path broken = broken();
        assertThat(run("convert", broken, xml)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith(broken + ":2:13: this is not well-formed XML");
        assertThat(xml).doesNotExist();
    }
}
