package robosim.geometry.world.xml;

import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.FileProblem;

/** A mistake against the grammar of XML itself, which other parsers may not mind. */
final class NotWellFormed extends FileProblem {
    private static final long serialVersionUID = 1;

    NotWellFormed(String source, int line, int column, String problem, @Nullable Throwable cause) {
        super(source, line, column, problem, cause);
    }
}
