package robosim.geometry.viewer.window;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import robosim.geometry.viewer.draw.Palette;
import robosim.geometry.viewer.draw.Theme;

/** The keys of a window and what each does, drawn over it when it is asked for. */
final class KeyHelp {
    private static final int MARGIN = 18;
    private static final int LINE = 20;
    private static final int GAP = 16;
    private static final int PAPER_ALPHA = 235;

    /** Each action with its keys, in the order in which they were bound. */
    private final Map<String, String> keys = new LinkedHashMap<>();

    private boolean isShown;

    /**
     * Notes a key; several of one action are listed together.
     *
     * @param stroke as Swing names it
     * @param action what it does; empty for a key that is not listed
     */
    void add(String stroke, String action) {
        if (!action.isEmpty()) {
            keys.merge(action, named(stroke), (before, more) -> before + ", " + more);
        }
    }

    /** How people name a key. */
    private static String named(String stroke) {
        return switch (stroke) {
            case "ESCAPE" -> "Esc";
            case "control S" -> "Ctrl+S";
            default ->
                stroke.length() < 3
                        ? stroke.toUpperCase(Locale.ROOT)
                        : stroke.charAt(0) + stroke.substring(1).toLowerCase(Locale.ROOT);
        };
    }

    Map<String, String> keys() {
        return keys;
    }

    void toggle() {
        isShown = !isShown;
    }

    void hide() {
        isShown = false;
    }

    boolean isShown() {
        return isShown;
    }

    /** Draws the list in the middle of a window, in two columns where one is too high for it. */
    void paint(Graphics graphics, int width, int height, Theme theme) {
        Graphics2D page = (Graphics2D) graphics.create();
        page.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        Font plain = new Font(Font.SANS_SERIF, Font.PLAIN, 13);
        Font bold = plain.deriveFont(Font.BOLD);
        FontMetrics metrics = page.getFontMetrics(plain);
        FontMetrics wide = page.getFontMetrics(bold);
        int keyWidth = keys.values().stream().mapToInt(wide::stringWidth).max().orElse(0);
        int wordWidth =
                keys.keySet().stream().mapToInt(metrics::stringWidth).max().orElse(0);
        int columns = keys.size() * LINE + 2 * MARGIN <= height ? 1 : 2;
        int rows = (keys.size() + columns - 1) / columns;
        int column = keyWidth + GAP + wordWidth;
        int boxWidth = columns * column + (columns - 1) * 2 * GAP + 2 * MARGIN;
        int boxHeight = rows * LINE + 2 * MARGIN;
        int left = Math.max(0, (width - boxWidth) / 2);
        int top = Math.max(0, (height - boxHeight) / 2);
        Color paper = new Color(Palette.PAPER.in(theme));
        page.setColor(new Color(paper.getRed(), paper.getGreen(), paper.getBlue(), PAPER_ALPHA));
        page.fillRoundRect(left, top, boxWidth, boxHeight, MARGIN, MARGIN);
        page.setColor(new Color(Palette.QUIET.in(theme)));
        page.drawRoundRect(left, top, boxWidth, boxHeight, MARGIN, MARGIN);
        int k = 0;
        for (Map.Entry<String, String> each : keys.entrySet()) {
            int x = left + MARGIN + k / rows * (column + 2 * GAP);
            int y = top + MARGIN + k % rows * LINE + metrics.getAscent();
            page.setColor(new Color(Palette.TEXT.in(theme)));
            page.setFont(bold);
            page.drawString(each.getValue(), x, y);
            page.setFont(plain);
            page.drawString(each.getKey(), x + keyWidth + GAP, y);
            k++;
        }
        page.dispose();
    }
}
