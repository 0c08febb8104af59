package robosim.geometry.narrow.sweep;

import robosim.geometry.narrow.leaf.ProjectedPolygon;
import robosim.geometry.narrow.sat.MovingAxes;

/** Working memory of sweeps. */
final class SweepWorkspace {
    final MovingAxes axes = new MovingAxes();
    final MovingDisc disc = new MovingDisc();
    final ProjectedPolygon outline = new ProjectedPolygon();
    final MovingBall ball = new MovingBall();
    final TranslationAdvancement move = new TranslationAdvancement();
    final VerticalTurn vertical = new VerticalTurn();
    final TurnBody body = new TurnBody();
    final TurnAdvancement turning = new TurnAdvancement();
    final TurnSieve sieve = new TurnSieve();
}
