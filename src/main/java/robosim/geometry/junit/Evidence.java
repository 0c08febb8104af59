package robosim.geometry.junit;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.viewer.Pictures;

/** What a failed test leaves in its folder. */
final class Evidence {
    private static final String REPLAY = "replay" + ScenarioReader.ENDING;
    private static final String PICTURE = "last-moments.svg";
    private static final String WORDS = "failure.txt";

    private final Path folder;

    Evidence(Path folder) {
        this.folder = folder;
    }

    /** Takes away what an earlier run left. */
    void clear() throws IOException {
        Files.deleteIfExists(folder.resolve(REPLAY));
        Files.deleteIfExists(folder.resolve(PICTURE));
        Files.deleteIfExists(folder.resolve(WORDS));
        int connection = 1;
        while (Files.deleteIfExists(talk(connection))) {
            Files.deleteIfExists(picture(connection));
            connection++;
        }
    }

    private Path talk(int connection) {
        return folder.resolve("connection-" + connection + ScenarioReader.ENDING);
    }

    private Path picture(int connection) {
        return folder.resolve("connection-" + connection + ".svg");
    }

    /** Leaves all there is and answers the lines of the message that name it. Nothing is thrown: the failure goes first. */
    String leave(String failure, long seed, @Nullable RobotWorld world, Talks talks, String title) {
        String lines = "\n  seed:   " + seed + " (as @Seed(" + seed + "L) or -Drobosim.seed=" + seed + ")";
        if (world != null) {
            lines += "\n  replay: " + replay(world, title);
            lines += "\n  image:  " + picture(world.scenario(title), folder.resolve(PICTURE));
        }
        int connection = 0;
        for (byte[] recording : talks.recorded()) {
            lines += "\n  talk:   " + talk(++connection, recording);
        }
        try {
            Files.createDirectories(folder);
            Files.writeString(folder.resolve(WORDS), title + "\n" + failure + lines + "\n", StandardCharsets.UTF_8);
        } catch (IOException | RuntimeException e) {
            lines += "\n  and " + folder.resolve(WORDS) + " could not be written: " + e;
        }
        return lines;
    }

    private String talk(int connection, byte[] recording) {
        Path file = talk(connection);
        if (recording.length == 0) {
            return "none of connection " + connection + ", which said nothing or could not be recorded";
        }
        try {
            Files.createDirectories(folder);
            Files.write(file, recording);
            return file + "\n  image:  " + picture(Scenario.read(file), picture(connection));
        } catch (IOException | RuntimeException e) {
            return "none, for it could not be written: " + e;
        }
    }

    private String replay(RobotWorld world, String title) {
        Path file = folder.resolve(REPLAY);
        try {
            Files.createDirectories(folder);
            Scenario scenario = world.scenario(title);
            try (OutputStream out = Files.newOutputStream(file)) {
                scenario.write(out);
            }
            return file.toString();
        } catch (NoClassDefFoundError e) {
            return "none, for jackson-core is not on the class path, nor added to the modules (" + e.getMessage() + ")";
        } catch (IOException | RuntimeException e) {
            return "none, for it could not be written: " + e;
        }
    }

    /** The robots at the end, with their last ways, what they sensed and what refused them. */
    private String picture(Scenario scenario, Path file) {
        try {
            Files.createDirectories(folder);
            Pictures.lastMoments(scenario, file);
            return file.toString();
        } catch (IOException | RuntimeException e) {
            return "none, for it could not be drawn: " + e;
        }
    }
}
