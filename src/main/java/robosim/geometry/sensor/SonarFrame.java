package robosim.geometry.sensor;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;

/** A reading of a {@link SonarArray}. */
public final class SonarFrame extends RayFrame {
    /** An empty frame. */
    public SonarFrame() {}

    /** The object whose echo a sonar heard, noise aside; null for none. */
    public @Nullable GeometryObject object(int ray) {
        return metBy(ray);
    }
}
