package robosim.geometry.protocol;

import java.io.Serial;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;

/**
 * A new world, which replaces the previous one. It gets no answer, but as {@link Answered}.
 *
 * @param objects  its objects, in the order of addition
 * @param settings its size, dimension and accuracy, each of which may be left out; null for the session's own, with a size
 *                 that holds all objects
 */
public record InitBundle(
        List<GeometryObject> objects, @Nullable WorldSettings settings) implements Bundle {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses a list or an object that is null. */
    public InitBundle {
        objects = Checks.copy("objects", objects, GeometryObject.class);
    }

    /** A world with the session's default settings. */
    public InitBundle(List<GeometryObject> objects) {
        this(objects, null);
    }

    /**
     * A new world whose sender is told what became of it: by a {@link BatchAnswerBundle} with one {@link
     * WorldAnswer.Described}. It is short for an InitBundle and then {@link #QUESTION}, which is what a {@link MessageReader}
     * makes of it.
     *
     * @param init the new world
     */
    public record Answered(InitBundle init) implements Bundle {
        @Serial
        private static final long serialVersionUID = 1;

        /** Asks what became of the last init. */
        public static final BatchRequestBundle QUESTION = new BatchRequestBundle(List.of(new WorldRequest.Describe()));

        /** Refuses null. */
        public Answered {
            Checks.present("init", init);
        }
    }
}
