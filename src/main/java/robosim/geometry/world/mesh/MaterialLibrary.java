package robosim.geometry.world.mesh;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.material.Color;
import robosim.geometry.material.Material;
import robosim.geometry.world.shared.CountedStream;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.shared.Limits;
import robosim.geometry.world.shared.Numbers;
import robosim.geometry.world.shared.RegularFile;
import robosim.geometry.world.shared.TextureFiles;

/**
 * The materials of MTL files, by name. Of each its {@code Kd}, {@code Ks}, {@code Ns}, {@code Ke} and {@code map_Kd} are read;
 * everything else is ignored. A picture is read when its material is asked for.
 */
final class MaterialLibrary {
    /** How many words follow an option of {@code map_Kd}. */
    private static final Map<String, Integer> OPTIONS = Map.ofEntries(
            Map.entry("-blendu", 1),
            Map.entry("-blendv", 1),
            Map.entry("-bm", 1),
            Map.entry("-boost", 1),
            Map.entry("-cc", 1),
            Map.entry("-clamp", 1),
            Map.entry("-imfchan", 1),
            Map.entry("-mm", 2),
            Map.entry("-o", 3),
            Map.entry("-s", 3),
            Map.entry("-t", 3),
            Map.entry("-texres", 1));

    private final TextureFiles textures;
    private final Map<String, Entry> entries = new HashMap<>();

    /** A material while and after it is read. */
    private static final class Entry {
        private final Path file;
        private Material material = Material.DEFAULT;
        private @Nullable String picture;
        private int line;

        Entry(Path file) {
            this.file = file;
        }
    }

    MaterialLibrary(TextureFiles textures) {
        this.textures = textures;
    }

    /** Adds the materials of a file; of two with one name the first stays. */
    void add(Path file) throws FileProblem {
        int line = 0;
        try (InputStream in = RegularFile.open(file);
                BufferedReader lines =
                        new BufferedReader(new InputStreamReader(CountedStream.bounded(in), StandardCharsets.UTF_8))) {
            Entry entry = new Entry(file); // what comes before the first material is of none
            for (String text = line(lines); text != null; text = line(lines)) {
                line++;
                String[] words = Numbers.words(text.replaceFirst("#.*", ""));
                if (words[0].equals("newmtl")) {
                    entry = new Entry(file);
                    entries.putIfAbsent(
                            text.strip().substring("newmtl".length()).strip(), entry);
                } else {
                    statement(entry, words, line);
                }
            }
        } catch (IllegalArgumentException e) {
            throw new FileProblem(file.toString(), line, 0, String.valueOf(e.getMessage()), e);
        } catch (IOException e) {
            throw FileProblem.unreadable(file, e);
        }
    }

    /** The next line; a long one is refused before it is read into memory. */
    private static @Nullable String line(BufferedReader in) throws IOException {
        StringBuilder text = new StringBuilder();
        int c = in.read();
        if (c < 0) {
            return null;
        }
        for (; c >= 0 && c != '\n'; c = in.read()) {
            text.append((char) c);
            if (text.length() > Limits.MAX_STATEMENT) {
                throw new IllegalArgumentException("a statement must have at most " + Limits.MAX_STATEMENT
                        + " characters; end lines with a line feed, and split larger polygons (got: more)");
            }
        }
        return text.toString();
    }

    private static void statement(Entry entry, String[] words, int line) {
        switch (words[0]) {
            case "Kd" -> entry.material = entry.material.withColor(color(words));
            case "Ke" -> entry.material = entry.material.withEmission(color(words));
            case "Ks" -> {
                Color specular = color(words);
                entry.material = entry.material.withSpecular(
                        Math.max(specular.red(), Math.max(specular.green(), specular.blue())));
            }
            case "Ns" -> {
                double exponent = words.length < 2 ? Double.NaN : Numbers.parse(words[1]);
                entry.material = entry.material.withShininess(Math.min(Math.max(1, exponent), Material.MOST_SHININESS));
            }
            case "map_Kd" -> {
                entry.picture = picture(words);
                entry.line = line;
            }
            default -> {}
        }
    }

    /** One number for all three, or three; what is brighter than white is white. */
    private static Color color(String[] words) {
        if (words.length != 2 && words.length < 4) {
            throw new IllegalArgumentException(
                    words[0] + " must have three numbers, red, green and blue (got: " + (words.length - 1) + ")");
        }
        double[] shares = new double[3];
        for (int k = 0; k < 3; k++) {
            shares[k] = Math.min(Math.max(0, Numbers.parse(words[words.length == 2 ? 1 : k + 1])), 1);
        }
        return new Color(shares[0], shares[1], shares[2]);
    }

    /** The name after the options, which may have spaces; Windows programs write {@code \\} where {@code /} is meant. */
    private static String picture(String[] words) {
        int at = 1;
        while (at < words.length && OPTIONS.containsKey(words[at])) {
            int most = OPTIONS.getOrDefault(words[at], 0);
            at++;
            // Of the three numbers of an offset or a scale the last two may be left out.
            for (int k = 0; k < most && at < words.length && (k == 0 || isNumber(words[at])); k++) {
                at++;
            }
        }
        StringBuilder name = new StringBuilder();
        for (int k = at; k < words.length; k++) {
            name.append(k == at ? "" : " ").append(words[k]);
        }
        return name.toString().replace('\\', '/');
    }

    private static boolean isNumber(String word) {
        return word.matches("[+-]?[0-9.]+([eE][+-]?[0-9]+)?");
    }

    /** A material with its picture; the default for a name that is not known. */
    Material get(String name) throws FileProblem {
        Entry entry = entries.get(name);
        if (entry == null) {
            return Material.DEFAULT;
        }
        String picture = entry.picture;
        if (picture != null) {
            entry.picture = null;
            Path folder = entry.file.toAbsolutePath().resolveSibling("");
            try {
                entry.material = entry.material.withTexture(textures.read(folder, picture));
            } catch (FileProblem | IllegalArgumentException e) {
                textures.leaveOut(
                        entry.file, entry.line, "map_Kd of material " + name, String.valueOf(e.getMessage()), e);
            }
        }
        return entry.material;
    }
}
