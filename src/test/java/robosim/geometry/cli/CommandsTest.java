package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CommandsTest {
    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return Commands.run(new PrintWriter(out, true), new PrintWriter(err, true), arguments);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', textBlock = """
                    fly                                  | Unmatched argument at index 0: 'fly'
                    demo --steps 0                       | --steps must be at least 1 (got: 0)
                    demo --steps many                    | 'many' is not an int
                    demo --seed -1                       | --seed must be at least 0 (got: -1)
                    demo --speed NaN                     | --speed must be above 0 (got: NaN)
                    demo --world nowhere.xml             | (got: nowhere.xml)
                    demo --examples nowhere              | (got: nowhere/ReferenceEnvironment.java)
                    serve                                | Missing required parameter: 'PORT'
                    serve 70000                          | PORT must be 0 to 65535 (got: 70000)
                    connect localhost                    | Missing required parameter: 'PORT'
                    connect localhost 0                  | PORT must be 1 to 65535 (got: 0)
                    render worlds/rooms.xml              | Missing required option: '--output=FILE'
                    render worlds/rooms.xml -o a.gif     | FILE must end in .svg or .png (got: a.gif)
                    render nowhere.xml -o a.png          | WORLD must be a file; there is none, check the path (got: nowhere.xml)
                    render worlds -o a.png               | WORLD must be a file; this is a folder, name one in it (got: worlds)
                    render pom.xml -o a.png              | pom.xml
                    """)
    void badArgumentsAreRefusedWithTheirReason(String line, String reason) {
        assertThat(run(line.split(" "))).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains(reason).doesNotContain("\tat ");
        assertThat(out.toString()).isEmpty();
    }

    @Test
    void nothingAtAllShowsTheCommands() {
        assertThat(run()).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("demo", "serve", "connect", "render");
    }

    @Test
    void aWorldIsDrawn(@TempDir Path folder) throws Exception {
        Path svg = folder.resolve("rooms.svg");
        assertThat(run("render", "worlds/rooms.xml", "-o", svg.toString())).isZero();
        assertThat(Files.readString(svg)).contains(">rooms<", "drum 1", "scale-bar");
        Path png = folder.resolve("rooms.png");
        assertThat(run("render", "worlds/rooms.xml", "--dark", "-o", png.toString()))
                .isZero();
        assertThat(png).isNotEmptyFile();
    }
}
