package robosim.geometry.net;

import robosim.geometry.exact.Checks;
import robosim.geometry.protocol.MessageLimits;

/**
 * How much peers may request; each limit is at least 1.
 *
 * @param connections maximum number of admitted connections of a server at a time; each has a thread. Those that have
 *     not sent a first message yet have a limit of their own
 * @param objects     maximum number of objects in a world; a group counts as its members
 * @param requests    maximum number of moves or sonar requests in a bundle, or of beams, poses, edges and pixels of a batch
 */
public record Quotas(int connections, int objects, int requests) {
    /** 256 connections; otherwise the limit of any list in a message, {@link MessageLimits#MAX_LIST_LENGTH}. */
    public static final Quotas DEFAULT = new Quotas(256, MessageLimits.MAX_LIST_LENGTH, MessageLimits.MAX_LIST_LENGTH);

    /** Refuses values below 1. */
    public Quotas {
        Checks.atLeastOne("connections", connections);
        Checks.atLeastOne("objects", objects);
        Checks.atLeastOne("requests", requests);
    }
}
