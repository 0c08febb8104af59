package robosim.geometry.chart;

/** Colours, for light and for dark, written out class by class: not every program that shows SVG knows variables. */
public final class Style {
    /** Ground, ink, faint ink, lines of the grid, band; then the colours of series. */
    private static final String[] LIGHT = {"#ffffff", "#1c2733", "#5b6b7b", "#dde3e9", "#f3f6f9"};

    private static final String[] DARK = {"#14191f", "#dfe6ee", "#9aa8b6", "#2c3641", "#1b222a"};

    private static final String[] LIGHT_SERIES = {
        "#0b63b5", "#c4570b", "#1b7f4d", "#7a3fa8", "#b3261e", "#0f7b83", "#7a5a12", "#a82c78", "#76848f"
    };
    private static final String[] DARK_SERIES = {
        "#6db3f2", "#f5a35c", "#5fc992", "#c79bf0", "#ff8f85", "#5cc8d1", "#d9b65a", "#f08cc0", "#7d8a97"
    };

    /** How many colours there are. */
    public static final int COLOURS = LIGHT_SERIES.length;

    private Style() {}

    /** The rules of all plots; the same in each, so that many may stand in one page. */
    static String css() {
        StringBuilder out = new StringBuilder(".rg text{font-family:system-ui,-apple-system,'Segoe UI',Roboto,"
                + "'Helvetica Neue',Arial,sans-serif}\n.rg path,.rg line{fill:none}\n");
        colours(LIGHT, LIGHT_SERIES, out);
        out.append("@media (prefers-color-scheme:dark){\n");
        colours(DARK, DARK_SERIES, out);
        return out.append("}\n").toString();
    }

    private static void colours(String[] base, String[] series, StringBuilder out) {
        out.append(".rg .ground{fill:").append(base[0]).append("}\n.rg .ink{fill:");
        out.append(base[1]).append("}\n.rg .faint{fill:").append(base[2]).append("}\n.rg .grid{stroke:");
        out.append(base[3]).append("}\n.rg .frame{stroke:").append(base[2]).append("}\n.rg .band{fill:");
        out.append(base[4]).append("}\n");
        for (int k = 0; k < series.length; k++) {
            out.append(".rg .s").append(k).append("{stroke:").append(series[k]).append("}\n");
            out.append(".rg .f")
                    .append(k)
                    .append("{fill:")
                    .append(series[k])
                    .append(";stroke:")
                    .append(series[k]);
            out.append("}\n.rg .h")
                    .append(k)
                    .append("{fill:")
                    .append(base[0])
                    .append(";stroke:")
                    .append(series[k]);
            out.append("}\n.rg .t").append(k).append("{fill:").append(series[k]).append("}\n");
        }
    }
}
