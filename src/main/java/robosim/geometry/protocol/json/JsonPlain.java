package robosim.geometry.protocol.json;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** Reads an object whose fields are not known beforehand: Strings, Doubles, Booleans, nulls and nested objects. */
final class JsonPlain {
    private JsonPlain() {}

    /** Reads the whole line. */
    static Map<String, @Nullable Object> read(JsonInput in) throws IOException {
        in.begin();
        Map<String, @Nullable Object> fields = fields(in);
        in.end();
        return fields;
    }

    private static Map<String, @Nullable Object> fields(JsonInput in) throws IOException {
        if (!in.isObject()) {
            throw in.refused("must be an object, {...} (got: " + in.kind() + ")");
        }
        Map<String, @Nullable Object> fields = new LinkedHashMap<>();
        for (String name = in.nextField(); name != null; name = in.nextField()) {
            if (fields.containsKey(name)) {
                throw in.refused("a field must occur only once (got: " + in.told(name) + " twice)");
            }
            fields.put(name, value(in));
        }
        return fields;
    }

    private static @Nullable Object value(JsonInput in) throws IOException {
        if (in.isObject()) {
            return fields(in);
        }
        if (in.isText()) {
            return in.text();
        }
        if (in.isNumber()) {
            return in.number();
        }
        if (in.isFlag()) {
            return in.flag();
        }
        if (in.isNull()) {
            return null;
        }
        throw in.refused("must be an object, a string, a number, true, false or null (got: " + in.kind() + ")");
    }
}
