package robosim.geometry.world.xml;

import java.util.ArrayList;
import java.util.List;

/** The text of an element, cut at white space, that still knows where each piece stood in the file. */
public final class Text {
    private final StringBuilder characters = new StringBuilder();
    private final List<Chunk> chunks = new ArrayList<>();
    private final int beginColumn;
    private int from;
    private int to;

    /** A piece as the parser gave it: where it begins and ends in the text, and on which line of the file it ends. */
    private record Chunk(int begin, int end, int endLine) {}

    /** A text that begins in a column of the file. */
    public Text(int beginColumn) {
        this.beginColumn = beginColumn;
    }

    public void add(char[] source, int start, int length, int endLine) {
        int begin = characters.length();
        characters.append(source, start, length);
        chunks.add(new Chunk(begin, characters.length(), endLine));
    }

    /** Goes to the next piece between white space; false at the end. */
    public boolean next() {
        from = to;
        while (from < characters.length() && isSpace(characters.charAt(from))) {
            from++;
        }
        to = from;
        while (to < characters.length() && !isSpace(characters.charAt(to))) {
            to++;
        }
        return from < to;
    }

    public String token() {
        return characters.substring(from, to);
    }

    /** The line of the current piece in the file. */
    public int line() {
        Chunk chunk = chunk();
        int line = chunk.endLine;
        for (int k = to; k < chunk.end; k++) {
            line -= characters.charAt(k) == '\n' ? 1 : 0;
        }
        return line;
    }

    /** The column after the current piece; 0 where a comment before it on its line hides that. */
    public int column() {
        Chunk chunk = chunk();
        int newline = characters.lastIndexOf("\n", from);
        if (newline >= chunk.begin) {
            return to - newline;
        }
        return chunk.begin == 0 ? beginColumn + to : 0;
    }

    // The one that holds the piece's last character.
    private Chunk chunk() {
        int k = 0;
        while (chunks.get(k).end < to) {
            k++;
        }
        return chunks.get(k);
    }

    private static boolean isSpace(char c) {
        return c == ' ' || c == '\t' || c == '\n' || c == '\r';
    }
}
