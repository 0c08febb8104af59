package robosim.geometry.net;

import java.time.Duration;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.MessageLimits;

/**
 * How much peers may request; each limit is at least 1.
 *
 * @param connections maximum number of admitted connections of a server at a time; each has a thread. Those that have
 *     not sent a first message yet have a limit of their own
 * @param objects     maximum number of objects in a world; a group counts as its members
 * @param requests    maximum number of moves or sonar requests in a bundle, or of beams, poses, edges and pixels of a batch
 * @param time        maximum processor time of one request, a millisecond to a day. One that takes more is ended, and the world
 *     is as before
 * @param work        maximum work of one request, in units of {@link robosim.geometry.WorkLimit}; of an init, of each object; of a load, of its file and
 *     of each object.
 *     {@link Long#MAX_VALUE} for no limit
 */
record Quotas(int connections, int objects, int requests, Duration time, long work) {
    private static final Duration LONGEST = Duration.ofDays(1);

    /** A hundred times what the largest frames, pictures and steps of real robots take. */
    private static final Duration TIME = Duration.ofSeconds(10);

    /** 256 connections and 10 seconds for a request, however much work that is; otherwise the limit of any list in a message, {@link MessageLimits#MAX_LIST_LENGTH}. */
    public static final Quotas DEFAULT = new Quotas(256, MessageLimits.MAX_LIST_LENGTH, MessageLimits.MAX_LIST_LENGTH);

    /** Quotas with 10 seconds for a request, however much work that is. */
    public Quotas(int connections, int objects, int requests) {
        this(connections, objects, requests, TIME, Long.MAX_VALUE);
    }

    /** Refuses values below 1, and times out of range. */
    public Quotas {
        Checks.atLeastOne("connections", connections);
        Checks.atLeastOne("objects", objects);
        Checks.atLeastOne("requests", requests);
        Checks.time("time", time, LONGEST);
        Checks.refuse(work < 1, "work must be at least 1", work);
    }

    /** These quotas with another limit of each request. */
    public Quotas withRequestLimit(Duration time, long work) {
        return new Quotas(connections, objects, requests, time, work);
    }
}
