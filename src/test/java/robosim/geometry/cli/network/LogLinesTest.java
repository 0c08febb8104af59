package robosim.geometry.cli.network;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.time.Instant;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import org.junit.jupiter.api.Test;

class LogLinesTest {
    private static LogRecord entry(Level level, String message) {
        LogRecord entry = new LogRecord(level, message);
        entry.setInstant(Instant.parse("2026-11-26T04:50:01.0239Z"));
        entry.setLoggerName("robosim.geometry.net");
        return entry;
    }

    @Test
    void aLineHasTimeAndLevel() {
        LogLines text = new LogLines(LogLines.Form.TEXT);
        assertThat(text.format(entry(Level.WARNING, "server 5555, {0} is 100%")))
                .isEqualTo("2026-11-26T04:50:01.023Z WARNING server 5555, {0} is 100%" + System.lineSeparator());
        assertThat(text.format(entry(Level.INFO, "a\nb"))).contains(" INFO a b");
        assertThat(text.format(entry(Level.FINE, "a"))).contains(" DEBUG a");
    }

    @Test
    void anErrorIsOneLineToo() throws Exception {
        LogRecord entry = entry(Level.SEVERE, "an \"error\"");
        entry.setThrown(new IllegalStateException("why\nnot", new RuntimeException("because")));
        String text = new LogLines(LogLines.Form.TEXT).format(entry);
        assertThat(text)
                .startsWith(
                        "2026-11-26T04:50:01.023Z ERROR an \"error\": java.lang.IllegalStateException: why not; at ")
                .contains("LogLinesTest.anErrorIsOneLineToo", "; caused by java.lang.RuntimeException: because");
        assertThat(text.strip()).doesNotContain("\n");
        String json = new LogLines(LogLines.Form.JSON).format(entry);
        assertThat(json.strip())
                .doesNotContain("\n")
                .startsWith("{\"time\":\"2026-11-26T04:50:01.023Z\",\"level\":\"ERROR\"");
        try (JsonParser parser = new JsonFactory().createParser(json)) {
            int fields = 0;
            for (JsonToken token = parser.nextToken(); token != null; token = parser.nextToken()) {
                fields += token == JsonToken.FIELD_NAME ? 1 : 0;
            }
            assertThat(fields).isEqualTo(5);
        }
    }
}
