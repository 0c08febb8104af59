package robosim.geometry.protocol.json;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** The published schema says of each number what it is in. */
class SchemaUnitsTest {
    private static final Pattern UNIT =
            Pattern.compile("radians|degrees|world units|metres|seconds|\\bkg\\b|\\bm/s\\b|1/s"
                    + "|newton|turns a minute|turns of|amperes|ohms|without a unit|srgb");

    private static final Pattern ANGLE =
            Pattern.compile("heading|turn|r[xy]|.*Radians|fieldOfView|elevations|maxTurn.*|maxSlope|angle");

    private static JsonNode schema;

    private record Property(String path, String name, JsonNode schema) {}

    @BeforeAll
    static void read() throws IOException {
        schema =
                new ObjectMapper().readTree(Path.of("docs/protocol.schema.json").toFile());
    }

    private static List<Property> properties(JsonNode node, String path) {
        List<Property> found = new ArrayList<>();
        for (Map.Entry<String, JsonNode> member : node.properties()) {
            String below = path + "/" + member.getKey();
            if (member.getKey().equals("properties")) {
                member.getValue()
                        .properties()
                        .forEach(each -> found.add(new Property(below, each.getKey(), each.getValue())));
            }
            found.addAll(properties(member.getValue(), below));
        }
        if (node.isArray()) {
            node.forEach(each -> found.addAll(properties(each, path)));
        }
        return found;
    }

    private static JsonNode target(JsonNode node) {
        return schema.at(node.path("$ref").asText().substring(1));
    }

    /** What the numbers are that a value is, or that its items are; empty if they are none. */
    private static String type(JsonNode node) {
        String type = node.path("type").asText();
        if (node.has("$ref")) {
            return type(target(node));
        }
        if (type.equals("number") || type.equals("integer")) {
            return type;
        }
        if (type.equals("array")) {
            return type(node.path("items"));
        }
        for (String choice : List.of("anyOf", "oneOf")) {
            for (JsonNode each : node.path(choice)) {
                if (!type(each).isEmpty()) {
                    return type(each);
                }
            }
        }
        return "";
    }

    /** Its own description, or that of what it refers to if that one has the unit. */
    private static String description(JsonNode node) {
        String own = node.path("description").asText().toLowerCase(Locale.ROOT);
        return UNIT.matcher(own).find() || !node.has("$ref") ? own : own + description(target(node));
    }

    @Test
    void everyNumberHasAUnit() {
        int numbers = 0;
        int wholes = 0;
        for (Property each : properties(schema, "")) {
            String what = each.path + "/" + each.name;
            if (type(each.schema).equals("number")) {
                numbers++;
                assertThat(description(each.schema)).as(what).containsPattern(UNIT);
            } else if (type(each.schema).equals("integer")) {
                wholes++;
                assertThat(description(each.schema)).as(what).isNotBlank();
            }
        }
        assertThat(numbers).isGreaterThan(130);
        assertThat(wholes).isGreaterThan(40);
    }

    @Test
    void everyAngleIsInRadians() {
        int angles = 0;
        for (Property each : properties(schema, "")) {
            if (type(each.schema).equals("number") && ANGLE.matcher(each.name).matches()) {
                angles++;
                assertThat(description(each.schema))
                        .as(each.path + "/" + each.name)
                        .contains("radians");
            }
        }
        assertThat(angles).isGreaterThan(40);
    }
}
