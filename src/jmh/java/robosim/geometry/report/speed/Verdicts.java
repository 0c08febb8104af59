package robosim.geometry.report.speed;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.report.Dyn4jPeer;
import robosim.geometry.report.JtsPeer;
import robosim.geometry.report.Outline;
import robosim.geometry.report.Peer;
import robosim.geometry.report.Peer.CannotException;
import robosim.geometry.report.speed.PairMaker.Family;
import robosim.geometry.report.speed.PairMaker.Pair;

/** Do two objects touch? Against the true signed gap: which say yes where there is a gap, which no where there is none. */
final class Verdicts implements Study {
    static final int LOW = -16;
    static final int HIGH = 0;
    static final String TOUCH = "0";

    /** Asked and wrong, by the decade of the gap. */
    private static final class Tally {
        final Map<String, int[]> bins = new TreeMap<>();
        final Wrongs wrongs = new Wrongs();

        void count(double gap, boolean isWrong) {
            wrongs.add(gap, isWrong);
            String bin = bin(gap);
            int[] counts = bins.computeIfAbsent(bin, key -> new int[2]);
            counts[0]++;
            counts[1] += isWrong ? 1 : 0;
        }
    }

    /** The decade of a gap, as its lower end in size: 1e-5 is 1e-5 to 1e-4. */
    static String bin(double gap) {
        if (gap == 0) {
            return TOUCH;
        }
        int exponent = robosim.geometry.report.chart.Decades.floor(Math.abs(gap));
        return (gap < 0 ? "-" : "") + "1e" + Math.max(LOW - 1, exponent);
    }

    @Override
    public void run(Form form, Sink sink, Progress progress) {
        Family[] families = Family.values();
        for (int k = 0; k < families.length; k++) {
            double done = k;
            family(families[k], form, sink, share -> progress.at((done + share) / families.length));
        }
    }

    private static void family(Family family, Form form, Sink sink, Progress progress) {
        PairMaker maker = new PairMaker(family, new SplittableRandom(Form.SEED + family.ordinal()));
        SplittableRandom random = new SplittableRandom(Form.SEED + 50 + family.ordinal());
        Map<Subject, Tally> tallies = new LinkedHashMap<>();
        int made = 0;
        while (made < form.cases()) {
            Pair pair;
            if (made % 20 == 0) {
                pair = maker.touching();
            } else {
                double size = Math.pow(10, random.nextDouble(LOW - 0.5, HIGH + 0.5));
                pair = maker.near(random.nextBoolean() ? size : -size);
            }
            if (pair != null) {
                ask(family.dimension, pair, tallies);
                made++;
            }
            progress.at(made / (double) form.cases());
        }
        tallies.forEach((subject, tally) -> {
            tally.bins.forEach((bin, counts) -> {
                sink.put(subject, family.text, "overlap", "asked " + bin, counts[0]);
                sink.put(subject, family.text, "overlap", "wrong " + bin, counts[1]);
            });
            sink.put(subject, family.text, "overlap", Resolution.METRIC, tally.wrongs.widest(Resolution.MOST_WRONG));
        });
    }

    private static void ask(Dimension dimension, Pair pair, Map<Subject, Tally> tallies) {
        boolean truth = pair.gap().signum() <= 0;
        double gap = pair.gap().doubleValue();
        Geometry geometry = new Geometry(100, 100, 100, dimension, Accuracy.EXACT);
        geometry.addObjectUnchecked(pair.a());
        boolean isAlone = Subject.module(Accuracy.EXACT, dimension).isAlone();
        for (Accuracy level : isAlone ? List.of(Accuracy.EXACT) : Sizes.backwards()) {
            count(tallies, Subject.module(level, dimension), gap, geometry.testObject(pair.b(), level) != truth);
        }
        if (dimension == Dimension.PLANAR && !isAlone) {
            for (Peer peer : List.of(new JtsPeer(), new Dyn4jPeer())) {
                count(tallies, Subject.peer(peer.name()), gap, overlap(peer, pair) != truth);
            }
        }
    }

    private static boolean overlap(Peer peer, Pair pair) {
        try {
            return peer.overlap(Outline.of(pair.a()), Outline.of(pair.b()));
        } catch (CannotException e) {
            throw new IllegalStateException(e);
        }
    }

    private static void count(Map<Subject, Tally> tallies, Subject subject, double gap, boolean isWrong) {
        tallies.computeIfAbsent(subject, key -> new Tally()).count(gap, isWrong);
    }
}
