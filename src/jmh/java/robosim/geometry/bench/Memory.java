package robosim.geometry.bench;

import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/**
 * How many bytes an object of a static planar world takes beyond itself, and in which arrays: what can be reached from the
 * world once it has been asked, without the objects. Arrays are counted by their numbers; a reference takes four bytes.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.bench.Memory
 * -Dexec.args=1000000}
 */
public final class Memory {
    private static final Map<Class<?>, Integer> BYTES = Map.of(
            boolean.class,
            1,
            byte.class,
            1,
            char.class,
            2,
            short.class,
            2,
            int.class,
            4,
            float.class,
            4,
            long.class,
            8,
            double.class,
            8);
    private static final int REFERENCE = 4;

    private final Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    private final Map<String, Long> parts = new TreeMap<>();

    private Memory() {}

    /** Prints the parts and the sum for as many objects as are asked for, a million if no number is given. */
    public static void main(String[] args) throws IllegalAccessException {
        int count = args.length > 0 && args[0].matches("\\d+") ? Integer.parseInt(args[0]) : 1_000_000;
        Scene scene = new Scene(count, 2);
        List<GeometryObject> things = scene.objects(count);
        double world = scene.side() + 20;
        Geometry geometry = new Geometry(world, 10, world, Dimension.PLANAR, Accuracy.EXACT);
        things.forEach(geometry::addObjectUnchecked);
        geometry.getRayDistance(new Ray(new Point(), new Point(1, 0, 0)), 0, 1, 0);
        Map<String, Long> parts = parts(geometry);
        for (Map.Entry<String, Long> part : parts.entrySet()) {
            if (part.getValue() >= count) {
                Timing.print("%s %.1f", part.getKey(), part.getValue() / (double) count);
            }
        }
        Timing.print("bytes an object beyond the objects: %.1f", sum(parts) / (double) count);
    }

    /** The bytes of the arrays that can be reached from a root, but through an object that a user holds, by field. */
    static Map<String, Long> parts(Object root) throws IllegalAccessException {
        Memory memory = new Memory();
        memory.count(root);
        return memory.parts;
    }

    static long sum(Map<String, Long> parts) {
        return parts.values().stream().mapToLong(Long::longValue).sum();
    }

    private void count(Object world) throws IllegalAccessException {
        Deque<Object> left = new ArrayDeque<>();
        left.add(world);
        seen.add(world);
        while (!left.isEmpty()) {
            Object next = left.remove();
            for (Class<?> type = next.getClass(); type != null; type = type.getSuperclass()) {
                for (Field field : type.getDeclaredFields()) {
                    if (!Modifier.isStatic(field.getModifiers())
                            && !field.getType().isPrimitive()) {
                        field.setAccessible(true);
                        take(type.getSimpleName() + "." + field.getName(), field.get(next), left);
                    }
                }
            }
        }
    }

    private void take(String name, Object value, Deque<Object> left) {
        if (value == null || value instanceof GeometryObject || value instanceof Enum || !seen.add(value)) {
            return;
        }
        Class<?> part = value.getClass().getComponentType();
        if (part == null) {
            if (value.getClass().getName().startsWith("robosim.geometry.")) {
                left.add(value);
            }
            return;
        }
        int length = Array.getLength(value);
        parts.merge(name, 16 + (long) length * BYTES.getOrDefault(part, REFERENCE), Long::sum);
        for (int k = 0; k < length && !part.isPrimitive(); k++) {
            take(name + "[]", Array.get(value, k), left);
        }
    }
}
