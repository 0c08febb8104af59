package robosim.geometry.net;

import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageTranslator;
import robosim.geometry.protocol.json.WorldLoader;

/**
 * Options of servers and clients for their connections: who may connect, how long a peer is waited for, how much it may request, and
 * what becomes of its requests.
 *
 * <pre>{@code
 * NetOptions options = NetOptions.defaults()
 *         .withConnections(16)
 *         .withTimes(Duration.ofSeconds(5), Duration.ofSeconds(30))
 *         .withRequestLimit(Duration.ofSeconds(2), Long.MAX_VALUE);
 * }</pre>
 *
 * <p>Immutable. Each method that begins with {@code with} returns changed options, and refuses null and values out of range.
 */
public final class NetOptions {
    private SessionOptions session;
    private Function<String, SessionListener> listeners;
    private MessageTranslator translator;
    private Timeouts timeouts;
    private Quotas quotas;
    private Access access;
    private @Nullable Redial redial;
    private List<Bundle> opening;
    private WorldLoader worlds;

    private NetOptions() {
        session = SessionOptions.ROBOSIM;
        listeners = connection -> SessionListener.NONE;
        translator = MessageTranslator.installed();
        timeouts = Timeouts.DEFAULT;
        quotas = Quotas.DEFAULT;
        access = Access.ANYBODY;
        opening = List.of();
        worlds = WorldLoader.NONE;
    }

    private NetOptions(NetOptions other) {
        session = other.session;
        listeners = other.listeners;
        translator = other.translator;
        timeouts = other.timeouts;
        quotas = other.quotas;
        access = other.access;
        redial = other.redial;
        opening = other.opening;
        worlds = other.worlds;
    }

    /** A copy, changed before anybody else sees it. */
    private NetOptions with(Consumer<NetOptions> change) {
        NetOptions copy = new NetOptions(this);
        change.accept(copy);
        return copy;
    }

    /**
     * RoboSim's session options, no listener, the {@linkplain MessageTranslator#installed() installed} translator,
     * default times and quotas, no authentication, and a client that dials once.
     */
    public static NetOptions defaults() {
        return new NetOptions();
    }

    /** These options with another session: defaults for what requests leave out. */
    public NetOptions withSession(SessionOptions other) {
        Checks.present("other", other);
        return with(copy -> copy.session = other);
    }

    /** These options with listeners, each created for a connection, given the connection's name. */
    public NetOptions withListeners(Function<String, SessionListener> others) {
        Checks.present("others", others);
        return with(copy -> copy.listeners = others);
    }

    /** These options with another translator between bundles and the peer's own classes. */
    public NetOptions withTranslator(MessageTranslator other) {
        Checks.present("other", other);
        return with(copy -> copy.translator = other);
    }

    /**
     * These options with other times within a message, each from a millisecond to a day: at first 10 and 60 seconds.
     *
     * @param stall   how long a message that has begun may pause, in or out, and how long dialling may take
     * @param message how long a message may take from its first byte to its last, either way
     */
    public NetOptions withTimes(Duration stall, Duration message) {
        return withTimeouts(new Timeouts(stall, message, timeouts.idle(), timeouts.admission(), timeouts.resume()));
    }

    /**
     * These options with another time for which a peer may be silent between two messages, a millisecond to a day; at first a day,
     * since a simulation may be halted overnight.
     */
    public NetOptions withIdle(Duration time) {
        return withTimeouts(
                new Timeouts(timeouts.stall(), timeouts.message(), time, timeouts.admission(), timeouts.resume()));
    }

    /**
     * These options with another time that a server waits for a new peer in all, a millisecond to a day, at first 10 seconds: for
     * TLS, its secret and its first message, or the first 256 kB of it.
     */
    public NetOptions withAdmission(Duration time) {
        return withTimeouts(
                new Timeouts(timeouts.stall(), timeouts.message(), timeouts.idle(), time, timeouts.resume()));
    }

    /** These options with sessions of dropped connections kept for JSON peers that want that; zero, as at first, for not at all. */
    public NetOptions withResume(Duration time) {
        return withTimeouts(timeouts.withResume(time));
    }

    NetOptions withTimeouts(Timeouts other) {
        Checks.present("other", other);
        return with(copy -> copy.timeouts = other);
    }

    /**
     * These options with another maximum number of admitted connections of a server at a time, at first 256; each has a thread.
     * Those that have not sent a first message yet have a limit of their own.
     */
    public NetOptions withConnections(int most) {
        return withQuotas(new Quotas(most, quotas.objects(), quotas.requests(), quotas.time(), quotas.work()));
    }

    /**
     * These options with other maximum sizes of what a peer sends, each at least 1; at first {@link
     * robosim.geometry.protocol.MessageLimits#MAX_LIST_LENGTH}.
     *
     * @param objects  of a world; a group counts as its members
     * @param requests of moves or sonar requests in a bundle, or of beams, poses, edges and pixels of a batch
     */
    public NetOptions withSizes(int objects, int requests) {
        return withQuotas(new Quotas(quotas.connections(), objects, requests, quotas.time(), quotas.work()));
    }

    /**
     * These options with another limit of one request. One that takes more is ended, and the world is as before.
     *
     * @param time processor time, a millisecond to a day; at first 10 seconds
     * @param work in units of {@link robosim.geometry.WorkLimit}, of an init for each object; {@link Long#MAX_VALUE}, as at first, for
     *             no limit
     */
    public NetOptions withRequestLimit(Duration time, long work) {
        return withQuotas(quotas.withRequestLimit(time, work));
    }

    NetOptions withQuotas(Quotas other) {
        Checks.present("other", other);
        return with(copy -> copy.quotas = other);
    }

    /**
     * These options with TLS, a secret, or both; at first there is neither, which is for the loopback address.
     *
     * @param tls    if not null, every connection uses TLS, and each end presents a certificate that the other trusts
     * @param secret if not null, at least 16 letters that a peer that speaks JSON must present in its hello; a peer that speaks Java
     *               serialization, which has no place for it, is then served over TLS only. Only its digest is kept, so the caller
     *               may overwrite it afterwards
     */
    public NetOptions withAccess(@Nullable Tls tls, char @Nullable [] secret) {
        return withAccess(Access.of(tls, secret));
    }

    NetOptions withAccess(Access other) {
        Checks.present("other", other);
        return with(copy -> copy.access = other);
    }

    /** These options for a client that dials again after half a second to half a minute: see {@link #withRedial(Duration, Duration)}. */
    public NetOptions withRedial() {
        return withRedial(Redial.DEFAULT);
    }

    /**
     * These options for a client that dials again after it has lost its environment or could not reach it. The pause doubles with
     * every attempt in which no request was answered. Each pause is shortened by a random part of up to a half, so that many
     * clients of one environment do not return all at once.
     *
     * @param first   the pause before the second attempt, at least a millisecond
     * @param longest the largest pause before it is shortened, from {@code first} to a day
     */
    public NetOptions withRedial(Duration first, Duration longest) {
        return withRedial(new Redial(first, longest));
    }

    NetOptions withRedial(Redial other) {
        return with(copy -> copy.redial = other);
    }

    /**
     * These options for connections that begin with a world.
     *
     * @param requests carried out by each connection's session before the peer's first one, of which the first is an InitBundle;
     *                 none of them if the peer's first request is an InitBundle itself. Nobody but the listener gets their answers
     */
    public NetOptions withOpening(List<Bundle> requests) {
        List<Bundle> all = Checks.copy("opening", requests, Bundle.class);
        boolean isWorldFirst = all.isEmpty() || all.get(0) instanceof InitBundle;
        Checks.refuse(
                !isWorldFirst || all.stream().anyMatch(Bundle::isAnswer),
                "opening must be requests, the first of them an InitBundle",
                all.stream().map(each -> each.getClass().getSimpleName()).toList());
        return with(copy -> copy.opening = all);
    }

    /** These options for a module that reads world files that JSON peers send or name; none by default. */
    public NetOptions withWorlds(WorldLoader loader) {
        Checks.present("loader", loader);
        return with(copy -> copy.worlds = loader);
    }

    /** Defaults for what requests leave out. */
    public SessionOptions session() {
        return session;
    }

    /** Creates the listener of a connection, given the connection's name. */
    public Function<String, SessionListener> listeners() {
        return listeners;
    }

    MessageTranslator translator() {
        return translator;
    }

    Timeouts timeouts() {
        return timeouts;
    }

    Quotas quotas() {
        return quotas;
    }

    Access access() {
        return access;
    }

    /** Null for a client that dials once. */
    @Nullable
    Redial redial() {
        return redial;
    }

    List<Bundle> opening() {
        return opening;
    }

    WorldLoader worlds() {
        return worlds;
    }
}
