package robosim.geometry.net;

import java.time.Duration;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;
import robosim.geometry.protocol.MessageTranslator;

/**
 * How the two ends treat their connections.
 *
 * @param session    what requests leave open
 * @param listeners  makes the listener of a connection, whose name it is given
 * @param translator between bundles and what the peer speaks
 * @param timeouts   how long a peer is waited for
 * @param quotas  how much peers may ask for
 * @param access     who gets in
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
    /** Refuses null, but for {@code redial}. */
    public NetOptions {
        Checks.present("session", session);
        Checks.present("listeners", listeners);
        Checks.present("translator", translator);
        Checks.present("timeouts", timeouts);
        Checks.present("quotas", quotas);
        Checks.present("access", access);
    }

    /**
     * RoboSim's session without a listener, the {@linkplain MessageTranslator#installed() installed} translator, the
     * defaults of timeouts and quotas, anybody on the loopback address, and a client that dials once.
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

    /** These options with another timeouts. */
    public NetOptions withTimeouts(Timeouts other) {
        return new NetOptions(session, listeners, translator, other, quotas, access, redial);
    }

    /** These options with other times for a message that has begun. */
    public NetOptions withTimes(Duration stall, Duration message) {
        return withTimeouts(new Timeouts(stall, message, timeouts.idle()));
    }

    /** These options with another quotas. */
    public NetOptions withQuotas(Quotas other) {
        return new NetOptions(session, listeners, translator, timeouts, other, access, redial);
    }

    /** These options with another limit of connections. */
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
