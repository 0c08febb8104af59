package robosim.geometry.bench;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PeerTableTest {
    @Test
    void mediansOfTheJvmsAndRatiosWithinEach() {
        PeerTable table = new PeerTable();
        double[][] ours = {{10, 30, 20}, {40, 40, 40}, {24, 25, 26}};
        double[] theirs = {10, 10, 25};
        for (int fork = 0; fork < 3; fork++) {
            for (double nanos : ours[fork]) {
                table.add("robosim W1a 100 " + nanos + " 7 8.5 1.0", fork, false);
            }
            table.add("engine W1a 100 " + theirs[fork] + " 7 8.5 2.0 mem_mb=0.1 min=3", fork, false);
            table.add("robosim W1a 100 99 7 8.5 1.0", fork, true);
            table.add("engine W1a 100 33 7 8.5 2.0 mem_mb=0.1", fork, true);
        }
        table.addFact("robosim W1a 100 92.0 bytes a part");
        assertThat(table.lines())
                .containsExactly(
                        "robosim W1a 100 25.0 7 8.5 1.0 least=20.0 most=40.0 beside=99.0",
                        "engine W1a 100 10.0 7 8.5 2.0 mem_mb=0.1 least=10.0 most=25.0 beside=33.0",
                        "ratio W1a 100 2.000 x engine, 1.000 to 4.000 in 3 JVMs",
                        "ratio W1a 100 3.000 x engine, 3.000 to 3.000 in 3 JVMs,"
                                + " beside a neighbour that sweeps through memory",
                        "robosim W1a 100 92.0 bytes a part");
    }
}
