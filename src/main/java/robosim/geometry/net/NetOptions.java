package robosim.geometry.net;

import java.time.Duration;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageTranslator;
import robosim.geometry.protocol.json.WorldLoader;

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
 * @param opening    requests that each connection's session carries out before the peer's first one, of which the first is
 *                   an InitBundle; none of them if the peer's first request is an InitBundle itself. Nobody but the
 *                   listener gets their answers
 * @param worlds     reads world files that JSON peers send or name; none by default
 */
public record NetOptions(
        SessionOptions session,
        Function<String, SessionListener> listeners,
        MessageTranslator translator,
        Timeouts timeouts,
        Quotas quotas,
        Access access,
        @Nullable Redial redial,
        List<Bundle> opening,
        WorldLoader worlds) {
    /** Refuses null, except for {@code redial}, and an opening that begins without a world or has an answer. */
    public NetOptions {
        Checks.present("session", session);
        Checks.present("listeners", listeners);
        Checks.present("translator", translator);
        Checks.present("timeouts", timeouts);
        Checks.present("quotas", quotas);
        Checks.present("access", access);
        Checks.present("worlds", worlds);
        opening = Checks.copy("opening", opening, Bundle.class);
        boolean isWorldFirst = opening.isEmpty() || opening.get(0) instanceof InitBundle;
        Checks.refuse(
                !isWorldFirst || opening.stream().anyMatch(Bundle::isAnswer),
                "opening must be requests, the first of them an InitBundle",
                opening.stream().map(each -> each.getClass().getSimpleName()).toList());
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
                null,
                List.of(),
                WorldLoader.NONE);
    }

    /** These options with another session. */
    public NetOptions withSession(SessionOptions other) {
        return new NetOptions(other, listeners, translator, timeouts, quotas, access, redial, opening, worlds);
    }

    /** These options with listeners. */
    public NetOptions withListeners(Function<String, SessionListener> others) {
        return new NetOptions(session, others, translator, timeouts, quotas, access, redial, opening, worlds);
    }

    /** These options with another translator. */
    public NetOptions withTranslator(MessageTranslator other) {
        return new NetOptions(session, listeners, other, timeouts, quotas, access, redial, opening, worlds);
    }

    /** These options with other timeouts. */
    public NetOptions withTimeouts(Timeouts other) {
        return new NetOptions(session, listeners, translator, other, quotas, access, redial, opening, worlds);
    }

    /** These options with other timeouts within a message. */
    public NetOptions withTimes(Duration stall, Duration message) {
        return withTimeouts(new Timeouts(stall, message, timeouts.idle(), timeouts.admission(), timeouts.resume()));
    }

    /** These options with other quotas. */
    public NetOptions withQuotas(Quotas other) {
        return new NetOptions(session, listeners, translator, timeouts, other, access, redial, opening, worlds);
    }

    /** These options with another maximum number of connections. */
    public NetOptions withConnections(int most) {
        return withQuotas(new Quotas(most, quotas.objects(), quotas.requests(), quotas.time(), quotas.work()));
    }

    /** These options with TLS, a secret or both. */
    public NetOptions withAccess(@Nullable Tls tls, @Nullable Secret secret) {
        return withAccess(new Access(tls, secret));
    }

    /** These options with another way to tell who may connect. */
    public NetOptions withAccess(Access other) {
        return new NetOptions(session, listeners, translator, timeouts, quotas, other, redial, opening, worlds);
    }

    /** These options for a client that dials again; null for one that dials once. */
    public NetOptions withRedial(@Nullable Redial other) {
        return new NetOptions(session, listeners, translator, timeouts, quotas, access, other, opening, worlds);
    }

    /** These options for connections that begin with a world: see {@link #opening}. */
    public NetOptions withOpening(List<Bundle> requests) {
        return new NetOptions(session, listeners, translator, timeouts, quotas, access, redial, requests, worlds);
    }

    /** These options for a module that reads world files for its JSON peers. */
    public NetOptions withWorlds(WorldLoader loader) {
        return new NetOptions(session, listeners, translator, timeouts, quotas, access, redial, opening, loader);
    }
}
