package robosim.geometry.sweep;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import robosim.geometry.check.Checks;
import robosim.geometry.sweep.lines.ChecksummedLine;

/**
 * The results of one sweep, in one file or in those of its shards; read from the files on demand, in the order of their
 * indices.
 */
public final class SweepResults {
    private final List<Path> files;
    private final SweepHeader header;
    private final List<Entry> entries;
    private long torn;

    /** The position of an outcome's line. */
    private record Entry(long index, int file, long offset, int length) {}

    private SweepResults(List<Path> files, SweepHeader header, List<Entry> entries) {
        this.files = files;
        this.header = header;
        this.entries = entries;
    }

    /**
     * Reads files of results. If two contain the same replicate, their outcomes must be equal.
     *
     * @throws IOException if a file is not one of results, is damaged, or belongs to another sweep; names file and
     *     line
     */
    public static SweepResults read(List<Path> files) throws IOException {
        Checks.list("files", files);
        List<Entry> all = new ArrayList<>();
        SweepHeader header = null;
        long torn = 0;
        for (int k = 0; k < files.size(); k++) {
            int number = k;
            SweepFile file = SweepFile.read(
                    files.get(k),
                    (outcome, offset, length) -> all.add(new Entry(outcome.index(), number, offset, length)));
            torn += file.torn() > 0 ? 1 : 0;
            SweepHeader own = file.header();
            if (own == null) {
                continue; // its run was killed before it had written anything
            }
            if (header != null && !own.isOfSame(header)) {
                throw new SweepException(files.get(k) + ": it must be of the same sweep as the others; it has "
                        + own.differences(header));
            }
            header = header == null || own.replicates() > header.replicates() ? own : header;
        }
        if (header == null) {
            throw new SweepException("there must be at least one whole line of results (got: none in " + files + ")");
        }
        all.sort(Comparator.comparingLong(Entry::index).thenComparingInt(Entry::file));
        SweepResults results = new SweepResults(List.copyOf(files), header, new ArrayList<>());
        results.torn = torn;
        results.takeOnce(all);
        return results;
    }

    private void takeOnce(List<Entry> all) throws IOException {
        try (Lines lines = new Lines()) {
            Entry before = null;
            for (Entry entry : all) {
                if (entry.index >= header.size()) {
                    throw new SweepException(files.get(entry.file) + ": an index must be below " + header.size()
                            + " (got: " + entry.index + ")");
                }
                if (before == null || before.index != entry.index) {
                    entries.add(entry);
                } else if (!lines.line(before).equals(lines.line(entry))) {
                    throw new SweepException(
                            "two results of replicate " + entry.index + " must be the same (got: others in "
                                    + files.get(before.file) + " and " + files.get(entry.file) + ")");
                }
                before = entry;
            }
        }
    }

    /** The header of the sweep. */
    public SweepHeader header() {
        return header;
    }

    /** The number of results. */
    public long size() {
        return entries.size();
    }

    /** The number of files that end in an incomplete line, which was skipped. */
    public long torn() {
        return torn;
    }

    /** Passes all outcomes to a consumer, by ascending index. */
    public void forEach(Consumer<Outcome> consumer) throws IOException {
        Checks.present("consumer", consumer);
        try (Lines lines = new Lines()) {
            for (Entry entry : entries) {
                String open = ChecksummedLine.open(lines.line(entry));
                if (open == null) {
                    throw new SweepException(files.get(entry.file) + ": it must not change while it is read");
                }
                consumer.accept(Outcome.of(open));
            }
        }
    }

    /** A digest of all of them: see {@link SweepHeader#digest}. */
    public String digest() throws IOException {
        SweepDigest digest = new SweepDigest(header);
        forEach(digest::add);
        return digest.hex();
    }

    /**
     * Writes all of them as CSV (RFC 4180) for spreadsheets and data frames, in the order of their indices: a row for each
     * replicate, with a column for each parameter and each number. A cell is empty where there is no value, as for a beam
     * without an echo.
     */
    public void writeCsv(Path file) throws IOException {
        SweepCsv.write(this, file);
    }

    /** Writes all of them to one file by ascending index; the file appears only when it is complete. */
    public void write(Path file) throws IOException {
        write(file, header);
    }

    void write(Path file, SweepHeader as) throws IOException {
        Checks.present("file", file);
        Path absolute = file.toAbsolutePath();
        Path half = absolute.resolveSibling(absolute.getFileName() + ".half");
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(half));
                Lines lines = new Lines()) {
            out.write((as.sealed() + "\n").getBytes(StandardCharsets.UTF_8));
            for (Entry entry : entries) {
                out.write((lines.line(entry) + "\n").getBytes(StandardCharsets.UTF_8));
            }
        } catch (IOException e) {
            throw SweepException.on(file, e);
        }
        Files.move(half, absolute, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    }

    /** The files, of which only a few are open at a time, since there may be thousands of shards. */
    private final class Lines implements AutoCloseable {
        private static final int MOST_OPEN = 64;

        /** The least recently read file comes first. */
        private final Map<Integer, RandomAccessFile> open = new LinkedHashMap<>(16, 0.75f, true);

        String line(Entry entry) throws IOException {
            RandomAccessFile in = open.get(entry.file);
            if (in == null) {
                if (open.size() == MOST_OPEN) {
                    Iterator<RandomAccessFile> eldest = open.values().iterator();
                    eldest.next().close();
                    eldest.remove();
                }
                in = new RandomAccessFile(files.get(entry.file).toFile(), "r");
                open.put(entry.file, in);
            }
            byte[] bytes = new byte[entry.length - 1];
            in.seek(entry.offset);
            in.readFully(bytes);
            return new String(bytes, StandardCharsets.UTF_8);
        }

        @Override
        public void close() throws IOException {
            for (RandomAccessFile each : open.values()) {
                each.close();
            }
        }
    }
}
