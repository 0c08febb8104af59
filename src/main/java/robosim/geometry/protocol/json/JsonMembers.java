package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;

/** An object that is being read. */
final class JsonMembers {
    private final JsonInput in;
    private final Fields fields;
    private long seen;
    private boolean mayHaveId;
    private boolean hasId;

    JsonMembers(JsonInput in, Fields fields) {
        this.in = in;
        this.fields = fields;
    }

    /** These members, among which an id may be, which is read here. */
    JsonMembers withId() {
        mayHaveId = true;
        return this;
    }

    /** Goes to the value of the next field and returns its number; -1 at the end, if no field is missing. */
    int next() throws IOException {
        if (in.advance() != JsonToken.FIELD_NAME) {
            int missing = fields.missing(seen);
            if (missing >= 0) {
                throw in.refused("must have the field \"" + fields.name(missing) + "\" (got: none)");
            }
            return -1;
        }
        String name = in.fieldName();
        int index = fields.indexOf(name);
        if (index < 0 && mayHaveId && name.equals("id") && !hasId) {
            hasId = true;
            in.advance();
            in.readId();
            return next();
        }
        if (index < 0 && !(hasId && name.equals("id"))) {
            throw in.refused(
                    "a field must be one of " + fields + (mayHaveId ? ", id" : "") + " (got: " + in.told(name) + ")");
        }
        if (index < 0 || (seen & 1L << index) != 0) {
            throw in.refused("a field must occur only once (got: \"" + name + "\" twice)");
        }
        seen |= 1L << index;
        in.advance();
        return index;
    }

    boolean has(int index) {
        return (seen & 1L << index) != 0;
    }
}
