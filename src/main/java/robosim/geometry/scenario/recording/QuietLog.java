package robosim.geometry.scenario.recording;

import java.util.ResourceBundle;
import org.jspecify.annotations.Nullable;

/** Logs the warnings of a replay at a low level, since they were given when it was recorded. */
public final class QuietLog implements System.Logger {
    private final System.Logger log = System.getLogger(QuietLog.class.getPackageName());

    @Override
    public String getName() {
        return log.getName();
    }

    @Override
    public boolean isLoggable(Level level) {
        return log.isLoggable(Level.DEBUG);
    }

    @Override
    public void log(
            Level level, @Nullable ResourceBundle bundle, @Nullable String message, @Nullable Throwable thrown) {
        log.log(Level.DEBUG, bundle, message, thrown);
    }

    @Override
    public void log(Level level, @Nullable ResourceBundle bundle, @Nullable String format, @Nullable Object... parts) {
        log.log(Level.DEBUG, bundle, format, parts);
    }
}
