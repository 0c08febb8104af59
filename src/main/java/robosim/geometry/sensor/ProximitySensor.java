package robosim.geometry.sensor;

import robosim.geometry.Geometry;
import robosim.geometry.check.Checks;
import robosim.geometry.sensor.effects.Draws;
import robosim.geometry.sensor.effects.NoisyFrame;

/**
 * Tells how near the nearest other object is, on whichever side: RoboSim's proximity sensor. Immutable.
 *
 * <pre>{@code
 * Geometry world = new Geometry(20, 4, 20);
 * world.addObject(new BoxObject(new Point(2, 0, 0), 1, 1, 1));
 * world.addObject(new CylinderObject(new Point(0, 0, 0), 0.5, 1).moveable("robot"));
 * ProximitySensor near = ProximitySensor.on("robot", 3);
 * near.read(world);                               // 1.0
 * ProximitySensor.on("robot", 0.5).read(world);   // Infinity: nothing is within half a unit
 * }</pre>
 *
 * @param name   of the object that has the sensor
 * @param max    range in world units; may be infinite
 * @param noise  which must need neither normals nor cones; {@link Noise#NONE} for none
 * @param seed   of a whole run, for the noise
 * @param sensor distinguishes the sensors of a run; any number
 */
public record ProximitySensor(String name, double max, Noise noise, long seed, long sensor) {
    /** Refuses null, and what is out of range. */
    public ProximitySensor {
        Checks.name(name);
        Checks.range(0, max);
        max += 0.0;
        if (Checks.present("noise", noise).needsIncidence()) {
            throw new IllegalArgumentException(
                    "noise of a proximity sensor must not need the normals of rays, as grazing and"
                            + " mixedPixels do (got: " + noise + ")");
        }
    }

    /**
     * A sensor on an object.
     *
     * @param max range in world units; may be infinite
     */
    public static ProximitySensor on(String name, double max) {
        return new ProximitySensor(name, max, Noise.NONE, 0, 0);
    }

    /**
     * This sensor with noise, which must need neither normals nor cones. Its readings then need the number of their frame.
     *
     * @param itsSeed   of a whole run
     * @param itsSensor tells the sensors of a run apart, any number
     */
    public ProximitySensor withNoise(Noise given, long itsSeed, long itsSensor) {
        return new ProximitySensor(name, max, given, itsSeed, itsSensor);
    }

    /** This sensor with noise that depends on its name, as with {@link RaySensor#withNoise(Noise, long, String)}. */
    public ProximitySensor withNoise(Noise given, long itsSeed, String itsName) {
        return withNoise(given, itsSeed, Draws.number(Checks.present("name", itsName)));
    }

    /**
     * Reads a sensor without noise. One with noise must be told the number of the frame.
     *
     * @return what {@link Geometry#getProximity} returns, to the bit: 0 in contact, {@code +Infinity} if nothing is in range
     */
    public double read(Geometry world) {
        if (!noise.isNone()) {
            throw new IllegalArgumentException(
                    "a sensor with noise must be told the number of its frame, as in read(world, 17)"
                            + " (got: none; the noise is " + noise + ")");
        }
        return Checks.present("world", world).getProximity(name, max);
    }

    /**
     * Reads the sensor.
     *
     * @param frame the number of the reading, which the noise depends on
     */
    public double read(Geometry world, long frame) {
        double distance = Checks.present("world", world).getProximity(name, max);
        if (noise.isNone()) {
            return distance;
        }
        NoisyFrame measured = new NoisyFrame();
        measured.distances = new double[] {distance};
        measured.count = 1;
        measured.max = max;
        noise.apply(seed, sensor, frame, measured);
        measured.clamp();
        return measured.distances[0];
    }

    @Override
    public String toString() {
        return "ProximitySensor on \"" + name + "\" up to " + max + ", " + noise;
    }
}
