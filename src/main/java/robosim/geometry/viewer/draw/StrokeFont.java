package robosim.geometry.viewer.draw;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * A stroke font for images: available on every machine, with the same pictures everywhere. A character without a glyph
 * is drawn as a box.
 */
final class StrokeFont {
    /** Units of the table below per font size; capitals are 7 units high. */
    private static final double UNITS = 9.6;

    /** Units between two letters. */
    private static final double GAP = 1.8;

    /**
     * A letter, its width, and its strokes of points x,y: 0 is the base line, 5 the height of small letters. A stroke
     * after a tilde is round, one after an at sign is round and closed.
     */
    private static final String TABLE = """
            ! 0 | 0,7 0,2.2 | 0,0 0,0.1
            " 1.6 | 0,7 0,5 | 1.6,7 1.6,5
            # 4.4 | 1,0 2,7 | 2.8,0 3.8,7 | 0,2.2 4.2,2.2 | 0.4,4.8 4.4,4.8
            $ 4 |~ 4,6 2.4,6.6 0,6.4 0,3.8 4,3.4 4,0.6 1.6,0.4 0,1.2 | 2,7.8 2,-0.8
            % 5.4 | 0.6,0 4.8,7 |@ 0,4 2,4 2,7 0,7 |@ 3.4,0 5.4,0 5.4,3 3.4,3
            & 4.8 |~ 4.6,3 3.8,0 1.6,0 0,0 0,3.4 3,3.6 3.2,7 0.6,7.2 0.6,4.6 4.8,0
            ' 0 | 0,7 0,5
            ( 1.6 |~ 1.6,7.8 0,6 0,0 1.6,-1.8
            ) 1.6 |~ 0,7.8 1.6,6 1.6,0 0,-1.8
            * 3.2 | 1.6,7 1.6,3.6 | 0,6.2 3.2,4.4 | 0,4.4 3.2,6.2
            + 4.4 | 2.2,5.2 2.2,0.8 | 0,3 4.4,3
            , 0.6 | 0.5,0.4 0,-1.4
            - 2.4 | 0,2.6 2.4,2.6
            . 0 | 0,0 0,0.1
            / 2.8 | 0,-1 2.8,7.4
            0 4 |@ 0,0 4,0 4,7 0,7
            1 2.6 | 0,5.6 1.6,7 1.6,0
            2 4 |~ 0,5.6 0.2,7 4,7.4 4,4 0,0 | 0,0 4,0
            3 4 |~ 0,6.2 0.8,7 4,7.4 4,3.9 1.4,3.8 |~ 1.4,3.8 4.2,3.8 4.2,-0.4 0.8,0 0,0.8
            4 4.2 | 3.2,0 3.2,7 0,2 4.2,2
            5 4 | 3.7,7 0.5,7 0.3,3.9 |~ 0.3,3.9 1,4.5 4,4.8 4,0 0.8,-0.2 0,0.7
            6 4 |~ 3.6,6.6 2.8,7 0,7.2 0,2.2 |@ 0,0 4,0 4,4.4 0,4.4
            7 3.8 | 0,7 3.8,7 1.2,0
            8 4 |@ 0.3,3.8 3.7,3.8 3.7,7 0.3,7 |@ 0,0 4,0 4,3.8 0,3.8
            9 4 |~ 0.4,0.4 1.2,0 4,-0.2 4,4.8 |@ 0,2.6 4,2.6 4,7 0,7
            : 0 | 0,0.2 0,0.3 | 0,4 0,4.1
            ; 0.6 | 0.5,0.4 0,-1.4 | 0.5,4 0.5,4.1
            < 4 | 4,5.4 0,3 4,0.6
            = 4.4 | 0,2 4.4,2 | 0,4 4.4,4
            > 4 | 0,5.4 4,3 0,0.6
            ? 3.4 |~ 0,6 0.4,7 3.4,7.4 3.4,4.6 1.6,4 1.6,2.2 | 1.6,0 1.6,0.1
            @ 6 |@ 1.8,1 4.2,1 4.2,4.4 1.8,4.4 |~ 4.2,4.4 4.2,1 6,1 6,3 6,6.4 3,6.4 0,6.4 0,2.6 0,-1.2 3.4,-1.2 4.6,-0.6
            A 4.6 | 0,0 2.3,7 4.6,0 | 0.8,2.4 3.8,2.4
            B 4 | 0,0 0,7 2,7 |~ 2,7 3.8,7 3.8,3.7 2,3.7 | 2,3.7 0,3.7 |~ 2,3.7 4.2,3.7 4.2,0 2,0 | 2,0 0,0
            C 4.4 |~ 4.4,6 3.6,7 0,7.4 0,3.5 0,-0.4 3.6,0 4.4,1
            D 4.4 | 0,0 0,7 1.6,7 |~ 1.6,7 4.4,7 4.4,3.5 4.4,0 1.6,0 | 1.6,0 0,0
            E 3.6 | 3.6,7 0,7 0,0 3.6,0 | 0,3.7 3,3.7
            F 3.4 | 3.4,7 0,7 0,0 | 0,3.7 2.8,3.7
            G 4.6 |~ 4.4,6 3.6,7 0,7.4 0,3.5 0,-0.4 3.8,0 4.5,0.8 | 4.5,0.8 4.5,3.2 2.8,3.2
            H 4.4 | 0,0 0,7 | 4.4,0 4.4,7 | 0,3.7 4.4,3.7
            I 0 | 0,0 0,7
            J 2.4 |~ 2.2,7 2.2,2 2.2,0 0.8,-0.1 0,0.2
            K 4.2 | 0,0 0,7 | 4.2,7 0,2.8 | 1.4,4.2 4.2,0
            L 3.4 | 0,7 0,0 3.4,0
            M 5.2 | 0,0 0,7 2.6,2 5.2,7 5.2,0
            N 4.4 | 0,0 0,7 4.4,0 4.4,7
            O 5 |@ 0,0 5,0 5,7 0,7
            P 4 | 0,0 0,7 2,7 |~ 2,7 4.2,7 4.2,3.2 2,3.2 | 2,3.2 0,3.2
            Q 5 |@ 0,0 5,0 5,7 0,7 | 3.2,1.4 5,-0.8
            R 4.2 | 0,0 0,7 2,7 |~ 2,7 4.2,7 4.2,3.3 2,3.3 | 0,3.3 2.2,3.3 4.2,0
            S 4 |~ 3.8,6.2 3,7 0,7.4 0,3.8 4.2,3.6 4.2,-0.4 0.8,0 0,0.8
            T 4.4 | 0,7 4.4,7 | 2.2,7 2.2,0
            U 4.4 | 0,7 0,3 |~ 0,3 0,0 2.2,0 4.4,0 4.4,3 | 4.4,3 4.4,7
            V 4.6 | 0,7 2.3,0 4.6,7
            W 6.4 | 0,7 1.6,0 3.2,6 4.8,0 6.4,7
            X 4.4 | 0,0 4.4,7 | 0,7 4.4,0
            Y 4.4 | 0,7 2.2,3.4 4.4,7 | 2.2,3.4 2.2,0
            Z 4.2 | 0,7 4.2,7 0,0 4.2,0
            [ 1.4 | 1.4,7.8 0,7.8 0,-1.6 1.4,-1.6
            \\ 2.8 | 0,7.4 2.8,-1
            ] 1.4 | 0,7.8 1.4,7.8 1.4,-1.6 0,-1.6
            ^ 3.6 | 0,4.6 1.8,7 3.6,4.6
            _ 4 | 0,-1.4 4,-1.4
            ` 1 | 0,7.4 1,6
            a 3.5 |~ 0.3,4.4 1,5 3.5,5.2 3.5,3.2 | 3.5,3.2 3.5,0 |~ 3.5,2.9 0,3.2 0,-0.2 2.4,-0.2 3.5,1.4
            b 3.8 | 0,0 0,7.2 |@ 0,0 3.8,0 3.8,5 0,5
            c 3.3 |~ 3.3,4.4 2.8,5 0,5.2 0,2.5 0,-0.2 2.8,0 3.3,0.6
            d 3.8 | 3.8,0 3.8,7.2 |@ 0,0 3.8,0 3.8,5 0,5
            e 3.8 |~ 0,2.6 3.8,2.6 | 3.8,2.6 3.8,2.7 |~ 3.8,2.6 3.8,5 2,5 0,5 0,2.5 0,-0.2 2.8,-0.1 3.6,0.7
            f 2.4 |~ 2.4,7.1 0.9,7.5 0.9,5.4 | 0.9,5.4 0.9,0 | 0,4.8 2.2,4.8
            g 3.8 |@ 0,0 3.8,0 3.8,5 0,5 | 3.8,5 3.8,0 |~ 3.8,0 3.8,-2.4 0.9,-2 0.4,-1.6
            h 3.6 | 0,0 0,7.2 |~ 0,3 0.4,5 3.6,5.6 3.6,2.8 | 3.6,2.8 3.6,0
            i 0 | 0,0 0,5 | 0,6.8 0,6.9
            j 1 | 1,6.8 1,6.9 | 1,5 1,-0.6 |~ 1,-0.6 1,-2 0,-2
            k 3.4 | 0,0 0,7.2 | 3.2,5 0,2 | 1.1,3 3.4,0
            l 0 | 0,0 0,7.2
            m 6 | 0,0 0,5 |~ 0,3 0.4,5 3,5.6 3,2.8 | 3,2.8 3,0 |~ 3,3 3.4,5 6,5.6 6,2.8 | 6,2.8 6,0
            n 3.6 | 0,0 0,5 |~ 0,3 0.4,5 3.6,5.6 3.6,2.8 | 3.6,2.8 3.6,0
            o 3.9 |@ 0,0 3.9,0 3.9,5 0,5
            p 3.8 | 0,-2 0,5 |@ 0,0 3.8,0 3.8,5 0,5
            q 3.8 | 3.8,-2 3.8,5 |@ 0,0 3.8,0 3.8,5 0,5
            r 2.2 | 0,0 0,5 |~ 0,2.6 0.2,4.8 2.2,5
            s 3.1 |~ 2.9,4.5 2.4,5 0,5.4 0,2.7 3.2,2.5 3.2,-0.4 0.6,0 0,0.5
            t 2.2 |~ 0.8,6.6 0.8,1.6 0.8,0 2.2,0 | 0,4.9 2.2,4.9
            u 3.6 | 0,5 0,2.2 |~ 0,2.2 0,-0.6 3.2,0 3.6,2 | 3.6,5 3.6,0
            v 3.6 | 0,5 1.8,0 3.6,5
            w 5 | 0,5 1.25,0 2.5,4.4 3.75,0 5,5
            x 3.5 | 0,0 3.5,5 | 0,5 3.5,0
            y 3.6 | 0,5 1.8,0 | 3.6,5 1.2,-1.6 0.3,-2
            z 3.3 | 0,5 3.3,5 0,0 3.3,0
            { 2 |~ 2,7.8 0.8,7.8 0.8,5.8 0.8,3 0,3 |~ 0,3 0.8,3 0.8,0.2 0.8,-1.8 2,-1.8
            | 0 | 0,7.8 0,-1.8
            } 2 |~ 0,7.8 1.2,7.8 1.2,5.8 1.2,3 2,3 |~ 2,3 1.2,3 1.2,0.2 1.2,-1.8 0,-1.8
            ~ 4.2 |~ 0,2.4 0.8,3.8 2.2,3 3.4,2.2 4.2,3.6
            """;

    private static final Map<Integer, Glyph> GLYPHS = parse();
    private static final Glyph UNKNOWN = new Glyph(3.4, List.of(new double[] {0, 0, 3.4, 0, 3.4, 7, 0, 7, 0, 0}));

    private StrokeFont() {}

    /** A glyph: its width and its lines. */
    private static final class Glyph {
        private final double width;
        private final List<double[]> lines;

        Glyph(double width, List<double[]> lines) {
            this.width = width;
            this.lines = lines;
        }
    }

    /** The width of a text in pixels. */
    static double width(String text, double size) {
        double units = 0;
        for (int c : text.codePoints().toArray()) {
            units += (c == ' ' ? 2.4 : glyph(c).width) + GAP;
        }
        return Math.max(0, units - GAP) * size / UNITS;
    }

    /** The lines of a text whose base line begins at a point; x, y, x, y ... with y down. */
    static List<double[]> lines(String text, double size, double x, double y) {
        List<double[]> lines = new ArrayList<>();
        double scale = size / UNITS;
        double at = 0;
        for (int c : text.codePoints().toArray()) {
            if (c == ' ') {
                at += 2.4 + GAP;
                continue;
            }
            Glyph glyph = glyph(c);
            for (double[] line : glyph.lines) {
                double[] placed = new double[line.length];
                for (int k = 0; k < line.length; k += 2) {
                    placed[k] = x + (at + line[k]) * scale;
                    placed[k + 1] = y - line[k + 1] * scale;
                }
                lines.add(placed);
            }
            at += glyph.width + GAP;
        }
        return lines;
    }

    private static Glyph glyph(int c) {
        return GLYPHS.getOrDefault(c, UNKNOWN);
    }

    private static Map<Integer, Glyph> parse() {
        Map<Integer, Glyph> glyphs = new HashMap<>();
        TABLE.lines().forEach(row -> {
            int bar = row.indexOf(" |", 2);
            double width = Double.parseDouble(row.substring(2, bar));
            List<double[]> lines = new ArrayList<>();
            for (String stroke : row.substring(bar + 2).split("\\|", -1)) {
                char manner = stroke.charAt(0);
                double[] points = points(manner == ' ' ? stroke : stroke.substring(1));
                lines.add(manner == ' ' ? points : rounded(points, manner == '@'));
            }
            glyphs.put((int) row.charAt(0), new Glyph(width, lines));
        });
        return glyphs;
    }

    private static double[] points(String text) {
        String[] numbers = text.trim().split("[ ,]", -1);
        double[] points = new double[numbers.length];
        for (int k = 0; k < points.length; k++) {
            points[k] = Double.parseDouble(numbers[k]);
        }
        return points;
    }

    /** A quadratic B-spline with these control points; an open one begins and ends at the outer two. */
    private static double[] rounded(double[] p, boolean closed) {
        int n = p.length / 2;
        List<Double> curve = new ArrayList<>();
        int first = closed ? 0 : 1;
        int last = closed ? n : n - 1;
        for (int k = first; k < last; k++) {
            int before = Math.floorMod(k - 1, n);
            int after = (k + 1) % n;
            boolean opens = !closed && k == 1;
            boolean ends = !closed && k == n - 2;
            for (int step = 0; step <= 8; step++) {
                double t = step / 8.0;
                for (int axis = 0; axis < 2; axis++) {
                    double control = p[2 * k + axis];
                    double from = opens ? p[axis] : (p[2 * before + axis] + control) / 2;
                    double to = ends ? p[2 * n - 2 + axis] : (p[2 * after + axis] + control) / 2;
                    curve.add((1 - t) * (1 - t) * from + 2 * t * (1 - t) * control + t * t * to);
                }
            }
        }
        return n < 3 ? p : curve.stream().mapToDouble(Double::doubleValue).toArray();
    }
}
