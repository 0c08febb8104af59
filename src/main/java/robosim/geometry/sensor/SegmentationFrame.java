package robosim.geometry.sensor;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.sensor.effects.Surfaces;

/**
 * An image of a {@link SegmentationCamera}. Objects are numbered from 1 in the order in which the readings of this frame
 * meet them, ray by ray, and keep their numbers from one reading to the next.
 */
public final class SegmentationFrame extends RayFrame {
    private final IdentityHashMap<GeometryObject, Integer> numbers = new IdentityHashMap<>();
    private final List<GeometryObject> objects = new ArrayList<>();
    private final Surfaces surfaces = new Surfaces();
    private int[] instances = new int[0];
    private int[] labels = new int[0];

    /** An empty frame. */
    public SegmentationFrame() {}

    @SuppressWarnings("ReferenceEquality") // each object of a world is one instance
    void finish() {
        int count = rays().size();
        if (instances.length < count) {
            instances = new int[count];
        }
        if (labels.length < count) {
            labels = new int[count];
        }
        GeometryObject last = null;
        int lastPart = -1;
        int lastNumber = 0;
        int lastLabel = 0;
        for (int k = 0; k < count; k++) {
            GeometryObject object = buffer().object(k);
            int part = buffer().part(k);
            if (object != last || part != lastPart) { // most neighbours see the same
                last = object;
                lastPart = part;
                lastNumber = object == null ? 0 : numberOf(object);
                lastLabel = object == null ? 0 : surfaces.of(object, part).label();
            }
            instances[k] = lastNumber;
            labels[k] = lastLabel;
        }
    }

    private int numberOf(GeometryObject object) {
        Integer number = numbers.get(object);
        if (number == null) {
            objects.add(object);
            number = objects.size();
            numbers.put(object, number);
        }
        return number;
    }

    /** The object that a ray met; null for none. See {@link robosim.geometry.SenseBuffer#object}. */
    public @Nullable GeometryObject object(int ray) {
        return metBy(ray);
    }

    /** Which part of a group a ray met. See {@link robosim.geometry.SenseBuffer#part}. */
    public int part(int ray) {
        return buffer().part(checked(ray));
    }

    /**
     * The {@linkplain robosim.geometry.material.Material#label label} of the surface that a ray met, that of the member of a
     * group where it has one; 0 for none.
     */
    public int label(int ray) {
        return labels[checked(ray)];
    }

    /** All labels: the frame's own array, no copy. Elements from {@link #size} on mean nothing. */
    public int[] labels() {
        return labels;
    }

    /** The number of the object that a ray met; 0 for none. */
    public int instance(int ray) {
        return instances[checked(ray)];
    }

    /** All numbers: the frame's own array, no copy. Elements from {@link #size} on mean nothing. */
    public int[] instances() {
        return instances;
    }

    /** How many objects have numbers. */
    public int known() {
        return objects.size();
    }

    /** The object with a number, from 1 to {@link #known}. */
    public GeometryObject known(int number) {
        if (number < 1 || number > objects.size()) {
            throw new IllegalArgumentException(
                    "number must be from 1 to " + objects.size() + ", the objects seen so far (got: " + number + ")");
        }
        return Checks.present("object", objects.get(number - 1));
    }

    /** Forgets the numbers of objects, as for another world. */
    public void forget() {
        numbers.clear();
        objects.clear();
        surfaces.forget();
    }

    @Override
    double field(PointCloud.Field field, int ray) {
        if (field == PointCloud.Field.LABEL) {
            return label(ray);
        }
        return field == PointCloud.Field.INSTANCE ? instance(ray) : super.field(field, ray);
    }

    /**
     * Writes the labels as PNG, greys of 16 bits, 0 where there is none.
     *
     * @throws IOException if it cannot be written, naming the file
     * @throws IllegalArgumentException if a label is above 65,535, or nothing has been read into this frame
     */
    public void writeLabels(Path file) throws IOException {
        SensorFiles.writeGreys("labels", labels(), this, file);
    }

    /**
     * Writes the numbers of the objects as PNG, greys of 16 bits, 0 where there is none.
     *
     * @throws IOException if it cannot be written, naming the file
     * @throws IllegalArgumentException if a number is above 65,535, or nothing has been read into this frame
     */
    public void writeInstances(Path file) throws IOException {
        SensorFiles.writeGreys("instances", instances(), this, file);
    }
}
