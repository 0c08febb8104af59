package robosim.geometry.net.session;

import java.util.HashSet;
import java.util.Set;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;

/**
 * The warnings of one session: each is logged once per world, and their number is limited, so that a peer cannot fill
 * the disk.
 */
public final class WarningLog {
    private static final int MOST = 1000;

    private final System.Logger log;
    private final String session;
    private final Set<String> said = new HashSet<>();
    private @Nullable LogBudget budget;
    private long message;
    private LongSupplier number = () -> message;

    public WarningLog(System.Logger log, String session) {
        this.log = log;
        this.session = session;
    }

    /** Limits the lines from now on by a shared budget. */
    public void within(LogBudget shared) {
        budget = shared;
    }

    /** Takes the numbers of messages from elsewhere from now on. */
    public void numbered(LongSupplier messages) {
        number = messages;
    }

    /** Starts the next message, to which warnings from now on refer. */
    public void next() {
        message++;
    }

    /** Starts a new world: warnings about the last one may be logged again. */
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
        String line = session + ", message " + number.getAsLong() + ": " + words;
        if (budget == null) {
            log.log(System.Logger.Level.WARNING, line);
        } else {
            budget.log(log, System.Logger.Level.WARNING, line);
        }
    }
}
