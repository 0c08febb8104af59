package robosim.geometry.net.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.WorkLimit;
import robosim.geometry.check.Text;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.CopyRequest;
import robosim.geometry.protocol.batch.Integers;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.TickAnswer;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;

/** Copies of a session's world, with their bodies, which go on side by side. */
public final class WorldCopies {
    /** Most moveable objects of all copies together; static objects are shared. */
    public static final int MOST_OBJECTS = 100_000;

    private final Batches batches;
    private final List<Copy> copies = new ArrayList<>();

    private record Copy(Geometry world, BodyStepper bodies, Set<String> moveable) {}

    /** No copies yet. */
    public WorldCopies(Batches batches) {
        this.batches = batches;
    }

    /**
     * Copies the world.
     *
     * @param bodies   its bodies; null for none
     * @param moveable the names of its moveable objects
     * @param limit    of the work in the copy, or null
     * @throws IllegalArgumentException if there would be a gap between the copies, or too many objects in them
     */
    public BatchAnswer make(
            CopyRequest.Make request,
            Geometry world,
            @Nullable BodyStepper bodies,
            Set<String> moveable,
            @Nullable WorkLimit limit,
            Runnable breath) {
        int index = request.index();
        if (index > copies.size()) {
            throw new IllegalArgumentException(
                    "index must be that of a copy, or of the next one, " + copies.size() + " (got: " + index + ")");
        }
        if ((long) moveable.size() * Math.max(copies.size(), index + 1) > MOST_OBJECTS) {
            throw new IllegalArgumentException("the copies of a world must have at most " + MOST_OBJECTS
                    + " moveable objects together (got: " + moveable.size() + " in each of " + (index + 1) + ")");
        }
        Geometry made = world.snapshot().toGeometry();
        if (limit != null) {
            made.limitWork(limit);
        }
        BodyStepper moving = new BodyStepper(made, breath);
        if (bodies != null) {
            moving.step(bodies.given(), (body, reason) -> {});
        }
        Copy copy = new Copy(made, moving, Set.copyOf(moveable));
        if (index < copies.size()) {
            copies.set(index, copy);
        } else {
            copies.add(copy);
        }
        return new WorldAnswer.Changed(true, null);
    }

    /**
     * Lets time pass in all copies. Names that cannot be are refused before any copy goes on; of a tick that is ended half-way no
     * copy remains.
     */
    public TickAnswer tick(CopyRequest.Tick tick, Runnable breath) {
        if (tick.copies() > copies.size()) {
            throw new IllegalArgumentException("commands must be for at most the " + copies.size()
                    + " copies that there are; make more by requests of kind copy (got: for " + tick.copies() + ")");
        }
        for (int k = 0; k < tick.copies(); k++) {
            check(tick, k);
        }
        boolean isMade = false;
        try {
            TickAnswer answer = measured(tick, breath);
            isMade = true;
            return answer;
        } finally {
            if (!isMade) {
                copies.clear();
            }
        }
    }

    private TickAnswer measured(CopyRequest.Tick tick, Runnable breath) {
        int bodies = tick.bodies().size();
        double[] states = new double[TickAnswer.STRIDE * bodies * tick.copies()];
        int[] touches = new int[bodies * tick.copies()];
        int beams = tick.size() - touches.length;
        double[] distances = new double[tick.single() ? 0 : beams];
        int[] singles = new int[tick.single() ? beams : 0];
        int filled = 0;
        for (int k = 0; k < tick.copies(); k++) {
            breath.run();
            Copy copy = copies.get(k);
            StepBundle.Answer answer = copy.bodies.step(step(tick, k), (index, reason) -> {
                throw new IllegalArgumentException(reason);
            });
            for (BodyAnswer body : answer.bodies()) {
                int place = tick.bodies().indexOf(body.objectName());
                if (place >= 0) {
                    write(body, states, TickAnswer.STRIDE * (bodies * k + place));
                }
            }
            for (ContactAnswer contact : answer.contacts()) {
                count(contact, tick.bodies(), touches, bodies * k);
            }
            for (SenseRequest sense : tick.senses()) {
                Numbers measured = ((SenseAnswer) batches.answer(copy.world, sense, breath)).distances();
                for (int beam = 0; beam < measured.size(); beam++, filled++) {
                    if (tick.single()) {
                        singles[filled] = Float.floatToIntBits((float) measured.get(beam));
                    } else {
                        distances[filled] = measured.get(beam);
                    }
                }
            }
        }
        return new TickAnswer(
                new Numbers(states), new Integers(touches), new Numbers(distances), new Integers(singles));
    }

    private static StepBundle step(CopyRequest.Tick tick, int copy) {
        Numbers numbers = tick.commands();
        int at = CopyRequest.Tick.STRIDE * copy;
        double seconds = numbers.get(at);
        List<DriveCommand> commands = seconds == 0
                ? List.of()
                : List.of(new DriveCommand(
                        tick.objectName(), numbers.get(at + 1), numbers.get(at + 2), numbers.get(at + 3)));
        return new StepBundle(seconds, List.of(), commands);
    }

    private void check(CopyRequest.Tick tick, int k) {
        Copy copy = copies.get(k);
        if (tick.commands().get(CopyRequest.Tick.STRIDE * k) > 0 && !copy.bodies.has(tick.objectName())) {
            throw new IllegalArgumentException("there is no body of " + Text.quoted(tick.objectName()) + " in copy " + k
                    + "; give it one by a step before the world is copied");
        }
        for (String name : tick.bodies()) {
            if (!copy.bodies.has(name)) {
                throw new IllegalArgumentException(
                        "bodies must have a body, given by a step before the world is copied (got: " + Text.quoted(name)
                                + ")");
            }
        }
        for (SenseRequest sense : tick.senses()) {
            String name = sense.objectName();
            if (sense.isAboutMover() && !copy.moveable.contains(name)) {
                throw new IllegalArgumentException(
                        "senses must be on moveable objects, or stand in the world (got: " + Text.quoted(name) + ")");
            }
        }
    }

    private static void write(BodyAnswer body, double[] states, int at) {
        states[at] = body.center().x();
        states[at + 1] = body.center().y();
        states[at + 2] = body.center().z();
        states[at + 3] = body.heading();
        states[at + 4] = body.velocity().x();
        states[at + 5] = body.velocity().y();
        states[at + 6] = body.velocity().z();
        states[at + 7] = body.velocity().ry();
    }

    private static void count(ContactAnswer contact, List<String> bodies, int[] touches, int first) {
        if (contact.phase() == ContactAnswer.Phase.END) {
            return;
        }
        int one = bodies.indexOf(contact.objectName());
        int other = contact.other() == null ? -1 : bodies.indexOf(contact.other());
        if (one >= 0 && other < 0) {
            touches[first + one]++;
        } else if (other >= 0 && one < 0) {
            touches[first + other]++;
        }
    }
}
