package robosim.geometry.cli.terminal;

import java.io.PrintWriter;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.scenario.AnswerProofs;

/** Which share of the answers commands prove, and what came of it. */
public final class ProofOptions {
    /** Where failures are stored. */
    private static final Path FOLDER = Path.of("failed-proofs");

    @Option(
            names = "--prove",
            paramLabel = "SHARE",
            arity = "0..1",
            fallbackValue = "1",
            description =
                    "prove this share of the answers, from 0 to 1 (all, if no share is given), and check the proofs:"
                            + " moves, distances, and bodies after steps; what fails is stored as scenarios in the folder"
                            + " failed-proofs (default: none)")
    private double share;

    private @Nullable AnswerProofs proofs;

    /** For sessions with some options; null if nothing is to be proved. */
    public @Nullable AnswerProofs of(SessionOptions options) {
        Arguments.refuse(!(share >= 0 && share <= 1), "--prove must be from 0 to 1", share);
        if (share == 0) {
            return null;
        }
        proofs = proofs == null ? new AnswerProofs(share, options, FOLDER) : proofs.with(options);
        return proofs;
    }

    /** A listener for the session of a name with some options; one that does nothing if nothing is to be proved. */
    public SessionListener listener(String session, SessionOptions options) {
        AnswerProofs answers = of(options);
        return answers == null ? SessionListener.NONE : answers.apply(session);
    }

    /** Tells what came of it, if anything was to be proved; whether no proof failed. */
    public boolean tell(PrintWriter out) {
        if (proofs == null) {
            return true;
        }
        out.println(proofs);
        out.flush();
        return proofs.failed() == 0;
    }
}
