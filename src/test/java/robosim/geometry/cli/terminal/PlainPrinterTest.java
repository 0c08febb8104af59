package robosim.geometry.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Test;

class PlainPrinterTest {
    private final ByteArrayOutputStream terminal = new ByteArrayOutputStream();
    private final PlainPrinter out = new PlainPrinter(terminal, StandardCharsets.UTF_8);

    private String printed() {
        out.flush();
        String text = terminal.toString(StandardCharsets.UTF_8);
        terminal.reset();
        return text;
    }

    @Test
    void whatControlsATerminalIsEscaped() {
        Path name = Path.of("a\u001b]0;title\u0007\u009b2J\r\u202eb.xml");
        String shown = "a\\u001b]0;title\\u0007\\u009b2J\\u000d\\u202eb.xml";
        out.println("no such file: " + name);
        assertThat(printed()).isEqualTo("no such file: " + shown + System.lineSeparator());
        out.printf(Locale.ROOT, "%s: %d%n", name, 3);
        out.print('\u001b');
        out.write(new char[] {'x', '\b', 'y'}, 1, 2);
        out.write(7);
        assertThat(printed()).isEqualTo(shown + ": 3" + System.lineSeparator() + "\\u001b\\u0008y\\u0007");
    }

    @Test
    void textStaysAsItIs() {
        String text = "\tr\u00e4uber \ud83e\udd16, 3 m\u00b2\r\nnext\n";
        out.print(text);
        assertThat(printed()).isEqualTo(text);
        out.control("\r\u001b[K");
        assertThat(printed()).isEqualTo("\r\u001b[K");
    }
}
