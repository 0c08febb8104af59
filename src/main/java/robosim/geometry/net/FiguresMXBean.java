package robosim.geometry.net;

/**
 * Figures about a server or a client since it started, for operators. If the JDK's module {@code java.management} is
 * present, each server and client registers itself with the platform's MBean server under {@code robosim.geometry}.
 */
public interface FiguresMXBean {
    /** Connections that are open now. */
    int getOpenConnections();

    /** Connections so far, open ones included. */
    long getConnections();

    /** Connections refused because there were too many, or closed before their first message for the same reason. */
    long getRefusedConnections();

    /** Messages processed, including those that make a world. */
    long getBundles();

    /** Moves and sonar requests carried out, and beams, poses, edges and pixels of batches. */
    long getRequests();

    /** Moves that were not made. */
    long getRefusedMoves();

    /** Connections closed because of an error or a timeout of the peer, or an internal error of the module. */
    long getErrors();

    /** Answers sent. */
    long getAnswers();

    /** The sum of the times of all answers, from when each request has been read to the last byte sent, microseconds. */
    double getAnswerMicrosecondsInAll();

    /** The median time of an answer, from when its request has been read to the last byte sent, microseconds. */
    double getAnswerMicrosecondsP50();

    /** The time within which 99 of 100 answers were sent, microseconds. */
    double getAnswerMicrosecondsP99();

    /** All figures as one log line. */
    String line();
}
