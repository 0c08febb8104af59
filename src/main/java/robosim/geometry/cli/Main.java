package robosim.geometry.cli;

/** The command line: {@code demo}, {@code serve}, {@code connect}, {@code render} and {@code replay}; {@code --help} tells more. */
public final class Main {
    private Main() {}

    /**
     * Runs a command and exits with its code where that is not 0: 1 where the module was found wrong, 2 where it could not
     * be asked.
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
            code = Commands.UNUSABLE;
        }
        if (code != 0) {
            System.exit(code);
        }
    }
}
