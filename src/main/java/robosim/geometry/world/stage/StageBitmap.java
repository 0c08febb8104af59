package robosim.geometry.world.stage;

import java.util.BitSet;
import robosim.geometry.image.PixelSink;
import robosim.geometry.world.shared.Limits;

/** The dark pixels of an image, which are solid in Stage: those of at most half of white, of colours in red. */
final class StageBitmap implements PixelSink {
    private Format format = new Format(0, 0, 1, 1);
    final BitSet dark = new BitSet();

    int width() {
        return format.width();
    }

    int height() {
        return format.height();
    }

    @Override
    public void begin(Format given) {
        if ((long) given.width() * given.height() > Limits.MAX_CELLS) {
            throw new IllegalArgumentException("a bitmap must have at most " + Limits.MAX_CELLS + " pixels (got: "
                    + given.width() + " x " + given.height() + ")");
        }
        format = given;
    }

    @Override
    public void pixels(int row, int first, int step, int count, int[] samples) {
        for (int k = 0; k < count; k++) {
            if (255L * samples[k * format.channels()] <= 127L * format.white()) {
                dark.set(row * format.width() + first + k * step);
            }
        }
    }
}
