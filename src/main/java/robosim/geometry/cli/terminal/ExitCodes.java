package robosim.geometry.cli.terminal;

/** The exit codes of all commands, and their descriptions in each command's help. */
public final class ExitCodes {
    /** Done, and nothing is wrong. */
    public static final int FINE = 0;

    /** Done, with findings: answers that differ, an audit that fails, a world with findings. */
    public static final int FINDINGS = 1;

    /** Not done: bad usage, input that cannot be read, a connection that failed. */
    public static final int UNUSABLE = 2;

    /** Done, but not with all of the input: parts of it were left out, and each was named. */
    public static final int PARTIAL = 3;

    public static final String DONE = FINE + ":done, and nothing is wrong";

    public static final String REFUSED = UNUSABLE + ":not done: bad usage, or something that cannot be read or written";

    /** What a Java process ends with that a signal ends, after its last steps. */
    public static final String ENDED = "128+N:ended by signal N, after it was closed: 143 by SIGTERM, 130 by Ctrl-C";

    private ExitCodes() {}
}
