package robosim.geometry.net;

import robosim.geometry.exact.Checks;
import robosim.geometry.protocol.Limits;

/**
 * How much peers may ask for; each at least 1.
 *
 * @param connections most connections of a server at a time; each has a thread
 * @param objects     most objects of a world; a group is one
 * @param requests    most moves or sonar requests of a bundle
 */
public record Quotas(int connections, int objects, int requests) {
    /** 256 connections; otherwise what a message may hold at all, {@link Limits#MAX_LIST_LENGTH}. */
    public static final Quotas DEFAULT = new Quotas(256, Limits.MAX_LIST_LENGTH, Limits.MAX_LIST_LENGTH);

    /** Refuses what is below 1. */
    public Quotas {
        Checks.atLeastOne("connections", connections);
        Checks.atLeastOne("objects", objects);
        Checks.atLeastOne("requests", requests);
    }
}
