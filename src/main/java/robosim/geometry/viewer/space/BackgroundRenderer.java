package robosim.geometry.viewer.space;

import java.io.Serial;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.check.Checks;
import robosim.geometry.material.Color;
import robosim.geometry.model.SenseOptions.Carrier;
import robosim.geometry.render.ColorCamera;
import robosim.geometry.render.ColorFrame;
import robosim.geometry.render.Lighting;
import robosim.geometry.render.Sky;

/**
 * Takes the pictures of a viewer's cameras, elsewhere than on the thread that asks for them: each at first as coarse as
 * needed to be there at once, then finer and finer. A newer order cancels all but the first step of an older one, so that
 * something is always seen while a hand moves a camera.
 */
public final class BackgroundRenderer {
    /** Cameras that are kept with the directions of their rays. */
    private static final int KEPT = 8;

    /** A clear day with a bright ground, on which a world stands as on paper. */
    public static final Lighting LIGHT =
            Lighting.DAY.withSky(new Sky(Color.parse("#c3d3e6"), Color.parse("#f3f5f7"), Color.parse("#d8d6d0"), 0.6));

    /** A dim one, with the same sun. */
    public static final Lighting DARK =
            Lighting.DAY.withSky(new Sky(Color.parse("#8fa3bd"), Color.parse("#2a303a"), Color.parse("#14171c"), 0.7));

    private final Executor worker;
    private final Runnable shown;
    private final int threads;
    private final Refinement refinement = new Refinement();
    private final Stage stage = new Stage();
    private final ColorFrame frame = new ColorFrame();
    private final Map<Size, ColorCamera> cameras = new LinkedHashMap<>(16, 0.75f, true);

    // What follows is guarded by this.
    private final List<Slot> slots = new ArrayList<>();
    private @Nullable Moment moment;
    private Lighting lighting = LIGHT;
    private boolean isAtWork;
    private String problem = "";

    /** One of the cameras, and how far its picture is. */
    private static final class Slot {
        Shot shot;

        /** Counts orders; read by the worker without a lock, to see whether it should stop. */
        volatile long order;

        Refinement.@Nullable Step done;

        @Nullable
        Picture picture;

        boolean isTraced;

        Slot(Shot shot) {
            this.shot = shot;
        }
    }

    private record Size(int width, int height, int samples, double fieldOfView) {}

    /** What is to be done next: a step of a picture, or, without a step, what is drawn over the last one. */
    private record Job(
            Slot slot, long order, Shot shot, Moment moment, Lighting lighting, Refinement.@Nullable Step step) {}

    /** Ends a step that nobody waits for any more. */
    private static final class Superseded extends RuntimeException {
        @Serial
        private static final long serialVersionUID = 1;

        private Superseded() {
            super("a newer picture is wanted", null, false, false);
        }
    }

    /**
     * A studio.
     *
     * @param worker  does the work; it must not do two things at once
     * @param shown   is called on its thread after each step
     * @param threads on which a picture is rendered, 1 to 1024
     */
    public BackgroundRenderer(Executor worker, Runnable shown, int threads) {
        this.worker = Checks.present("worker", worker);
        this.shown = Checks.present("shown", shown);
        this.threads = Checks.threads(threads);
    }

    /** Orders pictures: those that are the same as before go on being refined. Returns at once. */
    public void order(Moment now, List<Shot> shots, Lighting light) {
        synchronized (this) {
            Moment before = moment;
            boolean isOther = before == null || !before.looksLike(now) || !lighting.equals(light);
            boolean isTraced = before != null && before.life().equals(now.life());
            moment = now;
            lighting = light;
            while (slots.size() > shots.size()) {
                slots.remove(slots.size() - 1).order++;
            }
            for (int k = 0; k < shots.size(); k++) {
                if (k == slots.size()) {
                    slots.add(new Slot(shots.get(k)));
                }
                Slot slot = slots.get(k);
                if (isOther || !slot.shot.equals(shots.get(k))) {
                    slot.shot = shots.get(k);
                    slot.order++;
                    slot.done = null;
                    slot.isTraced = false;
                }
                slot.isTraced &= isTraced;
            }
            if (isAtWork || next() == null) {
                return;
            }
            isAtWork = true;
        }
        worker.execute(this::work);
    }

    /** The newest picture of a camera; null before the first. */
    public synchronized @Nullable Picture picture(int camera) {
        return camera < slots.size() ? slots.get(camera).picture : null;
    }

    /** Why a picture could not be taken; empty if all could. */
    public synchronized String problem() {
        return problem;
    }

    private void work() {
        for (Job job = begin(); job != null; job = begin()) {
            try {
                take(job);
            } catch (Superseded newer) {
                continue;
            } catch (RuntimeException | OutOfMemoryError e) {
                fail(job, e);
            }
            shown.run();
        }
    }

    private synchronized @Nullable Job begin() {
        Job job = next();
        isAtWork = job != null;
        return job;
    }

    /** First something of each picture, then what is drawn over it, then the coarsest of them. */
    private @Nullable Job next() {
        Moment now = moment;
        if (now == null) {
            return null;
        }
        Job best = null;
        for (Slot slot : slots) {
            Refinement.Step done = slot.done;
            if (done == null) {
                Refinement.Step first = refinement.first(
                        slot.shot.view().width(), slot.shot.view().height());
                return new Job(slot, slot.order, slot.shot, now, lighting, first);
            }
            if (!slot.isTraced && slot.picture != null) {
                return new Job(slot, slot.order, slot.shot, now, lighting, null);
            }
            Refinement.Step step = Refinement.after(done);
            if (!step.equals(done) && (best == null || best.step == null || step.side() > best.step.side())) {
                best = new Job(slot, slot.order, slot.shot, now, lighting, step);
            }
        }
        return best;
    }

    @SuppressWarnings("ReferenceEquality") // an equal moment takes longer to find than to trace again
    private void take(Job job) {
        SpaceView view = job.shot.at(job.moment);
        if (view == null) {
            finish(job, null);
            return;
        }
        if (job.step == null) {
            trace(job);
            return;
        }
        Refinement.Step step = job.step;
        Snapshot world = stage.at(job.moment);
        boolean isFirst = job.slot.done == null;
        long begin = System.nanoTime();
        camera(job.shot, step).withLighting(job.lighting).withThreads(threads).render(world, frame, percent -> {
            if (!isFirst && job.slot.order != job.order) {
                throw new Superseded();
            }
        });
        refinement.learn(step.rays(view.width(), view.height()), System.nanoTime() - begin);
        Picture last = picture(job.slot);
        boolean isSame = last != null && last.view().equals(view) && last.moment() == job.moment;
        List<Trace> traces = isSame && last != null ? last.traces() : Traces.of(job.moment);
        finish(job, new Picture(frame.pixels().clone(), step, view, job.moment, world, traces));
    }

    private synchronized @Nullable Picture picture(Slot slot) {
        return slot.picture;
    }

    /** The squares of a step may reach beyond the view, so its camera sees a little more. */
    private ColorCamera camera(Shot shot, Refinement.Step step) {
        SpaceView view = shot.view();
        int columns = step.squares(view.width());
        int rows = step.squares(view.height());
        double tangent = view.tangent() * columns * step.side() / view.width();
        double field = columns * step.side() == view.width()
                ? view.fieldOfView()
                : 2 * StrictMath.toDegrees(StrictMath.atan(tangent));
        Size size = new Size(columns, rows, step.samples(), field);
        ColorCamera camera = cameras.get(size);
        if (camera == null) {
            camera = ColorCamera.of(columns, rows, field).withSamples(step.samples());
            if (step.samples() == 1) {
                cameras.put(size, camera);
            }
            if (cameras.size() > KEPT) {
                cameras.remove(cameras.keySet().iterator().next());
            }
        }
        String carrier = shot.carrier();
        return carrier == null
                ? camera.at(view.pose())
                : camera.on(carrier, view.pose()).withCarrier(Carrier.IGNORED);
    }

    /** Finds of what is drawn over a picture which points are hidden. */
    @SuppressWarnings("ReferenceEquality") // whether this is the last order, not one that is equal
    private void trace(Job job) {
        Picture last = picture(job.slot);
        if (last == null) {
            return;
        }
        Geometry world = last.world().toGeometry();
        List<Trace> traces =
                Traces.hidden(Traces.of(job.moment), last.view().pose().center(), job.shot.carrier(), world);
        synchronized (this) {
            Picture present = job.slot.picture;
            if (job.slot.order == job.order && present != null) {
                job.slot.picture = present.with(traces);
                job.slot.isTraced = job.moment == moment;
            }
        }
    }

    private synchronized void finish(Job job, @Nullable Picture picture) {
        job.slot.picture = picture;
        problem = "";
        if (job.slot.order == job.order) {
            job.slot.done = picture == null ? new Refinement.Step(1, Refinement.FINEST) : job.step;
        }
    }

    private synchronized void fail(Job job, Throwable why) {
        problem =
                why instanceof OutOfMemoryError ? "not enough memory for a picture" : String.valueOf(why.getMessage());
        if (job.slot.order == job.order) {
            job.slot.done = new Refinement.Step(1, Refinement.FINEST); // nothing finer is tried
            job.slot.isTraced = true;
        }
    }
}
