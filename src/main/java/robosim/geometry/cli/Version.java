package robosim.geometry.cli;

import picocli.CommandLine.IVersionProvider;

/** What {@code --version} prints. */
final class Version implements IVersionProvider {
    /** That of the pom; a test compares them. */
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
