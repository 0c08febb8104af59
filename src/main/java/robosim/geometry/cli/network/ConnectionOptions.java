package robosim.geometry.cli.network;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.BiConsumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Option;
import robosim.geometry.cli.terminal.Arguments;
import robosim.geometry.cli.terminal.UsageException;
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.Tls;
import robosim.geometry.protocol.MessageLimits;

/** Options that {@code serve} and {@code connect} share. Passwords and secrets are never arguments. */
public final class ConnectionOptions {
    @Option(
            names = "--resume",
            paramLabel = "SECONDS",
            defaultValue = "0",
            description =
                    "how long the session of a dropped connection is kept for a peer that asked for that and dials"
                            + " again (default: ${DEFAULT-VALUE}, not at all)")
    private int resume;

    @Option(
            names = "--stall",
            paramLabel = "SECONDS",
            defaultValue = "10",
            description = "longest pause within a message, in or out, before the connection is closed (default:"
                    + " ${DEFAULT-VALUE})")
    private int stall;

    @Option(
            names = "--message-time",
            paramLabel = "SECONDS",
            defaultValue = "60",
            description = "longest time for a whole message (default: ${DEFAULT-VALUE})")
    private int messageTime;

    @Option(
            names = "--idle",
            paramLabel = "SECONDS",
            defaultValue = "86400",
            description = "longest silence of a peer between two messages (default: ${DEFAULT-VALUE})")
    private int idle;

    @Option(
            names = "--max-objects",
            paramLabel = "N",
            description = "maximum number of objects in a world; of a group, its members")
    private int objects = MessageLimits.MAX_LIST_LENGTH;

    @Option(
            names = "--max-requests",
            paramLabel = "N",
            description = "maximum number of moves or sonar requests in a bundle, or of beams, poses, edges and pixels")
    private int requests = MessageLimits.MAX_LIST_LENGTH;

    @Option(
            names = "--request-time",
            paramLabel = "SECONDS",
            defaultValue = "10",
            description =
                    "longest processor time of a request; one that takes more is answered with an error, and the world"
                            + " is as before (default: ${DEFAULT-VALUE})")
    private double requestTime;

    @Option(
            names = "--request-work",
            paramLabel = "UNITS",
            description = "the same for units of work, which do not depend on the machine: pairs, steps and rays"
                    + " (default: no limit)")
    private long requestWork = Long.MAX_VALUE;

    @ArgGroup(exclusive = false)
    private @Nullable Stores stores;

    @ArgGroup
    private @Nullable SecretSource secret;

    @Option(
            names = "--figures",
            paramLabel = "SECONDS",
            defaultValue = "0",
            description = "how often to print a line of figures; 0 for never. A last line is printed at the end.")
    private int figures;

    @Option(
            names = "--log",
            paramLabel = "FORM",
            defaultValue = "text",
            description = "form of the log's lines: text or json (default: ${DEFAULT-VALUE})")
    private String log = "text";

    /** The options for TLS: all of them or none. */
    private static final class Stores {
        @Option(
                names = "--key-store",
                paramLabel = "FILE",
                required = true,
                description = "TLS: this side's key and certificate")
        private Path key = Path.of("");

        @Option(
                names = "--trust-store",
                paramLabel = "FILE",
                required = true,
                description = "TLS: the certificates that are trusted")
        private Path trust = Path.of("");

        @ArgGroup(multiplicity = "1")
        private PasswordSource password = new PasswordSource();
    }

    private static final class PasswordSource {
        @Option(
                names = "--password-file",
                paramLabel = "FILE",
                description = "a file whose first line is the password of both stores")
        private @Nullable Path file;

        @Option(
                names = "--password-env",
                paramLabel = "NAME",
                description = "an environment variable that holds the password of both stores")
        private @Nullable String variable;
    }

    private static final class SecretSource {
        @Option(
                names = "--secret-file",
                paramLabel = "FILE",
                description =
                        "a file whose first line is the secret that JSON peers must present; all others then need TLS")
        private @Nullable Path file;

        @Option(
                names = "--secret-env",
                paramLabel = "NAME",
                description = "an environment variable that holds this secret")
        private @Nullable String variable;
    }

    /** The options as given, and more of them; a bad value is refused as a usage error. */
    NetOptions options(UnaryOperator<NetOptions> more) {
        useLog();
        char @Nullable [] letters = null;
        try {
            letters = secret();
            return more.apply(NetOptions.defaults()
                    .withTimes(Duration.ofSeconds(stall), Duration.ofSeconds(messageTime))
                    .withIdle(Duration.ofSeconds(idle))
                    .withResume(Duration.ofSeconds(resume))
                    .withSizes(objects, requests)
                    .withRequestLimit(Duration.ofNanos((long) (requestTime * 1e9)), requestWork)
                    .withAccess(tls(), letters));
        } catch (IllegalArgumentException e) {
            throw new UsageException(String.valueOf(e.getMessage()), e);
        } finally {
            blank(letters);
        }
    }

    private void useLog() {
        Arguments.refuse(!log.equals("text") && !log.equals("json"), "--log must be text or json", log);
        LogLines.use(log.equals("json") ? LogLines.Form.JSON : LogLines.Form.TEXT);
    }

    /** Has keys, certificates and secrets that are in files renewed when the files change. */
    void keepFresh(BiConsumer<@Nullable Tls, char @Nullable []> renew) {
        Stores tls = stores;
        Stream<@Nullable Path> files = Stream.concat(
                tls == null ? Stream.of() : Stream.of(tls.key, tls.trust, tls.password.file),
                secret == null ? Stream.of() : Stream.of(secret.file));
        new Renewal(files.filter(Objects::nonNull).toList(), () -> renewBy(renew)).start();
    }

    private void renewBy(BiConsumer<@Nullable Tls, char @Nullable []> renew) {
        char @Nullable [] letters = secret();
        try {
            renew.accept(tls(), letters);
        } finally {
            blank(letters);
        }
    }

    /** The secret, for its reader to blank; null without one. */
    private char @Nullable [] secret() {
        return secret == null ? null : read(secret.file, secret.variable, "--secret");
    }

    private static void blank(char @Nullable [] letters) {
        if (letters != null) {
            Arrays.fill(letters, ' ');
        }
    }

    /** 0 for never. */
    int figuresSeconds() {
        Arguments.refuse(figures < 0, "--figures must be at least 0", figures);
        return figures;
    }

    private @Nullable Tls tls() {
        if (stores == null) {
            return null;
        }
        char[] password = read(stores.password.file, stores.password.variable, "--password");
        try {
            return Tls.load(stores.key, password, stores.trust, password);
        } finally {
            Arrays.fill(password, ' ');
        }
    }

    private static char[] read(@Nullable Path file, @Nullable String variable, String option) {
        if (file != null) {
            try {
                List<String> lines = Files.readAllLines(file);
                return lines.isEmpty() ? new char[0] : lines.get(0).toCharArray();
            } catch (IOException e) {
                throw new IllegalArgumentException(option + "-file must be a text file (got: " + file + ")", e);
            }
        }
        String value = variable == null ? null : System.getenv(variable);
        if (value == null) {
            throw new IllegalArgumentException(
                    option + "-env must name a variable that is set (got: " + variable + ")");
        }
        return value.toCharArray();
    }
}
