package robosim.geometry.viewer.draw;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Text;

/** Writes SVG whose colours are in a style sheet, for light and dark themes. */
final class SvgCanvas implements Canvas {
    private final double width;
    private final double height;
    private final String title;
    private final StringBuilder body = new StringBuilder();
    private final Map<Ink, Integer> inks = new LinkedHashMap<>();
    private int depth = 1;

    SvgCanvas(double width, double height, String title) {
        this.width = width;
        this.height = height;
        this.title = title;
    }

    /** The document so far. */
    String document() {
        StringBuilder svg = new StringBuilder(body.length() + 4096);
        svg.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"")
                .append(number(width))
                .append("\" height=\"")
                .append(number(height))
                .append("\" viewBox=\"0 0 ")
                .append(number(width))
                .append(' ')
                .append(number(height))
                .append("\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" fill=\"none\" stroke-linejoin=\"round\"")
                .append(" stroke-linecap=\"round\">\n<title>")
                .append(Text.xml(title))
                .append("</title>\n<style>\ntext{paint-order:stroke;stroke-width:3px}\n");
        sheet(svg, Theme.LIGHT);
        svg.append("@media (prefers-color-scheme:dark){\n");
        sheet(svg, Theme.DARK);
        return svg.append("}\n</style>\n").append(body).append("</svg>\n").toString();
    }

    private void sheet(StringBuilder svg, Theme theme) {
        svg.append("text{stroke:").append(Ink.hex(Palette.FLOOR.in(theme))).append("}\n");
        inks.forEach((ink, number) -> {
            String colour = Ink.hex(ink.in(theme));
            svg.append(".f" + number + "{fill:" + colour + "}.s" + number + "{stroke:" + colour + "}\n");
        });
    }

    @Override
    public void open(String role, String name) {
        indent().append("<g class=\"").append(role).append("\">");
        if (!name.isEmpty()) {
            body.append("<title>").append(Text.xml(name)).append("</title>");
        }
        body.append('\n');
        depth++;
    }

    @Override
    public void close() {
        depth--;
        indent().append("</g>\n");
    }

    @Override
    public void clip(double x, double y, double width, double height) {
        indent().append("<clipPath id=\"map\"><rect x=\"")
                .append(number(x))
                .append("\" y=\"")
                .append(number(y));
        body.append("\" width=\"").append(number(width)).append("\" height=\"").append(number(height));
        body.append("\"/></clipPath>\n");
        indent().append("<g clip-path=\"url(#map)\">\n");
        depth++;
    }

    @Override
    public void unclip() {
        close();
    }

    @Override
    public void polygons(List<double[]> corners, Style style) {
        indent().append("<path d=\"");
        for (double[] polygon : corners) {
            path(polygon);
            body.append('Z');
        }
        body.append('"');
        end(style);
    }

    @Override
    public void polyline(double[] corners, Style style) {
        indent().append("<path d=\"");
        path(corners);
        body.append('"');
        end(style);
    }

    private void path(double[] corners) {
        for (int k = 0; k < corners.length; k += 2) {
            body.append(k == 0 ? 'M' : 'L')
                    .append(number(corners[k]))
                    .append(' ')
                    .append(number(corners[k + 1]));
        }
    }

    @Override
    public void circle(double x, double y, double radius, Style style) {
        indent().append("<circle cx=\"")
                .append(number(x))
                .append("\" cy=\"")
                .append(number(y))
                .append("\" r=\"")
                .append(number(radius))
                .append('"');
        end(style);
    }

    @Override
    public void sector(double x, double y, double radius, double from, double sweep, Style style) {
        indent().append("<path d=\"M").append(number(x)).append(' ').append(number(y));
        arcPath('L', x, y, radius, from, sweep);
        body.append("Z\"");
        end(style);
    }

    @Override
    public void arc(double x, double y, double radius, double from, double sweep, Style style) {
        indent().append("<path d=\"");
        arcPath('M', x, y, radius, from, sweep);
        body.append('"');
        end(style);
    }

    private void arcPath(char first, double x, double y, double radius, double from, double sweep) {
        double begin = StrictMath.toRadians(from);
        double end = StrictMath.toRadians(from + sweep);
        body.append(first)
                .append(number(x + radius * StrictMath.cos(begin)))
                .append(' ')
                .append(number(y - radius * StrictMath.sin(begin)))
                .append('A')
                .append(number(radius))
                .append(' ')
                .append(number(radius))
                .append(" 0 ")
                .append(sweep > 180 ? "1 0 " : "0 0 ")
                .append(number(x + radius * StrictMath.cos(end)))
                .append(' ')
                .append(number(y - radius * StrictMath.sin(end)));
    }

    @Override
    public void text(double x, double y, String text, Anchor anchor, double size, Ink ink) {
        indent().append("<text x=\"").append(number(x)).append("\" y=\"").append(number(y));
        body.append("\" font-size=\"").append(number(size)).append('"');
        if (anchor != Anchor.START) {
            body.append(" text-anchor=\"")
                    .append(anchor == Anchor.MIDDLE ? "middle" : "end")
                    .append('"');
        }
        body.append(" class=\"f").append(index(ink)).append("\">");
        body.append(Text.xml(text)).append("</text>\n");
    }

    private void end(Style style) {
        body.append(" class=\"");
        classes(style.fill(), 'f');
        body.append(style.fill() != null && style.stroke() != null ? " " : "");
        classes(style.stroke(), 's');
        body.append('"');
        if (style.fill() != null && style.fillOpacity() < 1) {
            body.append(" fill-opacity=\"").append(number(style.fillOpacity())).append('"');
        }
        if (style.stroke() != null) {
            body.append(" stroke-width=\"").append(number(style.width())).append('"');
            if (style.strokeOpacity() < 1) {
                body.append(" stroke-opacity=\"")
                        .append(number(style.strokeOpacity()))
                        .append('"');
            }
            if (style.dash() > 0) {
                body.append(" stroke-dasharray=\"").append(number(style.dash())).append('"');
            }
        }
        body.append("/>\n");
    }

    private void classes(@Nullable Ink ink, char prefix) {
        if (ink != null) {
            body.append(prefix).append(index(ink));
        }
    }

    private int index(Ink ink) {
        return inks.computeIfAbsent(ink, unseen -> inks.size());
    }

    private StringBuilder indent() {
        return body.append(" ".repeat(depth));
    }

    /** A number with at most two decimals; the same on every machine. */
    static String number(double value) {
        long hundredths = Math.round(value * 100);
        long whole = Math.abs(hundredths) / 100;
        long rest = Math.abs(hundredths) % 100;
        String sign = hundredths < 0 ? "-" : "";
        if (rest == 0) {
            return sign + whole;
        }
        return sign + whole + (rest % 10 == 0 ? "." + rest / 10 : rest < 10 ? ".0" + rest : "." + rest);
    }
}
