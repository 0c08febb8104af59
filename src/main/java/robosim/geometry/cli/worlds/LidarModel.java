package robosim.geometry.cli.worlds;

import robosim.geometry.sensor.Lidar;

/** The lidars with a preset, as the command line names them. */
enum LidarModel {
    VLP16,
    VLP32C,
    OS1_64,
    OS1_128,
    UTM30LX,
    LDS02;

    private static final double HERTZ = 10;

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
}
