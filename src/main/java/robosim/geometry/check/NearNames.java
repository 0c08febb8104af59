package robosim.geometry.check;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/** Finds what someone who wrote a name that does not exist may have meant. */
public final class NearNames {
    /** The most names that are returned. */
    private static final int MOST = 3;

    /** Names looked at; a message does not compare a name with those of a whole city. */
    private static final int LOOKED_AT = 1_000;

    /** Names are compared up to this length. */
    private static final int LONGEST = 64;

    /** One edit is allowed, and another one for so many letters. */
    private static final int LETTERS = 4;

    private record Near(String name, int edits) {}

    private NearNames() {}

    /**
     * The names closest to a given one, at most three and the closest first: few letters differ, are missing or are added,
     * capitals aside, or a name begins with the given one. Empty if none is close.
     */
    public static List<String> of(String given, Iterable<String> names) {
        String wanted = plain(given);
        int most = 1 + wanted.length() / LETTERS;
        List<Near> near = new ArrayList<>();
        int looked = 0;
        for (String name : names) {
            if (++looked > LOOKED_AT) {
                break;
            }
            String other = plain(name);
            int edits = wanted.length() > 2 && other.startsWith(wanted) ? 1 : edits(wanted, other, most);
            if (edits <= most) {
                near.add(new Near(name, edits));
            }
        }
        near.sort(Comparator.comparingInt(Near::edits));
        return near.stream().limit(MOST).map(Near::name).toList();
    }

    private static String plain(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        return lower.length() > LONGEST ? lower.substring(0, LONGEST) : lower;
    }

    /** The Levenshtein distance, or a number above {@code most} if it is larger than that. */
    private static int edits(String a, String b, int most) {
        if (Math.abs(a.length() - b.length()) > most) {
            return most + 1;
        }
        int[] row = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            row[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int replaced = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(replaced, 1 + Math.min(row[j], row[j - 1]));
            }
        }
        return row[b.length()];
    }
}
