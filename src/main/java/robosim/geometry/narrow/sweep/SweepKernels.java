package robosim.geometry.narrow.sweep;

import robosim.geometry.narrow.leaf.Outline;
import robosim.geometry.narrow.sat.MovingAxes;

/** Working memory of straight sweeps. */
final class SweepKernels {
    final MovingAxes axes = new MovingAxes();
    final MovingDisc disc = new MovingDisc();
    final Outline outline = new Outline();
    final MovingBall ball = new MovingBall();
    final TranslationAdvancement move = new TranslationAdvancement();
}
