package robosim.geometry.cli.network;

import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.Map;
import java.util.logging.Formatter;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.JsonText;

/** How the log of {@code serve} and {@code connect} is written: a line for each entry, with its time in UTC and its level. */
public final class LogLines extends Formatter {
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern(
                    "uuuu-MM-dd'T'HH:mm:ss.SSS'Z'", Locale.ROOT)
            .withZone(ZoneOffset.UTC);

    private final Form form;

    public enum Form {
        /** Time, level and message. */
        TEXT,
        JSON
    }

    LogLines(Form form) {
        this.form = form;
    }

    /** Lets the console have this form, unless Java's logging has been configured otherwise. */
    static void use(Form form) {
        boolean isConfigured = System.getProperty("java.util.logging.config.file") != null
                || System.getProperty("java.util.logging.config.class") != null;
        try {
            if (!isConfigured) {
                for (Handler handler : Logger.getLogger("").getHandlers()) {
                    handler.setFormatter(new LogLines(form));
                }
            }
        } catch (NoClassDefFoundError e) {
            return; // without java.logging the JDK writes lines of its own
        }
    }

    @Override
    public String format(LogRecord entry) {
        String time = TIME.format(entry.getInstant());
        String level = level(entry.getLevel());
        String message = formatMessage(entry);
        Throwable thrown = entry.getThrown();
        if (form == Form.TEXT) {
            String line = time + " " + level + " " + message + (thrown == null ? "" : ": " + stack(thrown));
            return line.replace('\n', ' ').replace('\r', ' ') + System.lineSeparator();
        }
        Map<String, @Nullable Object> fields =
                JsonText.fields("time", time, "level", level, "logger", entry.getLoggerName(), "message", message);
        if (thrown != null) {
            fields.put("error", stack(thrown));
        }
        return JsonText.of(fields) + System.lineSeparator();
    }

    /** The names of System.Logger, with which the lines are written. */
    private static String level(Level level) {
        int value = level.intValue();
        if (value >= Level.SEVERE.intValue()) {
            return "ERROR";
        }
        if (value >= Level.WARNING.intValue()) {
            return "WARNING";
        }
        return value >= Level.INFO.intValue() ? "INFO" : value >= Level.FINE.intValue() ? "DEBUG" : "TRACE";
    }

    private static String stack(Throwable thrown) {
        StringBuilder text = new StringBuilder();
        for (Throwable each = thrown; each != null; each = each.getCause()) {
            text.append(each == thrown ? "" : "; caused by ").append(each);
            for (StackTraceElement frame : each.getStackTrace()) {
                text.append("; at ").append(frame);
            }
        }
        return text.toString();
    }
}
