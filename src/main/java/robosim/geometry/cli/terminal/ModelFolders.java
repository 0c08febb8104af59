package robosim.geometry.cli.terminal;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** The folders in which commands look for models: those given, then those of the environment. */
public final class ModelFolders {
    /** Lists of folders, as Gazebo and ROS use them. */
    private static final List<String> VARIABLES = List.of(
            "GZ_SIM_RESOURCE_PATH",
            "IGN_GAZEBO_RESOURCE_PATH",
            "SDF_PATH",
            "GAZEBO_MODEL_PATH",
            "GAZEBO_RESOURCE_PATH",
            "ROS_PACKAGE_PATH");

    /** Where Gazebo keeps the models of Fuel, if not in the user's home. */
    private static final List<String> FUEL = List.of("GZ_FUEL_CACHE_PATH", "IGN_FUEL_CACHE_PATH");

    private ModelFolders() {}

    /** The given folders and those of this process's environment. */
    public static List<Path> with(List<Path> given) {
        return with(given, System.getenv());
    }

    static List<Path> with(List<Path> given, Map<String, String> environment) {
        List<Path> folders = new ArrayList<>(given);
        for (String variable : VARIABLES) {
            add(folders, environment.getOrDefault(variable, ""), "");
        }
        add(folders, environment.getOrDefault("AMENT_PREFIX_PATH", ""), "share");
        for (String variable : FUEL) {
            add(folders, environment.getOrDefault(variable, ""), "");
        }
        String home = environment.getOrDefault("HOME", "");
        add(folders, home, ".gz/fuel");
        add(folders, home, ".ignition/fuel");
        return folders;
    }

    /** Adds the folders of a list that exist; others are no mistake of the user's of this program. */
    private static void add(List<Path> folders, String list, String inner) {
        for (String each : list.split(Pattern.quote(File.pathSeparator), -1)) {
            Path folder = each.isBlank() ? null : folder(each, inner);
            if (folder != null && Files.isDirectory(folder) && !folders.contains(folder)) {
                folders.add(folder);
            }
        }
    }

    /** The folder of a name; null if it can be none. */
    private static @Nullable Path folder(String name, String inner) {
        try {
            return Path.of(name).resolve(inner);
        } catch (InvalidPathException e) {
            return null;
        }
    }
}
