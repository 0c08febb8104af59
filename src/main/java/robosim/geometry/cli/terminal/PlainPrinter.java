package robosim.geometry.cli.terminal;

import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.HexFormat;

/**
 * Prints to a terminal, which a file's name or a peer's text must not be able to control: characters other than text, tabs and
 * line feeds are escaped, as in {@code \}{@code u001b}.
 */
public final class PlainPrinter extends PrintWriter {
    /** A printer that flushes after each line. */
    public PlainPrinter(OutputStream terminal, Charset charset) {
        super(new OutputStreamWriter(terminal, charset), true);
    }

    /** Prints characters that control the terminal. */
    void control(String characters) {
        super.write(characters, 0, characters.length());
    }

    @Override
    public void write(int c) {
        write(String.valueOf((char) c));
    }

    @Override
    public void write(char[] text, int at, int length) {
        write(new String(text, at, length));
    }

    @Override
    public void write(String text, int at, int length) {
        String part = text.substring(at, at + length);
        String plain = part.chars().allMatch(c -> isPlain((char) c)) ? part : escaped(part);
        super.write(plain, 0, plain.length());
    }

    private static String escaped(String text) {
        StringBuilder escaped = new StringBuilder();
        for (int k = 0; k < text.length(); k++) {
            char c = text.charAt(k);
            boolean isLineEnd = c == '\r' && k + 1 < text.length() && text.charAt(k + 1) == '\n';
            if (isPlain(c) || isLineEnd) {
                escaped.append(c);
            } else {
                escaped.append("\\u").append(HexFormat.of().toHexDigits(c));
            }
        }
        return escaped.toString();
    }

    /** Not what controls a terminal, or turns the direction of the text. */
    private static boolean isPlain(char c) {
        return c == '\n'
                || c == '\t'
                || (Character.getType(c) != Character.CONTROL && Character.getType(c) != Character.FORMAT);
    }
}
