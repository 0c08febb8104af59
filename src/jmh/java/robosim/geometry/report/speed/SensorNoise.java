package robosim.geometry.report.speed;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.sensor.effects.Draws;
import robosim.geometry.sensor.effects.NoiseEffect;
import robosim.geometry.sensor.effects.NoisyFrame;

/** Each effect of noise, and some that are mostly used together: nanoseconds a ray, the copy of its distance included. */
final class SensorNoise {
    static final String SCENE = "noise";
    static final String TYPICAL = "Gaussian and proportional and quantized";
    static final String ALL = "these and dropout and grazing";

    private static final int RAYS = SensorScene.WIDTH * SensorScene.HEIGHT;

    private final double[] truth = new double[RAYS];
    private final double[] cones = new double[RAYS];
    private final double[] incidence = new double[RAYS];

    private SensorNoise() {
        SplittableRandom random = new SplittableRandom(Form.SEED);
        for (int k = 0; k < RAYS; k++) {
            truth[k] = random.nextInt(20) == 0 ? Double.POSITIVE_INFINITY : random.nextDouble(0.5, 30);
            cones[k] = Math.min(truth[k], 30) * (random.nextInt(20) == 0 ? 0.5 : 0.999);
            incidence[k] = truth[k] < 100 ? random.nextDouble() : -1;
        }
    }

    /** What is measured, by its name. */
    static Map<String, List<NoiseEffect>> kinds() {
        NoiseEffect gaussian = new NoiseEffect.Gaussian(0, 0.01);
        NoiseEffect proportional = new NoiseEffect.Proportional(0.002);
        NoiseEffect quantized = new NoiseEffect.Quantized(0.001);
        NoiseEffect dropout = new NoiseEffect.Dropout(0.02);
        NoiseEffect grazing = new NoiseEffect.Grazing(0.005, 80);
        Map<String, List<NoiseEffect>> kinds = new LinkedHashMap<>();
        kinds.put("Gaussian", List.of(gaussian));
        kinds.put("proportional", List.of(proportional));
        kinds.put("bias", List.of(new NoiseEffect.Bias(0, 0.01)));
        kinds.put("quantized", List.of(quantized));
        kinds.put("dropout", List.of(dropout));
        kinds.put("grazing", List.of(grazing));
        kinds.put("mixed pixels", List.of(new NoiseEffect.MixedPixels(0.3, 0.1)));
        kinds.put("false echoes", List.of(new NoiseEffect.FalseEchoes(0.001)));
        kinds.put(TYPICAL, List.of(gaussian, proportional, quantized));
        kinds.put(ALL, List.of(gaussian, proportional, quantized, dropout, grazing));
        return kinds;
    }

    static void run(Form form, Study.Sink sink, Study.Progress progress) {
        SensorNoise noise = new SensorNoise();
        InTurn tasks = new InTurn(form);
        Subject module = Subject.module(Accuracy.EXACT, Dimension.SPATIAL);
        kinds().forEach((name, effects) ->
                tasks.add(module, SCENE, name, RAYS, (from, count) -> noise.disturb(effects, count)));
        tasks.run(sink, progress);
    }

    /** As a frame does it: a copy of the distances, one effect after the other, and the sensor's range. */
    private double disturb(List<NoiseEffect> effects, int count) {
        NoisyFrame measured = new NoisyFrame();
        measured.distances = disturbed;
        System.arraycopy(truth, 0, disturbed, 0, count);
        measured.count = count;
        measured.min = 0;
        measured.max = 100;
        measured.incidence = incidence;
        measured.cones = cones;
        frame++;
        for (int k = 0; k < effects.size(); k++) {
            long key = Draws.key(Draws.key(0, frame), k);
            effects.get(k).apply(key, Draws.step(key), measured);
        }
        measured.clamp();
        return disturbed[count / 2];
    }

    private final double[] disturbed = new double[RAYS];
    private long frame;
}
