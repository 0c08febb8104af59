package robosim.geometry.scenario.source;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.Reply;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.Step;

/**
 * Reads a conversation from its bytes: a file of the bytes sent to the module and one of those it sent, as the demo's
 * environment writes them.
 */
public final class WireReader implements StepReader {
    private final Path toModule;
    private final InputStream asked;
    private final InputStream answered;
    private final MessageReader requests;
    private final MessageReader answers;
    private final ScenarioHeader header;
    private long steps;

    private WireReader(Path toModule, InputStream asked, InputStream answered) {
        this.toModule = toModule;
        this.asked = asked;
        this.answered = answered;
        this.requests = new MessageReader(asked);
        this.answers = new MessageReader(answered);
        this.header = new ScenarioHeader(String.valueOf(toModule.getFileName()), "", SessionOptions.ROBOSIM);
    }

    /** Opens the two files of a conversation, which must exist. */
    public static WireReader open(Path toModule, Path fromModule) throws IOException {
        Checks.present("fromModule", fromModule);
        InputStream asked = new BufferedInputStream(Files.newInputStream(Checks.present("toModule", toModule)));
        try {
            return new WireReader(toModule, asked, new BufferedInputStream(Files.newInputStream(fromModule)));
        } catch (IOException e) {
            asked.close();
            throw e;
        }
    }

    @Override
    public ScenarioHeader header() {
        return header;
    }

    @Override
    public @Nullable Step next() throws IOException {
        Bundle request = requests.read();
        if (request == null) {
            if (answers.read() != null) {
                throw refused("an answer in the other file must have its request (got: one more)", null);
            }
            return null;
        }
        steps++;
        if (request.isAnswer()) {
            throw refused(
                    "a request must be an InitBundle, a MoveBundle, a SonarRequestBundle, a BatchRequestBundle or a"
                            + " StepBundle (got: "
                            + (request instanceof DistanceBundle ? "distances" : "answers") + ")",
                    null);
        }
        if (request instanceof InitBundle) {
            return new Step(request, null);
        }
        Bundle answer = answers.read();
        if (answer == null) {
            throw refused("a request must have its answer in the other file (got: its end)", null);
        }
        try {
            return new Step(request, new Reply(answer));
        } catch (IllegalArgumentException e) {
            throw refused(String.valueOf(e.getMessage()), e);
        }
    }

    private IOException refused(String problem, @Nullable Throwable cause) {
        return new IOException(toModule + ", message " + steps + ": " + problem, cause);
    }

    @Override
    public void close() throws IOException {
        try (answered) {
            asked.close();
        }
    }
}
