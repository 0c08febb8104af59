package robosim.geometry.chart;

import java.util.ArrayList;
import java.util.List;

/** How wide words are, about: no font is at hand where a plot is written. */
final class TextWidths {
    private TextWidths() {}

    /** The width of a line, a little too large rather than too small. */
    static double width(String text, double size) {
        double ems = 0;
        for (int k = 0; k < text.length(); k++) {
            char c = text.charAt(k);
            ems += "iljtf.,:;|!'()[] I".indexOf(c) >= 0
                    ? 0.33
                    : "mwMW%@".indexOf(c) >= 0 ? 0.9 : Character.isUpperCase(c) ? 0.69 : c > 0x2000 ? 0.45 : 0.6;
        }
        return ems * size;
    }

    /** The text in lines no wider than a width. */
    static List<String> wrap(String text, double size, double width) {
        List<String> lines = new ArrayList<>();
        StringBuilder line = new StringBuilder();
        for (String word : text.split(" ", -1)) {
            if (line.length() > 0 && width(line + " " + word, size) > width) {
                lines.add(line.toString());
                line.setLength(0);
            }
            line.append(line.length() == 0 ? "" : " ").append(word);
        }
        lines.add(line.toString());
        return lines;
    }
}
