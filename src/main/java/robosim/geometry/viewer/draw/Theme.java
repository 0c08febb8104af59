package robosim.geometry.viewer.draw;

/** On what an image is drawn. An SVG holds both themes and follows its reader's choice. */
public enum Theme {
    /** Dark ink on light paper. */
    LIGHT,
    /** Light ink on dark paper. */
    DARK
}
