package robosim.geometry.narrow.turn;

/** Working memory of turns. */
final class TurnWorkspace {
    final VerticalTurn vertical = new VerticalTurn();
    final TurnBody body = new TurnBody();
    final TurnAdvancement advancement = new TurnAdvancement();
}
