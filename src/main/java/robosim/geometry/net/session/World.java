package robosim.geometry.net.session;

import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.protocol.WorldSettings;

/** What a session asks of a world; angles in degrees. */
public interface World {
    /** False where the object would leave the world. */
    boolean add(GeometryObject object);

    MoveResult move(String name, Move move);

    double sonar(String name, double x, double z, double min, double max, double width);

    /** What it is made of; null where it is none of the module's own. */
    default @Nullable Geometry geometry() {
        return null;
    }

    /** Makes worlds. */
    @FunctionalInterface
    interface Maker {
        World make(WorldSettings settings);
    }

    /** The module's own. */
    static World of(WorldSettings settings) {
        return over(new Geometry(
                settings.width(), settings.height(), settings.length(), settings.dimension(), settings.accuracy()));
    }

    /** One that is there already. */
    static World over(Geometry geometry) {
        return new World() {
            @Override
            public boolean add(GeometryObject object) {
                return geometry.addObjectUnchecked(object);
            }

            @Override
            public MoveResult move(String name, Move move) {
                return geometry.move(name, move);
            }

            @Override
            public double sonar(String name, double x, double z, double min, double max, double width) {
                return geometry.getSonarDistance(name, x, z, min, max, width);
            }

            @Override
            public Geometry geometry() {
                return geometry;
            }
        };
    }
}
