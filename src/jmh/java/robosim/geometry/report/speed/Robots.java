package robosim.geometry.report.speed;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/** Steps a second of the warehouse with 100 and 1,000 robots of 16 cone sonars each, on one thread. */
final class Robots implements Study {
    static final List<Integer> COUNTS = List.of(100, 1000);
    static final String IN_PROCESS = "in process";
    static final String OVER_TCP = "over TCP";

    @Override
    public void run(Form form, Sink sink, Progress progress) throws IOException {
        Place place = Place.of("warehouse");
        for (int k = 0; k < COUNTS.size(); k++) {
            double done = k;
            measure(
                    new Herd(place, COUNTS.get(k)),
                    COUNTS.get(k) + " robots",
                    form,
                    sink,
                    share -> progress.at((done + share) / COUNTS.size()));
        }
    }

    private static void measure(Herd herd, String scene, Form form, Sink sink, Progress progress) throws IOException {
        InTurn tasks = new InTurn(form);
        List<Herd.Wire> wires = new ArrayList<>();
        try {
            for (Dimension dimension : List.of(Dimension.SPATIAL, Dimension.PLANAR)) {
                for (Accuracy level : Sizes.backwards()) {
                    Subject subject = Subject.module(level, dimension);
                    tasks.add(subject, scene, IN_PROCESS, 1, herd.inProcess(dimension, level));
                    if (level == Accuracy.EXACT) {
                        Herd.Wire wire = herd.overTcp(dimension, level);
                        wires.add(wire);
                        tasks.add(subject, scene, OVER_TCP, 1, wire);
                    }
                }
            }
            tasks.run(sink, progress);
        } finally {
            for (Herd.Wire wire : wires) {
                wire.close();
            }
        }
    }
}
