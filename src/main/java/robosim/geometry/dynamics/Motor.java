package robosim.geometry.dynamics;

/**
 * A direct-current motor that turns a wheel through gears: its torque falls from the stall torque to 0 at the free speed, as its
 * back-EMF grows, and is limited by the current that it may draw. What it draws lowers the voltage of its supply.
 *
 * <pre>{@code
 * Motor kraken = new Motor(7.09, 6000, 366, 6.75, 0.0508, 80, 0.003);
 * Math.round(kraken.freeSpeed() * 100);    // 473: cm/s of the wheel's rim
 * Math.round(kraken.force(0));             // 206: newtons, within 80 A
 * }</pre>
 *
 * @param stallTorque      newton metres at the motor, at the nominal voltage
 * @param freeTurns        turns a minute of the motor without load, at the nominal voltage
 * @param stallCurrent     amperes at stall, at the nominal voltage of 12 V
 * @param gearRatio        turns of the motor for one of the wheel
 * @param wheelRadius      metres
 * @param currentLimit     amperes; infinite for no limit
 * @param supplyResistance ohms: the resistance of the supply times the number of motors that draw from it at once; 0 for a supply
 *                         whose voltage does not drop
 */
public record Motor(
        double stallTorque,
        double freeTurns,
        double stallCurrent,
        double gearRatio,
        double wheelRadius,
        double currentLimit,
        double supplyResistance) {
    private static final double VOLTS = 12;

    /** Refuses values that are out of range or not a number. */
    public Motor {
        stallTorque = QuantityChecks.positive("stallTorque", stallTorque);
        freeTurns = QuantityChecks.positive("freeTurns", freeTurns);
        stallCurrent = QuantityChecks.positive("stallCurrent", stallCurrent);
        gearRatio = QuantityChecks.positive("gearRatio", gearRatio);
        wheelRadius = QuantityChecks.positive("wheelRadius", wheelRadius);
        currentLimit = QuantityChecks.limit("currentLimit", currentLimit);
        supplyResistance = QuantityChecks.atLeastZero("supplyResistance", supplyResistance);
    }

    /** The speed of the wheel's rim without load, m/s. */
    public double freeSpeed() {
        return freeTurns / 60 * 2 * Math.PI / gearRatio * wheelRadius;
    }

    /**
     * The most force forward at the wheel's rim while that moves at a speed, newtons; below 0 above the free speed, where the
     * motor brakes. Backward it is {@code -force(-speed)}.
     *
     * @param speed m/s; negative for backward
     */
    public double force(double speed) {
        return QuantityChecks.clamp(stalled() * (1 - speed / freeSpeed()), currentLimit) * forceOfCurrent();
    }

    /** The speed at which it gives a force, m/s, as far as its current is not limited. */
    double speed(double force) {
        return freeSpeed() * (1 - force / (stalled() * forceOfCurrent()));
    }

    /** The current at stall, as low as the supply makes it. */
    private double stalled() {
        return VOLTS / (VOLTS / stallCurrent + supplyResistance);
    }

    private double forceOfCurrent() {
        return stallTorque / stallCurrent * gearRatio / wheelRadius;
    }
}
