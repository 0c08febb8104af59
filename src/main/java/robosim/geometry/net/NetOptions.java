package robosim.geometry.net;

import java.time.Duration;
import java.util.function.Function;
import robosim.geometry.protocol.MessageTranslator;

/**
 * How the two ends treat their connections.
 *
 * @param session     what requests leave open
 * @param listeners   makes the listener of a connection, whose name it is given
 * @param translator  between bundles and what the peer speaks
 * @param stallTime   how long a message that has begun may pause, and how long dialling may take. Between messages a
 *                    connection may be idle for ever
 * @param messageTime how long a message may take from its first byte to its last
 * @param connections most connections at a time of a server; each has a thread
 */
public record NetOptions(
        SessionOptions session,
        Function<String, SessionListener> listeners,
        MessageTranslator translator,
        Duration stallTime,
        Duration messageTime,
        int connections) {
    private static final Duration LONGEST = Duration.ofDays(1);

    /** Refuses null, a time that is not above zero and at most a day, and a number of connections below 1. */
    public NetOptions {
        Arguments.present("session", session);
        Arguments.present("listeners", listeners);
        Arguments.present("translator", translator);
        checkTime("stallTime", stallTime);
        checkTime("messageTime", messageTime);
        if (connections < 1) {
            throw new IllegalArgumentException("connections must be at least 1 (got: " + connections + ")");
        }
    }

    /**
     * RoboSim's session without a listener, the {@linkplain MessageTranslator#installed() installed} translator, 10 seconds
     * of pause and 60 for a message, 256 connections.
     */
    public static NetOptions defaults() {
        return new NetOptions(
                SessionOptions.ROBOSIM,
                connection -> SessionListener.NONE,
                MessageTranslator.installed(),
                Duration.ofSeconds(10),
                Duration.ofSeconds(60),
                256);
    }

    /** These options with another session. */
    public NetOptions withSession(SessionOptions other) {
        return new NetOptions(other, listeners, translator, stallTime, messageTime, connections);
    }

    /** These options with listeners. */
    public NetOptions withListeners(Function<String, SessionListener> others) {
        return new NetOptions(session, others, translator, stallTime, messageTime, connections);
    }

    /** These options with another translator. */
    public NetOptions withTranslator(MessageTranslator other) {
        return new NetOptions(session, listeners, other, stallTime, messageTime, connections);
    }

    /** These options with other times for a message that has begun. */
    public NetOptions withTimes(Duration stall, Duration message) {
        return new NetOptions(session, listeners, translator, stall, message, connections);
    }

    /** These options with another limit of connections. */
    public NetOptions withConnections(int most) {
        return new NetOptions(session, listeners, translator, stallTime, messageTime, most);
    }

    private static void checkTime(String argument, Duration time) {
        Arguments.present(argument, time);
        if (time.compareTo(Duration.ofMillis(1)) < 0 || time.compareTo(LONGEST) > 0) {
            throw new IllegalArgumentException(argument + " must be from a millisecond to a day (got: " + time + ")");
        }
    }
}
