package robosim.geometry.cli.network;

import java.io.PrintWriter;
import java.util.concurrent.TimeUnit;
import robosim.geometry.net.FiguresMXBean;

/** Prints the figures of one end of the connection: at intervals, and when the process ends. */
public final class FiguresPrinter {
    private FiguresPrinter() {}

    /** Starts printing. When the process is told to end, {@code close} runs before the last line is printed. */
    static void start(PrintWriter out, FiguresMXBean figures, int seconds, Runnable close) {
        Runtime.getRuntime()
                .addShutdownHook(new Thread(
                        () -> {
                            close.run();
                            print(out, figures);
                        },
                        "figures-at-the-end"));
        if (seconds > 0) {
            Thread thread = new Thread(() -> repeat(out, figures, seconds), "figures");
            thread.setDaemon(true);
            thread.start();
        }
    }

    private static void repeat(PrintWriter out, FiguresMXBean figures, int seconds) {
        try {
            while (true) {
                TimeUnit.SECONDS.sleep(seconds);
                print(out, figures);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void print(PrintWriter out, FiguresMXBean figures) {
        out.println(figures.line());
        out.flush();
    }
}
