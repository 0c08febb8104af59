package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.world.shared.Limits;

/** What is not well-formed XML, or not with namespaces, and what Gazebo's parsers read nevertheless. */
@Timeout(60)
class LenientXmlTest {
    private static final String BALL = "<model name='m'><link name='l'><collision name='c'><geometry><sphere>"
            + "<radius>0.5</radius></sphere></geometry></collision></link></model>";

    @TempDir
    Path folder;

    private Path file(String name, byte[] bytes) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.write(file, bytes);
    }

    private Path file(String name, String text) throws IOException {
        return file(name, text.getBytes(StandardCharsets.UTF_8));
    }

    private static WorldImport read(Path file) throws WorldException {
        WorldImport read = WorldImport.read(file, ImportOptions.DEFAULT);
        assertThat(read.world().objects()).hasSize(1);
        return read;
    }

    /** As models of PX4 have them. */
    @Test
    void prefixesNeedNotBeDeclared() throws IOException {
        WorldImport read = read(file("a.sdf", """
                <sdf version='1.9'><model name='m'><link name='l'>
                <collision name='c'><geometry><sphere><radius>0.5</radius></sphere></geometry>
                <surface><friction><ode><fdir1 gz:expressed_in='l'>1 0 0</fdir1></ode></friction></surface></collision>
                <sensor name='s' type='custom' gz:type='optical_flow'/></link>
                <gz:semantics><a/></gz:semantics><ignition:policies/>
                <plugin name='p' filename='f'><gz::system_priority>3</gz::system_priority></plugin></model></sdf>
                """));
        assertThat(read.isWhole()).isTrue();
        assertThat(read.remarks()).isEmpty();
        WorldImport urdf = read(file("a.urdf", """
                <robot name='r'><link name='l'><collision><geometry><sphere radius='1'/></geometry></collision></link>
                <gz:plugin gz:a='b'/></robot>
                """));
        assertThat(urdf.isWhole()).isTrue();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '^',
            nullValues = "none",
            value = {
                "^ <?xml version='1.0' ?>^|1: this is not well-formed XML, and was read nevertheless, as Gazebo does: its declaration",
                "<!-- by us --><?xml version='1.0' encoding='utf-8'?>|1: this is not well-formed XML, and was read nevertheless, as Gazebo does: its declaration",
                "<?xml version='1.0' ?encoding='utf-8'?>|1: this is not well-formed XML, and was read nevertheless, as Gazebo does: its declaration",
                "<!-- a -- b -->|1: this is not well-formed XML, and was read nevertheless, as Gazebo does: a comment has",
                "<!------- a --->|1: this is not well-formed XML, and was read nevertheless, as Gazebo does: a comment has",
                "<?xml version='1.0'?>|none",
                "<!-- & < > ]]> -->|none"
            })
    void theProlog(String prolog, String remark) throws IOException {
        for (String name : List.of("a.sdf", "a.urdf")) {
            String text = name.equals("a.sdf")
                    ? "<sdf version='1.6'>" + BALL + "<frob/>\n<frob/></sdf>"
                    : "<robot name='r'><link name='l'><collision><geometry><sphere radius='1'/></geometry></collision>"
                            + "</link>\n<link name='k'><collision><geometry><frob/></geometry></collision></link>"
                            + "<joint name='j'><parent link='l'/><child link='k'/></joint></robot>";
            Path file = file(name, prolog + "\r\n" + text);
            WorldImport read = read(file);
            if (remark == null) {
                assertThat(read.remarks()).isEmpty();
            } else {
                assertThat(read.remarks()).singleElement().asString().startsWith(file + ":" + remark);
            }
            // Lines are those of the file.
            assertThat(read.skipped()).extracting(Skipped::line).contains(3);
        }
    }

    @Test
    void anAmpersandAndBytesOfAnotherEncoding() throws IOException {
        String text =
                "<sdf version='1.6'>\n<!-- M\u00fcller & S\u00f6hne -->\n" + BALL.replace("'m'", "'A & B'") + "</sdf>";
        Path file = file("a.sdf", text.getBytes(StandardCharsets.ISO_8859_1));
        WorldImport read = read(file);
        assertThat(read.world().objects().get(0).object().name()).isEqualTo("A & B");
        assertThat(read.remarks())
                .satisfiesExactly(
                        bytes -> assertThat(bytes).startsWith(file + ":2: ").contains("bytes that are not UTF-8"),
                        and -> assertThat(and).startsWith(file + ":3: ").contains("an & that is not written as &amp;"));
        // An encoding that is declared is kept.
        String declared = "<?xml version='1.0' encoding='ISO-8859-1'?><sdf version='1.6'><!-- -- -->"
                + BALL.replace("'m'", "'M\u00fcller'") + "</sdf>";
        assertThat(read(file("b.sdf", declared.getBytes(StandardCharsets.ISO_8859_1)))
                        .world()
                        .objects()
                        .get(0)
                        .object()
                        .name())
                .isEqualTo("M\u00fcller");
    }

    @Test
    void aModelConfig() throws IOException {
        file("m/ball.sdf", "<sdf version='1.6'>" + BALL + "</sdf>");
        file(
                "m/model.config",
                "\n<?xml version='1.0'?>\n<model xmlns='a'><name>A & B</name><gz:x/><!-- -- -->"
                        + "<sdf version='1.6'>ball.sdf</sdf></model>");
        WorldImport read = read(folder.resolve("m"));
        assertThat(read.isWhole()).isTrue();
        assertThat(read.remarks())
                .hasSize(3)
                .allSatisfy(each -> assertThat(each)
                        .contains("model.config:", "this is not well-formed XML, and was read nevertheless"));
    }

    /** Which Gazebo refuses too, or which is never read. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "<sdf version='1.6'>\n<model name=m/></sdf>|2:13: this is not well-formed XML: Open quote is expected",
                "<sdf version='1.6'>\n<model name='m'></sdf>|2:19: this is not well-formed XML: The element type \"model\"",
                "<!-- -- -->\n<!DOCTYPE sdf><sdf version='1.6'/>|2:10: a document type is not allowed",
                "<!-- -- --><sdf version='1.6'>\n<model name='&x;'/></sdf>|2:17: this is not well-formed XML: The entity \"x\"",
                "<!-- -- --> text\n<sdf/>|1:13: this is not well-formed XML: Content is not allowed in prolog"
            })
    void whatIsRefused(String text) throws IOException {
        String[] parts = text.split("\\|", 2);
        Path file = file("a.sdf", parts[0]);
        assertThatThrownBy(() -> WorldImport.read(file, ImportOptions.DEFAULT))
                .isInstanceOf(WorldException.class)
                .hasMessageStartingWith(file + ":" + parts[1]);
    }

    @Test
    void theLimitsHold() throws IOException {
        Path file =
                file("a.sdf", "<!-- -- --><sdf version='1.6'><!--" + " --".repeat(Limits.MAX_MARKUP / 3) + "--></sdf>");
        assertThatThrownBy(() -> WorldImport.read(file, ImportOptions.DEFAULT))
                .hasMessageContaining("a tag with its attributes, a comment");
        Path deep = file("b.sdf", "<!-- -- --><sdf version='1.6'>" + "<a>".repeat(Limits.MAX_DEPTH));
        assertThatThrownBy(() -> WorldImport.read(deep, ImportOptions.DEFAULT))
                .hasMessageContaining("elements must be nested at most");
    }
}
