package robosim.geometry.narrow;

/** Working memory of the sweeps. */
final class SweepScratch {
    final MovingAxes axes = new MovingAxes();
    final MovingDisc disc = new MovingDisc();
    final Outline outline = new Outline();
    final PlanarTurn turn = new PlanarTurn();
    final TurnBody body = new TurnBody();
    final MovingBall ball = new MovingBall();
    final HeldMove move = new HeldMove();
    final HeldTurn heldTurn = new HeldTurn();
}
