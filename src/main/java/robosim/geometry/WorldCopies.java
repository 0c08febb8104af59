package robosim.geometry;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.engine.World;
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

    private final Supplier<World> copies;

    /** Copies that nobody uses now. */
    private World[] idle = new World[2];

    private int idleCount;

    WorldCopies(Supplier<World> copies) {
        this.copies = copies;
    }

    /** Takes a copy that nobody else uses until it is given back. */
    World borrow() {
        synchronized (this) {
            if (idleCount > 0) {
                return idle[--idleCount];
            }
        }
        return copies.get();
    }

    /** Gives a copy back, which has not been changed. */
    synchronized void giveBack(World world) {
        if (idleCount == idle.length) {
            idle = Arrays.copyOf(idle, 2 * idleCount);
        }
        idle[idleCount++] = world;
    }

    private static void mount(World world, @Nullable String name, Pose pose) {
        if (name == null) {
            world.sensor.frame().at(pose);
        } else {
            world.sensor.frame().mounted(world.registry.mover(name), pose);
        }
    }

    /** Answers all beams of a sensor, on an object or, where none is named, in the world. */
    void sense(@Nullable String name, Pose pose, RayPattern pattern, SenseOptions options, SenseBuffer out) {
        World world = borrow();
        try {
            mount(world, name, pose);
            Checks.present("pattern", pattern);
            Checks.present("options", options);
            BeamResults echoes = Checks.present("out", out).echoes();
            PatternSensor sensor = world.sensor;
            sensor.prepare(pattern, options, echoes);
            int tiles = sensor.tiles(pattern, options);
            int parts = parts(tiles, TILES);
            if (Math.min(parts, options.threads()) == 1) {
                sensor.sense(pattern, options, echoes, 0, tiles);
            } else {
                new CopiedWork(parts) {
                    @Override
                    World begin() {
                        World copy = super.begin();
                        mount(copy, name, pose);
                        return copy;
                    }

                    @Override
                    void part(World copy, int part) {
                        int from = part * TILES;
                        copy.sensor.sense(pattern, options, echoes, from, Math.min(from + TILES, tiles));
                    }
                }.run(world, options.threads());
            }
            PatternSensor.finish(pattern, echoes);
        } finally {
            giveBack(world);
        }
    }

    /** Answers questions about places. */
    int answer(PlaceBatch batch, int threads) {
        World world = borrow();
        try {
            int parts = parts(batch.count(), BITS);
            if (Math.min(parts, threads) <= 1) {
                return batch.answer(world);
            }
            batch.answer(world, 0, 0); // refuses names that have no answers
            AtomicInteger found = new AtomicInteger();
            new CopiedWork(parts) {
                @Override
                void part(World copy, int part) {
                    int from = part * BITS;
                    found.addAndGet(batch.answer(copy, from, Math.min(from + BITS, batch.count())));
                }
            }.run(world, threads);
            return found.get();
        } finally {
            giveBack(world);
        }
    }

    /** Work with copies of the world. */
    private abstract class CopiedWork extends ParallelParts<World> {
        CopiedWork(int parts) {
            super(parts);
        }

        @Override
        World begin() {
            return borrow();
        }

        @Override
        void end(World copy) {
            giveBack(copy);
        }
    }

    private static int parts(int count, int each) {
        return count / each + (count % each > 0 ? 1 : 0);
    }
}
