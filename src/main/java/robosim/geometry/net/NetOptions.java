package robosim.geometry.net;

import robosim.geometry.exact.Checks;
import java.time.Duration;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.MessageTranslator;

/**
 * How the two ends treat their connections.
 *
 * @param session    what requests leave open
 * @param listeners  makes the listener of a connection, whose name it is given
 * @param translator between bundles and what the peer speaks
 * @param patience   how long a peer is waited for
 * @param allowance  how much peers may ask for
 * @param access     who gets in
 * @param redial     how a client dials again; null for a client that dials once
 */
public record NetOptions(
        SessionOptions session,
        Function<String, SessionListener> listeners,
        MessageTranslator translator,
        Patience patience,
        Allowance allowance,
        Access access,
        @Nullable Redial redial) {
    /** Refuses null, but for {@code redial}. */
    public NetOptions {
        Checks.present("session", session);
        Checks.present("listeners", listeners);
        Checks.present("translator", translator);
        Checks.present("patience", patience);
        Checks.present("allowance", allowance);
        Checks.present("access", access);
    }

    /**
     * RoboSim's session without a listener, the {@linkplain MessageTranslator#installed() installed} translator, the
     * defaults of patience and allowance, anybody on the loopback address, and a client that dials once.
     */
    public static NetOptions defaults() {
        return new NetOptions(
                SessionOptions.ROBOSIM,
                connection -> SessionListener.NONE,
                MessageTranslator.installed(),
                Patience.DEFAULT,
                Allowance.DEFAULT,
                Access.ANYBODY,
                null);
    }

    /** These options with another session. */
    public NetOptions withSession(SessionOptions other) {
        return new NetOptions(other, listeners, translator, patience, allowance, access, redial);
    }

    /** These options with listeners. */
    public NetOptions withListeners(Function<String, SessionListener> others) {
        return new NetOptions(session, others, translator, patience, allowance, access, redial);
    }

    /** These options with another translator. */
    public NetOptions withTranslator(MessageTranslator other) {
        return new NetOptions(session, listeners, other, patience, allowance, access, redial);
    }

    /** These options with another patience. */
    public NetOptions withPatience(Patience other) {
        return new NetOptions(session, listeners, translator, other, allowance, access, redial);
    }

    /** These options with other times for a message that has begun. */
    public NetOptions withTimes(Duration stall, Duration message) {
        return withPatience(new Patience(stall, message, patience.idle()));
    }

    /** These options with another allowance. */
    public NetOptions withAllowance(Allowance other) {
        return new NetOptions(session, listeners, translator, patience, other, access, redial);
    }

    /** These options with another limit of connections. */
    public NetOptions withConnections(int most) {
        return withAllowance(new Allowance(most, allowance.objects(), allowance.requests()));
    }

    /** These options with TLS, a secret or both. */
    public NetOptions withAccess(@Nullable Tls tls, @Nullable Secret secret) {
        return new NetOptions(session, listeners, translator, patience, allowance, new Access(tls, secret), redial);
    }

    /** These options for a client that dials again; null for one that dials once. */
    public NetOptions withRedial(@Nullable Redial other) {
        return new NetOptions(session, listeners, translator, patience, allowance, access, other);
    }
}
