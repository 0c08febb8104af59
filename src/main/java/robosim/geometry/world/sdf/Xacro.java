package robosim.geometry.world.sdf;

import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.LeftOut;

/** The macros of ROS's xacro in a file, which are not carried out: one report for all of them. */
final class Xacro {
    private @Nullable SdfFile file;
    private int line;
    private String first = "";
    private int count;

    /** Whether an element is a macro. */
    static boolean isMacro(String name) {
        return name.startsWith("xacro:");
    }

    /** Whether a value is to be computed, as {@code ${radius}} and {@code $(find robot)} are. */
    static boolean isExpression(String value) {
        return value.contains("${") || value.contains("$(");
    }

    /** What to do with a file that has macros. */
    static String remedy(String file, String result) {
        return "macros are not carried out; run the file through xacro first: xacro " + file + " > " + result;
    }

    /** Counts a macro, which is told as it is written. */
    void add(SdfFile from, int at, String written) {
        if (count++ == 0) {
            file = from;
            line = at;
            first = written;
        }
    }

    /** Adds what was found to what is left out of the root. */
    void report(SdfElement root) {
        if (file != null) {
            String what = count == 1 ? first : first + " and " + (count - 1) + " more";
            String result = root.name.equals("robot") ? "NEW.urdf" : "NEW.sdf";
            root.skipped.add(new LeftOut(
                    file.shown(), line, what, remedy(String.valueOf(file.path().getFileName()), result)));
        }
    }
}
