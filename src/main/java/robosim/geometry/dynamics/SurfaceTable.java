package robosim.geometry.dynamics;

import java.util.HashMap;
import java.util.Map;
import robosim.geometry.dynamics.step.Surfaces;

/** The surfaces of objects by their ids, and one for all others. */
final class SurfaceTable implements Surfaces {
    private final Map<Integer, Surface> own = new HashMap<>();
    private final Surface ground;

    SurfaceTable(Surface ground) {
        this.ground = ground;
    }

    void clear() {
        own.clear();
    }

    void put(int id, Surface surface) {
        own.put(id, surface);
    }

    private Surface of(int object) {
        return own.getOrDefault(object, ground);
    }

    @Override
    public double restitution(int object) {
        return of(object).restitution();
    }

    @Override
    public double staticFriction(int object) {
        return of(object).staticFriction();
    }

    @Override
    public double slidingFriction(int object) {
        return of(object).slidingFriction();
    }
}
