package robosim.geometry.scenario.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** A new file that can be truncated to the last complete line if the disk becomes full within another. */
public class RecordingFile extends OutputStream {
    private final FileChannel file;

    /** Creates the file, which must not exist. */
    public RecordingFile(Path place) throws IOException {
        file = FileChannel.open(place, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    }

    @Override
    public void write(int single) throws IOException {
        write(new byte[] {(byte) single}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int at, int length) throws IOException {
        ByteBuffer left = ByteBuffer.wrap(bytes, at, length);
        while (left.hasRemaining()) {
            file.write(left);
        }
    }

    /** Truncates the file to a number of bytes. */
    public void cutTo(long bytes) throws IOException {
        file.truncate(bytes);
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
