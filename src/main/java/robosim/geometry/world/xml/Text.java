package robosim.geometry.world.xml;

import java.util.ArrayList;
import java.util.List;

/** The text of an element, split at white space, with the position of each piece in the file. */
public final class Text {
    private final StringBuilder characters = new StringBuilder();
    private final List<Chunk> chunks = new ArrayList<>();
    private final int beginColumn;
    private int from;
    private int to;

    /** A chunk from the parser: where it begins and ends in the text, and the line of the file on which it ends. */
    private record Chunk(int begin, int end, int endLine) {}

    /** A text that begins at a column of the file. */
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

    /** The column after the current piece; 0 if unknown because of a comment before it on its line. */
    public int column() {
        Chunk chunk = chunk();
        int newline = characters.lastIndexOf("\n", from);
        if (newline >= chunk.begin) {
            return to - newline;
        }
        return chunk.begin == 0 ? beginColumn + to : 0;
    }

    // The chunk that contains the piece's last character.
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
