package robosim.geometry.net;

import java.time.Duration;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.protocol.MessageTranslator;

/**
 * Options of servers and clients for their connections.
 *
 * @param session    defaults for what requests leave out
 * @param listeners  creates the listener of a connection, given the connection's name
 * @param translator translates between bundles and the peer's own classes
 * @param timeouts   how long to wait for a peer
 * @param quotas  how much peers may request
 * @param access     who may connect
 * @param redial     how a client dials again; null for a client that dials once
 */
public record NetOptions(
        SessionOptions session,
        Function<String, SessionListener> listeners,
        MessageTranslator translator,
        Timeouts timeouts,
        Quotas quotas,
        Access access,
        @Nullable Redial redial) {
    /** Refuses null, except for {@code redial}. */
    public NetOptions {
        Checks.present("session", session);
        Checks.present("listeners", listeners);
        Checks.present("translator", translator);
        Checks.present("timeouts", timeouts);
        Checks.present("quotas", quotas);
        Checks.present("access", access);
    }

    /**
     * RoboSim's session options, no listener, the {@linkplain MessageTranslator#installed() installed} translator,
     * default timeouts and quotas, no authentication, and a client that dials once.
     */
    public static NetOptions defaults() {
        return new NetOptions(
                SessionOptions.ROBOSIM,
                connection -> SessionListener.NONE,
                MessageTranslator.installed(),
                Timeouts.DEFAULT,
                Quotas.DEFAULT,
                Access.ANYBODY,
                null);
    }

    /** These options with another session. */
    public NetOptions withSession(SessionOptions other) {
        return new NetOptions(other, listeners, translator, timeouts, quotas, access, redial);
    }

    /** These options with listeners. */
    public NetOptions withListeners(Function<String, SessionListener> others) {
        return new NetOptions(session, others, translator, timeouts, quotas, access, redial);
    }

    /** These options with another translator. */
    public NetOptions withTranslator(MessageTranslator other) {
        return new NetOptions(session, listeners, other, timeouts, quotas, access, redial);
    }

    /** These options with other timeouts. */
    public NetOptions withTimeouts(Timeouts other) {
        return new NetOptions(session, listeners, translator, other, quotas, access, redial);
    }

    /** These options with other timeouts within a message. */
    public NetOptions withTimes(Duration stall, Duration message) {
        return withTimeouts(new Timeouts(stall, message, timeouts.idle()));
    }

    /** These options with other quotas. */
    public NetOptions withQuotas(Quotas other) {
        return new NetOptions(session, listeners, translator, timeouts, other, access, redial);
    }

    /** These options with another maximum number of connections. */
    public NetOptions withConnections(int most) {
        return withQuotas(new Quotas(most, quotas.objects(), quotas.requests()));
    }

    /** These options with TLS, a secret or both. */
    public NetOptions withAccess(@Nullable Tls tls, @Nullable Secret secret) {
        return new NetOptions(session, listeners, translator, timeouts, quotas, new Access(tls, secret), redial);
    }

    /** These options for a client that dials again; null for one that dials once. */
    public NetOptions withRedial(@Nullable Redial other) {
        return new NetOptions(session, listeners, translator, timeouts, quotas, access, other);
    }
}
