package robosim.geometry.dynamics;

import java.util.HashMap;
import java.util.Map;
import robosim.geometry.dynamics.planar.ContactSurfaces;
import robosim.geometry.engine.objects.ObjectTable;

/** The surfaces of objects by their ids, and one for all others. */
final class SurfaceTable implements ContactSurfaces {
    /** By id, for a step. */
    private final Map<Integer, Surface> own = new HashMap<>();

    /** By name, those that were given to objects without a body. */
    private final Map<String, Given> given = new HashMap<>();

    /** What was given before a step that may be taken back. */
    private Map<String, Given> kept = Map.of();

    private final Surface ground;
    private Surface.Mixing restitutions = Surface.Mixing.GEOMETRIC_MEAN;
    private Surface.Mixing frictions = Surface.Mixing.GEOMETRIC_MEAN;
    private Surface.Mixing restitutionsKept = restitutions;
    private Surface.Mixing frictionsKept = frictions;

    /**
     * A surface of an object.
     *
     * @param arrival when the object came into the world: another one may get its name
     */
    private record Given(Surface surface, long arrival) {}

    SurfaceTable(Surface ground) {
        this.ground = ground;
    }

    /** Sets how the numbers of two surfaces make those of their contact. */
    void mix(Surface.Mixing ofRestitution, Surface.Mixing ofFriction) {
        restitutions = ofRestitution;
        frictions = ofFriction;
    }

    /** Gives an object in the world a surface. */
    void give(ObjectTable objects, String name, Surface surface) {
        given.put(name, new Given(surface, objects.arrival(objects.find(name))));
    }

    /** Keeps what was given and how it is mixed, so that it can be taken back to this. */
    void keep() {
        kept = Map.copyOf(given);
        restitutionsKept = restitutions;
        frictionsKept = frictions;
    }

    /** Takes back what was given and set since {@link #keep}. */
    void undo() {
        given.clear();
        given.putAll(kept);
        mix(restitutionsKept, frictionsKept);
    }

    /** Begins anew with the surfaces of the objects that are still there. */
    void begin(ObjectTable objects) {
        own.clear();
        given.entrySet().removeIf(each -> {
            int id = objects.find(each.getKey());
            if (id < 0 || objects.arrival(id) != each.getValue().arrival) {
                return true;
            }
            own.put(id, each.getValue().surface);
            return false;
        });
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
    public double mixRestitution(double a, double b) {
        return Math.min(1, restitutions.of(a, b));
    }

    @Override
    public double mixFriction(double a, double b) {
        return frictions.of(a, b);
    }

    @Override
    public double slidingFriction(int object) {
        return of(object).slidingFriction();
    }
}
