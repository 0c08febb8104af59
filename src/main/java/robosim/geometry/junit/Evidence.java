package robosim.geometry.junit;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.viewer.playback.Pictures;
import robosim.geometry.world.AtomicFileWriter;

/** What a failed test leaves in its folder. */
final class Evidence {
    private static final String REPLAY = "replay" + ScenarioReader.ENDING;
    private static final String PICTURE = "last-moments.svg";
    private static final String WORDS = "failure.txt";

    private final Path folder;

    Evidence(Path folder) {
        this.folder = folder;
    }

    /** Takes away what an earlier run left, and its folder unless somebody else has put something into it. */
    void clear() throws IOException {
        Files.deleteIfExists(folder.resolve(REPLAY));
        Files.deleteIfExists(folder.resolve(PICTURE));
        Files.deleteIfExists(folder.resolve(WORDS));
        int connection = 1;
        while (Files.deleteIfExists(talk(connection))) {
            Files.deleteIfExists(picture(connection));
            connection++;
        }
        if (Files.isDirectory(folder)) {
            try {
                Files.deleteIfExists(folder);
            } catch (DirectoryNotEmptyException e) {
                // It is not ours alone.
            }
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
            lines += "\n  replay: " + unlessItFails("written", () -> replay(world.scenario(title)));
            lines += "\n  image:  "
                    + unlessItFails(
                            "drawn", () -> picture(world.scenario(title), world.goals(), folder.resolve(PICTURE)));
        }
        int connection = 0;
        for (byte[] recording : talks.recorded()) {
            lines += "\n  talk:   " + talk(++connection, recording);
        }
        try {
            Files.createDirectories(folder);
            String all = title + "\n" + failure + lines + "\n";
            Files.writeString(folder.resolve(WORDS), all, StandardCharsets.UTF_8);
        } catch (IOException | RuntimeException e) {
            lines += "\n  and " + folder.resolve(WORDS) + " could not be written: " + e;
        }
        return lines;
    }

    private String talk(int connection, byte[] recording) {
        if (recording.length == 0) {
            return "none of connection " + connection + ", which said nothing or could not be recorded";
        }
        Path file = talk(connection);
        String written = unlessItFails("written", () -> {
            Files.createDirectories(folder);
            Files.write(file, recording);
            return file.toString();
        });
        String image = unlessItFails("drawn", () -> picture(Scenario.read(file), List.of(), picture(connection)));
        return written + "\n  image:  " + image;
    }

    private String replay(Scenario scenario) throws IOException {
        Path file = folder.resolve(REPLAY);
        Files.createDirectories(folder);
        AtomicFileWriter.write(file, scenario::write); // nothing is left of one that cannot be written
        return file.toString();
    }

    /** The robots at the end, with their last ways, what they sensed, what refused them and where they were to come. */
    private String picture(Scenario scenario, List<GeometryObject> goals, Path file) throws IOException {
        Files.createDirectories(folder);
        Pictures.lastMoments(scenario, goals, file);
        return file.toString();
    }

    /** Something that is left for people to look at. */
    @FunctionalInterface
    private interface Leaving {
        /** Answers its name. */
        String leave() throws IOException;
    }

    /**
     * Leaves it, or answers why it is not there. An optional module that is missing, or a world too deep to be written, is
     * an error in Java's sense; neither may take the place of the failure that is told here.
     */
    private static String unlessItFails(String done, Leaving leaving) {
        try {
            return leaving.leave();
        } catch (IOException | RuntimeException | LinkageError | StackOverflowError e) {
            return "none, for " + why(done, e);
        }
    }

    private static String why(String done, Throwable thrown) {
        String missing = thrown instanceof NoClassDefFoundError ? String.valueOf(thrown.getMessage()) : "";
        if (missing.contains("jackson")) {
            return "jackson-core is not on the class path, nor added to the modules (" + missing + ")";
        }
        return missing.contains("java/awt") || missing.contains("javax/imageio")
                ? "the module java.desktop is not there (" + missing + ")"
                : "it could not be " + done + ": " + thrown;
    }
}
