package robosim.geometry.net.session;

import java.util.HashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** Log lines of one session, each said once for a world, and not without end: a peer must not fill the disk. */
public final class WarningLog {
    private static final int MOST = 1000;

    private final System.Logger log;
    private final String session;
    private final Set<String> said = new HashSet<>();
    private @Nullable LogBudget budget;
    private long message;

    public WarningLog(System.Logger log, String session) {
        this.log = log;
        this.session = session;
    }

    /** As many lines as that has left for them, from now on. */
    public void within(LogBudget shared) {
        budget = shared;
    }

    /** The next message: what is said from now on is about that one. */
    public void next() {
        message++;
    }

    /** A new world: what was said about the last one may be said again. */
    public void forget() {
        said.clear();
    }

    public void warn(String complaint) {
        if (said.size() < MOST && said.add(complaint)) {
            log(complaint);
            if (said.size() == MOST) {
                log(MOST + " warnings about this world; more are not logged");
            }
        }
    }

    private void log(String words) {
        String line = session + ", message " + message + ": " + words;
        if (budget == null) {
            log.log(System.Logger.Level.WARNING, line);
        } else {
            budget.log(log, System.Logger.Level.WARNING, line);
        }
    }
}
