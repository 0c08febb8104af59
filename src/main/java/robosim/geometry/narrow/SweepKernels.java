package robosim.geometry.narrow;

/** Working memory of straight sweeps. */
final class SweepKernels {
    final MovingAxes axes = new MovingAxes();
    final MovingDisc disc = new MovingDisc();
    final Outline outline = new Outline();
    final MovingBall ball = new MovingBall();
    final HeldMove move = new HeldMove();
}
