package robosim.geometry.narrow;

/** Working memory of turns. */
final class TurnKernels {
    final VerticalTurn vertical = new VerticalTurn();
    final TurnBody body = new TurnBody();
    final HeldTurn held = new HeldTurn();
}
