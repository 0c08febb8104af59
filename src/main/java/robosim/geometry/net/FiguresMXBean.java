package robosim.geometry.net;

/**
 * What an operator sees of a server or a client, from its beginning on. Where the JDK's module {@code java.management} is
 * present, each end registers itself with the platform's bean server under {@code robosim.geometry}.
 */
public interface FiguresMXBean {
    /** Connections that there are now. */
    int getOpenConnections();

    /** Connections that there were or are. */
    long getConnections();

    /** Connections refused because there were too many. */
    long getRefusedConnections();

    /** Messages carried out, worlds among them. */
    long getBundles();

    /** Moves and sonar requests carried out. */
    long getRequests();

    /** Moves that were not made. */
    long getRefusedMoves();

    /** Connections closed because of what their peer did or did not do, and because of errors of the module itself. */
    long getErrors();

    /** Half of all answers took at most so long, from the request, when it has been read, to the last byte of the answer. */
    double getAnswerMicrosecondsP50();

    /** 99 of 100 answers took at most so long. */
    double getAnswerMicrosecondsP99();

    /** All of it as a line of a log. */
    String line();
}
