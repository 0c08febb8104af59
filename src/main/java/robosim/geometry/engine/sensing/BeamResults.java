package robosim.geometry.engine.sensing;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;

/**
 * What the beams of a pattern hear, in flat arrays that grow only for a larger pattern: distances always, objects,
 * normals and parts where they are wanted. Threads may write different beams at once.
 */
public final class BeamResults {
    /** Numbers in the place of a sensor. */
    public static final int PLACE = 12;

    private final boolean hasObjects;
    private final boolean hasNormals;
    private final boolean hasParts;
    private double[] distances = new double[0];
    private @Nullable GeometryObject[] objects = new GeometryObject[0];
    private double[] normals = new double[0];
    private int[] parts = new int[0];
    private int[] faces = new int[0];
    private int size;
    private Dimension dimension = Dimension.SPATIAL;

    /** Where the sensor was: X, Y and Z, then its rotation, row by row. */
    private final double[] place = new double[PLACE];

    public BeamResults(boolean hasObjects, boolean hasNormals, boolean hasParts) {
        this.hasObjects = hasObjects;
        this.hasNormals = hasNormals;
        this.hasParts = hasParts;
    }

    /** Forgets what was heard and makes room for what is measured in a dimension. */
    void clear(int beams, Dimension seen) {
        dimension = seen;
        if (beams > distances.length) {
            distances = new double[beams];
            objects = hasObjects ? new GeometryObject[beams] : objects;
            normals = hasNormals ? new double[3 * beams] : normals;
            parts = hasParts ? new int[beams] : parts;
            faces = hasParts ? new int[beams] : faces;
        } else if (hasObjects && beams < size) {
            Arrays.fill(objects, beams, size, null); // else they could not be collected
        }
        size = 0;
    }

    /** Says that so many beams have been heard. */
    void filled(int beams) {
        size = beams;
    }

    /** How many beams have been heard. */
    public int size() {
        return size;
    }

    /** Where distances are measured: PLANAR in the plane. */
    public Dimension dimension() {
        return dimension;
    }

    public boolean hasObjects() {
        return hasObjects;
    }

    public boolean hasNormals() {
        return hasNormals;
    }

    public boolean hasParts() {
        return hasParts;
    }

    /** One for each beam. */
    public double[] distances() {
        return distances;
    }

    /** One for each beam, as it was added to its world; null where nothing echoes. Empty where they are not wanted. */
    public @Nullable GeometryObject[] objects() {
        return objects;
    }

    /** Three numbers for each beam, zeros where nothing echoes. Empty where they are not wanted. */
    public double[] normals() {
        return normals;
    }

    /** Where the sensor was in the world: X, Y and Z, then the nine numbers of its rotation, row by row. */
    public double[] place() {
        return place;
    }

    /** One for each beam; -1 where nothing echoes. Empty where they are not wanted. */
    public int[] parts() {
        return parts;
    }

    /** One for each beam; -1 where there is none. Empty where they are not wanted. */
    public int[] faces() {
        return faces;
    }

    /** Whether anything is wanted but distances. */
    boolean hasMore() {
        return hasObjects || hasNormals || hasParts;
    }

    /**
     * Notes whose echo a beam hears.
     *
     * @param id an object, or -1
     * @param normal three numbers, of what it met
     */
    void object(int beam, ObjectTable table, int id, double[] normal) {
        if (hasObjects) {
            objects[beam] = id < 0 ? null : table.value(id);
        }
        if (hasNormals) {
            for (int axis = 0; axis < 3; axis++) {
                normals[3 * beam + axis] = id < 0 ? 0 : normal[axis];
            }
        }
    }

    /** Notes which part and which triangle or cell a beam met. */
    void part(int beam, int part, int face) {
        parts[beam] = part;
        faces[beam] = face;
    }
}
