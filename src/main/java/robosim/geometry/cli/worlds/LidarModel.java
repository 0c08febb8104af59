package robosim.geometry.cli.worlds;

import java.util.Iterator;
import java.util.Locale;
import java.util.stream.Stream;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import robosim.geometry.sensor.Lidar;

/** The lidars with a preset, as the command line names them. */
enum LidarModel {
    VLP16("vlp16"),
    VLP32C("vlp32c"),
    OS1_64("os1-64"),
    OS1_128("os1-128"),
    UTM30LX("utm30lx"),
    LDS02("lds02");

    private static final double HERTZ = 10;

    private final String label;

    LidarModel(String label) {
        this.label = label;
    }

    Lidar lidar() {
        return switch (this) {
            case VLP16 -> Lidar.velodyneVlp16(HERTZ);
            case VLP32C -> Lidar.velodyneVlp32c(HERTZ);
            case OS1_64 -> Lidar.ousterOs1With64(HERTZ);
            case OS1_128 -> Lidar.ousterOs1With128(HERTZ);
            case UTM30LX -> Lidar.hokuyoUtm30lx();
            case LDS02 -> Lidar.robotisLds02();
        };
    }

    /** The names of the lidars. */
    static final class Names implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return Stream.of(LidarModel.values()).map(each -> each.label).iterator();
        }
    }

    /** Finds a lidar by its name. */
    static final class Converter implements ITypeConverter<LidarModel> {
        @Override
        public LidarModel convert(String value) {
            return Stream.of(LidarModel.values())
                    .filter(each -> each.label.equals(value.toLowerCase(Locale.ROOT)))
                    .findFirst()
                    .orElseThrow(() -> new TypeConversionException(
                            "must be one of " + String.join(", ", new Names()) + " (got: " + value + ")"));
        }
    }
}
