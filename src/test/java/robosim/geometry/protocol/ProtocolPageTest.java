package robosim.geometry.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.NetOptions;
import robosim.geometry.scenario.drive.WorldLoading;

/** docs/protocol.md shows a conversation as it is. */
class ProtocolPageTest {
    private static final String TO = "--> ";
    private static final String FROM = "<-- ";

    /** Every type of message and every kind of request that the schema has is in the conversation. */
    @Test
    void theConversationHasEveryMessage() throws IOException {
        String said = String.join(
                "\n",
                Files.readAllLines(Path.of("docs", "protocol.md")).stream()
                        .filter(line -> line.startsWith(TO) || line.startsWith(FROM))
                        .toList());
        JsonNode schema = new ObjectMapper()
                .readTree(Files.readString(Path.of("docs", "protocol.schema.json")))
                .get("$defs");
        int shown = 0;
        for (String end : List.of("toModule", "fromModule")) {
            for (JsonNode message : schema.get(end).findValues("$ref")) {
                JsonNode type = schema.at(message.asText().substring("#/$defs".length()) + "/properties/type/const");
                assertThat(said).contains("{\"type\":" + type);
                shown++;
            }
        }
        for (JsonNode request :
                schema.at("/batch/properties/requests/items/oneOf").findValues("$ref")) {
            JsonNode kind = schema.at(request.asText().substring("#/$defs".length()) + "/properties/kind/const");
            assertThat(said).contains("{\"kind\":" + kind);
            shown++;
        }
        assertThat(shown).isGreaterThanOrEqualTo(26);
        assertThat(said).contains("\"identify\":true", "\"answer\":true", "{\"kind\":\"sense\",\"mount\"");
    }

    @Test
    @Timeout(60)
    void theConversationOnThePageIsHeldToTheLetter() throws IOException {
        List<String> page = Files.readAllLines(Path.of("docs", "protocol.md"));
        int asked = 0;
        int answered = 0;
        try (GeometryServer server = new GeometryServer(
                        InetAddress.getLoopbackAddress(),
                        0,
                        NetOptions.defaults().withWorlds(WorldLoading.of(null, List.of())));
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            OutputStream out = socket.getOutputStream();
            BufferedReader in =
                    new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
            for (String line : page) {
                if (line.startsWith(TO)) {
                    out.write((line.substring(TO.length()) + "\n").getBytes(StandardCharsets.UTF_8));
                    asked++;
                } else if (line.startsWith(FROM)) {
                    assertThat(in.readLine()).isEqualTo(line.substring(FROM.length()));
                    answered++;
                }
            }
            assertThat(in.readLine()).as("after the error").isNull();
        }
        assertThat(asked).isEqualTo(16);
        assertThat(answered).isEqualTo(15);
    }
}
