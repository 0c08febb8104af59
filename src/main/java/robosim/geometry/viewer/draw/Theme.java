package robosim.geometry.viewer.draw;

/** The theme of an image. An SVG contains both and follows its viewer's. */
public enum Theme {
    /** Dark on a light background. */
    LIGHT,
    /** Light on a dark background. */
    DARK
}
