package robosim.geometry.cli;

/** The command line: {@code --help} tells its commands. */
public final class Main {
    private Main() {}

    /**
     * Runs a command and exits with its code where that is not 0: 1 where something was found, 2 where it could not be
     * done.
     *
     * @param arguments the command and what it takes
     */
    public static void main(String[] arguments) {
        // No command needs a screen.
        System.setProperty("java.awt.headless", "true");
        int code;
        try {
            code = Commands.run(arguments);
        } catch (NoClassDefFoundError missing) {
            System.err.println("The command line needs picocli on the class path, which this one has not: "
                    + "start it as `mvn -q compile exec:java`, or add picocli's jar; on a module path also"
                    + " --add-modules info.picocli,java.desktop (missing: " + missing.getMessage() + ")");
            code = ExitCodes.UNUSABLE;
        }
        if (code != 0) {
            System.exit(code);
        }
    }
}
