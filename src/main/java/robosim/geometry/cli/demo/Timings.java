package robosim.geometry.cli.demo;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.MoveResult;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.SessionListener;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.world.shared.ObjectNames;

/** How long the module's side of a conversation took, and what blocked moves. */
public final class Timings implements SessionListener {
    /** By the kind of request. */
    private final Map<Class<?>, Times> times = new HashMap<>();

    private final Map<String, Integer> refusedBy = new HashMap<>();

    @Override
    public synchronized void tried(MoveRequest request, MoveResult result) {
        if (!result.allowed()) {
            refusedBy.merge(text(result.obstacle()), 1, Integer::sum);
        }
    }

    private static String text(@Nullable GeometryObject obstacle) {
        if (obstacle == null) {
            return "the world's border";
        }
        return ObjectNames.of(obstacle);
    }

    @Override
    public synchronized void answered(Bundle request, @Nullable Bundle answer, long nanoseconds) {
        times.computeIfAbsent(request.getClass(), kind -> new Times()).add(nanoseconds);
    }

    /** The obstacles that blocked moves, each with how many moves it blocked. */
    synchronized Map<String, Integer> refusedBy() {
        return new HashMap<>(refusedBy);
    }

    /** The time within which a given share of all requests of a kind was answered, in microseconds. */
    synchronized double micros(Class<? extends Bundle> kind, double share) {
        Times all = times.get(kind);
        return all == null ? 0 : all.micros(share);
    }

    /** A growing list of durations in nanoseconds. */
    private static final class Times {
        private long[] nanos = new long[1024];
        private int size;

        void add(long value) {
            if (size == nanos.length) {
                nanos = Arrays.copyOf(nanos, 2 * size);
            }
            nanos[size++] = value;
        }

        double micros(double share) {
            if (size == 0) {
                return 0;
            }
            long[] sorted = Arrays.copyOf(nanos, size);
            Arrays.sort(sorted);
            return sorted[Math.max(0, (int) Math.ceil(share * size) - 1)] / 1000.0;
        }
    }
}
