package robosim.geometry.cli;

import picocli.CommandLine.IVersionProvider;

/** The text that {@code --version} prints. */
final class Version implements IVersionProvider {
    /** The version in the pom; a test compares the two. */
    static final String NUMBER = "1.0.0-SNAPSHOT";

    private Version() {}

    @Override
    public String[] getVersion() {
        return new String[] {
            Commands.NAME + " " + NUMBER,
            "Java " + Runtime.version() + ", " + System.getProperty("os.name") + " " + System.getProperty("os.arch")
        };
    }
}
