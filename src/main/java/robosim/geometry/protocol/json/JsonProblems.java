package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.exc.StreamConstraintsException;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Text;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.ProtocolException;

/** What is wrong with a line of JSON, in words: where, what must be there, and what is there unless it may be secret. */
final class JsonProblems {
    private final JsonParser parser;
    private final boolean discreet;

    JsonProblems(JsonParser parser, boolean discreet) {
        this.parser = parser;
        this.discreet = discreet;
    }

    /** An exception about the current value, which is JSON but not what must be there. */
    ProtocolException refused(String what) {
        return ProtocolException.ofRequest(place() + what, null);
    }

    /** An exception after which nothing more can be read: this is no JSON, or exceeds a limit of all messages. */
    ProtocolException unreadable(String what) {
        return new ProtocolException(place() + what);
    }

    /** Where the current value is. */
    String place() {
        return place(null);
    }

    /** Where a member of the current object is; of null, where the value itself is. */
    String place(@Nullable String member) {
        String pointer =
                discreet ? "" : parser.getParsingContext().pathAsPointer() + (member == null ? "" : "/" + member);
        return pointer.isEmpty() ? "the message: " : "at " + Text.line(pointer) + ": ";
    }

    static String numberTooLong() {
        return "a number must have at most " + JsonInput.MAX_NUMBER_LENGTH + " characters (got: more)";
    }

    static String tooLong() {
        return "a string must have at most " + MessageLimits.MAX_TEXT_BYTES + " bytes (got: more)";
    }

    /** The parser's message without its advice, which is meant for programmers. */
    ProtocolException noJson(JsonProcessingException e) {
        String words = String.valueOf(e.getOriginalMessage());
        if (e instanceof StreamConstraintsException) {
            return unreadable(beyond(words));
        }
        int column = e.getLocation() == null ? 0 : e.getLocation().getColumnNr();
        String what = "must be JSON (RFC 8259), which ends at column " + column;
        if (discreet) {
            return unreadable(what);
        }
        String told = Text.line(words.replaceFirst("(?s)(: | \\()?(was expecting|enable `|maybe a ).*", ""));
        String remedy = words.matches("(?s).*'[-+]?(?i:nan|inf).*")
                ? "; numbers are finite, and no echo or an unlimited range is null"
                : "";
        return unreadable(what + remedy + " (got: " + told + ")");
    }

    // Each as Jackson since 2.16 has it, and as 2.15.
    private static String beyond(String words) {
        if (words.startsWith("Document nesting depth") || words.startsWith("Depth ")) {
            return "nesting must be at most " + MessageLimits.MAX_DEPTH + " deep (got: more)";
        }
        if (words.startsWith("Number value length") || words.startsWith("Number length")) {
            return numberTooLong();
        }
        return words.startsWith("String value length")
                        || words.startsWith("String length")
                        || words.startsWith("Name length")
                ? tooLong()
                : words;
    }

    /** Quotes a value for a message, unless it may be secret. */
    String told(String text) {
        return discreet ? "another" : Text.quoted(text);
    }

    /** The type of the current value, for a message. */
    String kind() {
        JsonToken token = parser.currentToken();
        if (token == null) {
            return "nothing";
        }
        return switch (token) {
            case START_OBJECT -> "an object";
            case START_ARRAY -> "a list";
            case VALUE_STRING -> "a string";
            case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> "a number";
            case VALUE_TRUE -> "true";
            case VALUE_FALSE -> "false";
            case VALUE_NULL -> "null";
            default -> "something else";
        };
    }
}
