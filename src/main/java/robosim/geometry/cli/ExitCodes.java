package robosim.geometry.cli;

/** The exit codes of all commands, and their descriptions in each command's help. */
final class ExitCodes {
    /** Done, and nothing is wrong. */
    static final int FINE = 0;

    /** Done, with findings: answers that differ, an audit that fails, a world with findings. */
    static final int FINDINGS = 1;

    /** Not done: bad usage, input that cannot be read, a connection that failed. */
    static final int UNUSABLE = 2;

    static final String HEADING = "%nExit codes:%n";

    static final String DONE = FINE + ":done, and nothing is wrong";

    static final String REFUSED = UNUSABLE + ":not done: bad usage, or something that cannot be read or written";

    /** The exit code of a Java process that a signal ends, after its shutdown hooks. */
    static final String ENDED = "128+N:ended by signal N, after an orderly shutdown: 143 for SIGTERM, 130 for Ctrl-C";

    private ExitCodes() {}
}
