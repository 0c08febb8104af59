package robosim.geometry;

import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.engine.sensing.BeamResults;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;

/**
 * Takes the answers of {@link Geometry#sense} and {@link Snapshot#sense}: a distance for each beam and, where they are
 * wanted, the object that echoes and the surface normal. Its arrays are used again by the next call and grow only for a
 * larger pattern, so a sensor that keeps its buffer allocates nothing.
 *
 * <p>Before the first call it is empty; after one that threw an exception it is empty or as it was. A buffer is used by
 * one call at a time.
 */
public final class SenseBuffer {
    /** What a buffer may take beside distances. */
    public enum Extra {
        /** The object that echoes: see {@link SenseBuffer#object}. */
        OBJECTS,
        /** The unit normal of the surface, for rays only. */
        NORMALS,
        /** Which part of the object, and which triangle or cell of it, for rays only: see {@link SenseBuffer#part}. */
        PARTS
    }

    private final BeamResults echoes;

    /** A buffer for distances and nothing else. */
    public SenseBuffer() {
        this(new Extra[0]);
    }

    /** A buffer for distances and more. */
    public SenseBuffer(Extra... extras) {
        boolean hasObjects = false;
        boolean hasNormals = false;
        boolean hasParts = false;
        for (Extra extra : Checks.present("extras", extras)) {
            hasObjects |= Checks.present("extra", extra) == Extra.OBJECTS;
            hasNormals |= extra == Extra.NORMALS;
            hasParts |= extra == Extra.PARTS;
        }
        echoes = new BeamResults(hasObjects, hasNormals, hasParts);
    }

    BeamResults echoes() {
        return echoes;
    }

    /** The number of beams of the last call. */
    public int size() {
        return echoes.size();
    }

    /** The distance that a beam measured, as {@link Geometry#getRayDistance} returns it. */
    public double distance(int beam) {
        return echoes.distances()[checked(beam)];
    }

    /**
     * The object whose echo a beam heard, as it was added to the world; null if nothing echoes. Each call gives the same
     * instance for the same object. Where a moveable object is now, {@link Geometry#getObject} tells by its name.
     */
    public @Nullable GeometryObject object(int beam) {
        checkHas(Extra.OBJECTS, echoes.hasObjects());
        return echoes.objects()[checked(beam)];
    }

    /**
     * Which part of an object a ray met: 0 for an object that is no group. The parts of a group are its members that are no
     * groups themselves, depth first, from 0 on: see {@link robosim.geometry.model.ObjectGroup#parts}. Of parts that are
     * met at the same distance, the first counts.
     *
     * @return -1 if nothing echoes, or where the world's accuracy has one enclosure for the whole group
     */
    public int part(int beam) {
        checkHas(Extra.PARTS, echoes.hasParts());
        return echoes.parts()[checked(beam)];
    }

    /**
     * Which triangle of a mesh a ray met, by its place in the mesh (a face of four corners counts as two), or which cell of a grid, {@code j * columns + i}; of those
     * at the same distance the first.
     *
     * @return -1 if nothing echoes, if the part is neither, or if the ray starts inside a solid mesh
     */
    public int face(int beam) {
        checkHas(Extra.PARTS, echoes.hasParts());
        return echoes.faces()[checked(beam)];
    }

    /** The X component of the unit normal of the surface that a ray met, as {@link Geometry#castRay} returns it; 0 if none. */
    public double normalX(int beam) {
        return normal(beam, 0);
    }

    /** Its Y component. */
    public double normalY(int beam) {
        return normal(beam, 1);
    }

    /** Its Z component. */
    public double normalZ(int beam) {
        return normal(beam, 2);
    }

    private double normal(int beam, int axis) {
        checkHas(Extra.NORMALS, echoes.hasNormals());
        return echoes.normals()[3 * checked(beam) + axis];
    }

    /**
     * In which dimension the beams were measured: in a PLANAR world {@code PLANAR} for sonars and level lasers, whose
     * distances are those in the plane, and {@code SPATIAL} for a sensor that looks up or down.
     */
    public Dimension dimension() {
        return echoes.dimension();
    }

    /**
     * Where the sensor was in the world when it sensed: X, Y and Z, then the nine numbers of its rotation, row by row,
     * whose columns are its own axes. The buffer's own array, as with {@link #distances}.
     */
    public double[] place() {
        return echoes.place();
    }

    /**
     * All distances: the buffer's own array, no copy. Elements from {@link #size} on mean nothing. A later call writes
     * to the same array unless its pattern is larger.
     */
    public double[] distances() {
        return echoes.distances();
    }

    /** All normals, X, Y and Z of each beam: the buffer's own array, as with {@link #distances}. */
    public double[] normals() {
        checkHas(Extra.NORMALS, echoes.hasNormals());
        return echoes.normals();
    }

    private int checked(int beam) {
        if (beam < 0 || beam >= size()) {
            String need = size() == 0
                    ? "one that was answered, and none was: sense first"
                    : "from 0 to size - 1, " + (size() - 1);
            throw new IllegalArgumentException("beam must be " + need + " (got: " + beam + ")");
        }
        return beam;
    }

    private static void checkHas(Extra extra, boolean has) {
        if (!has) {
            throw new IllegalArgumentException("the buffer must have been made for " + extra
                    + ", as by new SenseBuffer(Extra." + extra + ") (got: none)");
        }
    }
}
