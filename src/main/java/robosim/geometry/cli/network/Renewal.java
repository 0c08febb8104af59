package robosim.geometry.cli.network;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import robosim.geometry.net.GeometryServer;

/** Reads keys, certificates and secrets again when their files change, for connections from then on. */
final class Renewal {
    private static final System.Logger LOG = System.getLogger(GeometryServer.class.getPackageName());
    private static final long SECONDS = 2;

    private final List<Path> files;
    private final Runnable renew;

    /** What the files were like when they were last read, and at the last look. */
    private List<String> used;

    private List<String> seen;

    /** Files that have just been read; {@code renew} reads them again, and fails with an IllegalArgumentException that names the reason. */
    Renewal(List<Path> files, Runnable renew) {
        this.files = files;
        this.renew = renew;
        this.used = stamps();
        this.seen = used;
    }

    /** Looks after the files until the process ends; does nothing if there are none. */
    void start() {
        if (files.isEmpty()) {
            return;
        }
        Thread thread = new Thread(this::repeat, "renewal-of-keys");
        thread.setDaemon(true);
        thread.start();
    }

    private void repeat() {
        try {
            while (true) {
                TimeUnit.SECONDS.sleep(SECONDS);
                look();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Reads the files if they have changed, and not since the last look, as they do while they are written. */
    void look() {
        List<String> now = stamps();
        boolean isDue = !now.equals(used) && now.equals(seen);
        seen = now;
        if (!isDue) {
            return;
        }
        used = now;
        try {
            renew.run();
            LOG.log(System.Logger.Level.INFO, "keys, certificates and secrets were read again: " + files);
        } catch (IllegalArgumentException e) {
            LOG.log(System.Logger.Level.WARNING, "keys, certificates and secrets stay as they were: " + e.getMessage());
        }
    }

    private List<String> stamps() {
        List<String> stamps = new ArrayList<>();
        for (Path file : files) {
            try {
                stamps.add(Files.getLastModifiedTime(file) + " " + Files.size(file));
            } catch (IOException e) {
                stamps.add("missing");
            }
        }
        return stamps;
    }
}
