package robosim.geometry.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.sensor.Noise;

class SdfNoiseTest {
    @Test
    void whatSdformatDescribes() {
        assertThat(SdfSensor.readNoise("<noise type='none'/>")).isEqualTo(Noise.NONE);
        assertThat(SdfSensor.readNoise("<noise type=\"gaussian\"><mean>0.0</mean><stddev> 0.01 </stddev></noise>"))
                .isEqualTo(Noise.gaussian(0.01));
        assertThat(SdfSensor.readNoise("<noise><type>gaussian</type><mean>0.5</mean></noise>"))
                .isEqualTo(Noise.gaussian(0.5, 0));
        assertThat(SdfSensor.readNoise("""
                <?xml version="1.0"?>
                <!-- a laser's -->
                <noise type="gaussian_quantized">
                  <mean>0.1</mean>
                  <stddev>0.2</stddev>
                  <bias_mean>0.3</bias_mean>
                  <bias_stddev>0.4</bias_stddev>
                  <precision>0.5</precision>
                  <dynamic_bias_stddev>0</dynamic_bias_stddev>
                </noise>
                """))
                .isEqualTo(Noise.gaussian(0.1, 0.2).and(Noise.bias(0.3, 0.4)).and(Noise.quantized(0.5)));
        // Precision is that of the quantized kind alone.
        assertThat(SdfSensor.readNoise("<noise type='gaussian'><precision>0.5</precision></noise>"))
                .isEqualTo(Noise.NONE);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            <range/> | xml must be a <noise> element (got: <range>)
            <noise/> | <noise> must have a type (got: none)
            <noise type='white'/> | type must be none, gaussian or gaussian_quantized (got: "white")
            <noise type='gaussian'><mean>much</mean></noise> | mean must be a number (got: "much")
            <noise type='gaussian'><mean>NaN</mean></noise> | mean must be a number (got: "NaN")
            <noise type='gaussian'><stddev>-1</stddev></noise> | deviation must be a number from 0 to 2^100 (got: -1.0)
            <noise type='gaussian'><mean>1</mean><mean>2</mean></noise> | <noise> must have one <mean> (got: two)
            <noise type='gaussian'><sigma>1</sigma></noise> | must have elements that are known (got: <sigma>)
            <noise type='gaussian'><mean><b>1</b></mean></noise> | no elements within elements (got: <b>)
            <noise type='gaussian'><dynamic_bias_stddev>1</dynamic_bias_stddev></noise> | a bias that changes with time
            <noise type='gaussian'> | noise:1:
            <!DOCTYPE noise []><noise type='none'/> | a document type is not allowed
            """)
    void refused(String xml, String message) {
        assertThatThrownBy(() -> SdfSensor.readNoise(xml))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(message);
    }
}
