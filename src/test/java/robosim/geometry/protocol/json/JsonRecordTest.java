package robosim.geometry.protocol.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.model.Dimension;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.ProtocolException;

class JsonRecordTest {
    @Test
    void whatIsWrittenIsRead() throws ProtocolException {
        Map<String, Object> inner = new LinkedHashMap<>();
        inner.put("dimension", Dimension.SPATIAL);
        inner.put("max", Double.POSITIVE_INFINITY);
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("text", "line\nfeed, \"quotes\", \u00fc, \ud83d\ude00");
        fields.put("number", 0.1);
        fields.put("whole", 1L << 53);
        fields.put("flag", true);
        fields.put("inner", inner);
        String line = JsonRecord.write(fields);
        assertThat(line).doesNotContain("\n").contains("{\"dimension\":\"SPATIAL\",\"max\":null}");
        JsonRecord record = JsonRecord.read(line).only("text number whole inner", "flag other");
        assertThat(record.text("text")).isEqualTo(fields.get("text"));
        assertThat(record.number("number")).isEqualTo(0.1);
        assertThat(record.whole("whole", 0, 1L << 53)).isEqualTo(1L << 53);
        assertThat(record.has("other")).isFalse();
        assertThat(record.record("inner").constant("dimension", Dimension.class))
                .isEqualTo(Dimension.SPATIAL);
        assertThat(record.record("inner").isNull("max")).isTrue();
        assertThat(record.isNull("other")).isFalse();
    }

    @Test
    void whatIsOfAnotherKindIsRefusedWithItsPlace() throws ProtocolException {
        JsonRecord record = JsonRecord.read("{\"a\":{\"b\":1.5,\"c\":null},\"d\":\"x\"}");
        assertThatThrownBy(() -> record.text("a")).hasMessage("at /a: must be a string (got: another)");
        assertThatThrownBy(() -> record.number("e")).hasMessage("at /e: must be a number (got: null or none)");
        assertThatThrownBy(() -> record.record("a").whole("b", 0, 9))
                .hasMessage("at /a/b: must be a whole number from 0 to 9 (got: 1.5)");
        assertThatThrownBy(() -> record.record("a").record("c")).hasMessageStartingWith("at /a/c: must be an object");
        assertThatThrownBy(() -> record.constant("d", Dimension.class))
                .hasMessage("at /d: must be one of [PLANAR, SPATIAL] (got: \"x\")");
        assertThatThrownBy(() -> record.only("a", "")).hasMessageContaining("one of a (got: \"d\")");
        assertThatThrownBy(() -> record.only("a d f", "")).hasMessageContaining("the field \"f\" (got: none)");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                " ",
                "1",
                "[]",
                "{",
                "{}}",
                "{} {}",
                "{\"a\":1,\"a\":1}",
                "{\"a\":[1]}",
                "{\"a\":NaN}",
                "{'a':1}",
                "{\"a\":1e999}",
                "{\"a\":\"\\ud800\"}"
            })
    void otherLinesAreRefused(String line) {
        assertThatThrownBy(() -> JsonRecord.read(line)).isInstanceOf(ProtocolException.class);
    }

    @ParameterizedTest
    @ValueSource(ints = {10, 63, 70, 100_000})
    void depthIsLimited(int depth) throws ProtocolException {
        String line = "{\"a\":".repeat(depth) + "1" + "}".repeat(depth);
        if (depth < MessageLimits.MAX_DEPTH) {
            assertThat(JsonRecord.read(line).has("a")).isTrue();
        } else {
            assertThatThrownBy(() -> JsonRecord.read(line))
                    .isInstanceOf(ProtocolException.class)
                    .hasMessageContaining("deep");
        }
    }

    @Test
    void repliesAreToldFromRequests() throws ProtocolException {
        assertThat(JsonLines.isReply("{\"moves\":[{\"refused\":1}],\"type\":\"moves\"}"))
                .isFalse();
        assertThat(JsonLines.isReply("{\"refused\":[],\"moves\":[],\"type\":\"moves\"}"))
                .isTrue();
        assertThat(JsonLines.isReply("{\"type\":\"distances\",\"distances\":[]}"))
                .isTrue();
        assertThat(JsonLines.isReply("{\"type\":\"note\",\"refused\":[]}")).isFalse();
        assertThatThrownBy(() -> JsonLines.isReply("{\"refused\":[]}")).isInstanceOf(ProtocolException.class);
    }
}
