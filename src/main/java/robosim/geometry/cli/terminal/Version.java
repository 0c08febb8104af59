package robosim.geometry.cli.terminal;

import picocli.CommandLine.IVersionProvider;

/** The text that {@code --version} prints. */
public final class Version implements IVersionProvider {
    public static final String PROGRAM = "robosim-geometry";

    /** The version in the pom; a test compares the two. */
    public static final String NUMBER = "1.0.0-rc.1";

    @Override
    public String[] getVersion() {
        return new String[] {
            PROGRAM + " " + NUMBER,
            "Java " + Runtime.version() + ", " + System.getProperty("os.name") + " " + System.getProperty("os.arch")
        };
    }
}
