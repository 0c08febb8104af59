package robosim.geometry.world;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import robosim.geometry.check.Checks;
import robosim.geometry.sensor.Noise;
import robosim.geometry.world.shared.FileProblem;
import robosim.geometry.world.xml.SafeXml;
import robosim.geometry.world.xml.XmlHandler;

/** Reads the noise of a sensor as SDFormat describes it. */
final class SdfNoise extends XmlHandler {
    private static final String SOURCE = "noise";

    private final Map<String, String> values = new HashMap<>();
    private final StringBuilder text = new StringBuilder();
    private int depth;
    private @Nullable String type;

    private SdfNoise() {
        super(SOURCE);
    }

    /** The noise of a {@code <noise>} element: see {@link SdfSensor#readNoise}. */
    static Noise read(String xml) {
        SdfNoise found = new SdfNoise();
        byte[] bytes = Checks.present("xml", xml).getBytes(StandardCharsets.UTF_8);
        try {
            SafeXml.parse(new ByteArrayInputStream(bytes), SOURCE, found);
        } catch (FileProblem e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
        return found.noise();
    }

    /** The noise that elements describe, by their names; what is left over is refused. */
    static Noise of(Map<String, String> elements) {
        SdfNoise found = new SdfNoise();
        found.values.putAll(elements);
        return found.noise();
    }

    @Override
    public void startElement(String uri, String local, String name, Attributes attributes) {
        depth++;
        text.setLength(0);
        if (depth == 1) {
            if (!name.equals("noise")) {
                throw new IllegalArgumentException("xml must be a <noise> element (got: <" + name + ">)");
            }
            type = attributes.getValue("type");
        } else if (depth > 2) {
            throw new IllegalArgumentException("<noise> must have no elements within elements (got: <" + name + ">)");
        }
    }

    @Override
    public void characters(char[] characters, int start, int length) {
        text.append(characters, start, length);
    }

    @Override
    public void endElement(String uri, String local, String name) {
        if (depth-- == 2 && values.put(name, text.toString().strip()) != null) {
            throw new IllegalArgumentException("<noise> must have one <" + name + "> (got: two)");
        }
    }

    private Noise noise() {
        String inside = values.remove("type");
        String kind = type == null ? inside : type;
        if (kind == null) {
            throw new IllegalArgumentException("<noise> must have a type (got: none)");
        }
        double mean = number("mean");
        double deviation = number("stddev");
        double biasMean = number("bias_mean");
        double biasDeviation = number("bias_stddev");
        double precision = number("precision");
        if (number("dynamic_bias_stddev") != 0) {
            throw new IllegalArgumentException(
                    "dynamic_bias_stddev must be 0: a bias that changes with time is not simulated");
        }
        number("dynamic_bias_correlation_time"); // of no effect without the former
        if (!values.isEmpty()) {
            throw new IllegalArgumentException("<noise> must have elements that are known (got: <"
                    + values.keySet().stream().sorted().toList().get(0) + ">)");
        }
        Noise noise = Noise.NONE;
        switch (kind) {
            case "none" -> {
                return noise;
            }
            case "gaussian", "gaussian_quantized" -> {
                if (mean != 0 || deviation != 0) {
                    noise = noise.and(Noise.gaussian(mean, deviation));
                }
                if (biasMean != 0 || biasDeviation != 0) {
                    noise = noise.and(Noise.bias(biasMean, biasDeviation));
                }
                boolean isQuantized = kind.equals("gaussian_quantized") && precision != 0;
                return isQuantized ? noise.and(Noise.quantized(precision)) : noise;
            }
            default ->
                throw new IllegalArgumentException(
                        "type must be none, gaussian or gaussian_quantized (got: \"" + kind + "\")");
        }
    }

    /** Takes a number out of the values; 0 where there is none. */
    private double number(String name) {
        String value = values.remove(name);
        if (value == null) {
            return 0;
        }
        try {
            double number = Double.parseDouble(value);
            if (Double.isFinite(number)) {
                return number;
            }
        } catch (NumberFormatException e) {
            // told below
        }
        throw new IllegalArgumentException(name + " must be a number (got: \"" + value + "\")");
    }
}
