package robosim.geometry;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import java.util.function.ToIntFunction;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.engine.World;
import robosim.geometry.engine.motion.FreePlaces;
import robosim.geometry.engine.sensing.BeamResults;
import robosim.geometry.engine.sensing.PatternSensor;
import robosim.geometry.model.Pose;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;

/**
 * Answers many questions about a snapshot, on one thread or several: keeps working copies of its world, of which each
 * thread takes one.
 */
final class WorldCopies {
    /** Tiles of beams that a thread takes at once. */
    private static final int TILES = 4;

    /** Poses or edges that a thread takes at once: whole elements of the array of bits. */
    private static final int BITS = 4 * Long.SIZE;

    private final Supplier<Geometry> copies;

    /** Copies that nobody uses now. */
    private Geometry[] idle = new Geometry[2];

    private int idleCount;

    WorldCopies(Supplier<Geometry> copies) {
        this.copies = copies;
    }

    /** Poses or edges. */
    enum Places {
        POSES("poses", FreePlaces.POSE),
        EDGES("edges", FreePlaces.EDGE);

        private final String argument;
        private final int stride;

        Places(String argument, int stride) {
            this.argument = argument;
            this.stride = stride;
        }

        private int some(Geometry world, String name, double[] numbers, int from, int to, long[] free) {
            World of = world.engine();
            int id = of.registry.mover(name);
            return this == POSES
                    ? of.places().poses(of.view, id, numbers, from, to, free)
                    : of.places().edges(of.view, id, numbers, from, to, free);
        }
    }

    private Geometry borrow() {
        synchronized (this) {
            if (idleCount > 0) {
                return idle[--idleCount];
            }
        }
        return copies.get();
    }

    /** Gives a copy back, which has not been changed. */
    private synchronized void giveBack(Geometry world) {
        if (idleCount == idle.length) {
            idle = Arrays.copyOf(idle, 2 * idleCount);
        }
        idle[idleCount++] = world;
    }

    private static void mount(Geometry world, @Nullable String name, Pose pose) {
        World of = world.engine();
        if (name == null) {
            of.sensor.frame().at(pose);
        } else {
            of.sensor.frame().mounted(of.registry.mover(name), pose);
        }
    }

    /** Answers all beams of a sensor, on an object or, where none is named, in the world. */
    void sense(@Nullable String name, Pose pose, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        Geometry world = borrow();
        try {
            mount(world, name, pose);
            Checks.present("pattern", pattern);
            Checks.present("options", options);
            BeamResults echoes = Checks.present("out", out).echoes();
            PatternSensor sensor = world.engine().sensor;
            sensor.prepare(pattern, options, echoes);
            int tiles = sensor.tiles(pattern, options);
            int parts = parts(tiles, TILES);
            if (Math.min(parts, options.threads()) == 1) {
                sensor.sense(pattern, options, echoes, 0, tiles);
            } else {
                new CopiedWork(parts) {
                    @Override
                    Geometry begin() {
                        Geometry copy = super.begin();
                        mount(copy, name, pose);
                        return copy;
                    }

                    @Override
                    void part(Geometry copy, int part) {
                        int from = part * TILES;
                        copy.engine().sensor.sense(pattern, options, echoes, from, Math.min(from + TILES, tiles));
                    }
                }.run(world, options.threads());
            }
            PatternSensor.finish(pattern, echoes);
        } finally {
            giveBack(world);
        }
    }

    /** Answers rays that begin anywhere. */
    void castRays(double[] rays, int count, SenseBuffer out) {
        Geometry world = borrow();
        try {
            world.castRays(rays, count, out);
        } finally {
            giveBack(world);
        }
    }

    /** Answers which rays are free. */
    int freeRays(ToIntFunction<Geometry> question) {
        Geometry world = borrow();
        try {
            return question.applyAsInt(world);
        } finally {
            giveBack(world);
        }
    }

    /** Answers poses or edges. */
    int free(Places places, String name, double[] numbers, int threads, long[] free) {
        Checks.present("name", name);
        Geometry world = borrow();
        try {
            int count = FreePlaces.check(places.argument, numbers, places.stride, free);
            int parts = parts(count, BITS);
            if (Math.min(parts, threads) <= 1) {
                return places.some(world, name, numbers, 0, count, free);
            }
            places.some(world, name, numbers, 0, 0, free); // refuses a name that has no answers
            new CopiedWork(parts) {
                @Override
                void part(Geometry copy, int part) {
                    int from = part * BITS;
                    places.some(copy, name, numbers, from, Math.min(from + BITS, count), free);
                }
            }.run(world, threads);
            return bits(free, FreePlaces.words(count));
        } finally {
            giveBack(world);
        }
    }

    /** Answers questions about places. */
    int answer(PlaceBatch batch, int threads) {
        Geometry world = borrow();
        try {
            int parts = parts(batch.count(), BITS);
            if (Math.min(parts, threads) <= 1) {
                return batch.answer(world.engine(), 0, batch.count());
            }
            batch.answer(world.engine(), 0, 0); // refuses names that have no answers
            AtomicInteger found = new AtomicInteger();
            new CopiedWork(parts) {
                @Override
                void part(Geometry copy, int part) {
                    int from = part * BITS;
                    found.addAndGet(batch.answer(copy.engine(), from, Math.min(from + BITS, batch.count())));
                }
            }.run(world, threads);
            return found.get();
        } finally {
            giveBack(world);
        }
    }

    /** Work with copies of the world. */
    private abstract class CopiedWork extends ParallelParts<Geometry> {
        CopiedWork(int parts) {
            super(parts);
        }

        @Override
        Geometry begin() {
            return borrow();
        }

        @Override
        void end(Geometry copy) {
            giveBack(copy);
        }
    }

    private static int parts(int count, int each) {
        return count / each + (count % each > 0 ? 1 : 0);
    }

    private static int bits(long[] words, int count) {
        int bits = 0;
        for (int k = 0; k < count; k++) {
            bits += Long.bitCount(words[k]);
        }
        return bits;
    }
}
