package robosim.geometry.net;

import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.Gate;
import robosim.geometry.protocol.MessageChannel;

/** Lets a peer in by what it speaks and what it knows; who is not in yet may not dawdle. */
final class Porter implements Gate {
    private final Access access;
    private final PacedInput in;
    private final Patience patience;
    private @Nullable MessageChannel channel;

    Porter(Access access, PacedInput in, Patience patience) {
        this.access = access;
        this.in = in;
        this.patience = patience;
        if (access.secret() != null) {
            in.mayIdle(patience.stall());
        }
    }

    /** The channel whose peer it is asked about. */
    void watch(MessageChannel made) {
        channel = made;
    }

    @Override
    public boolean admits(@Nullable String offered) {
        boolean java = channel != null && channel.encoding() == MessageChannel.Encoding.JAVA;
        boolean admitted = java ? access.admitsJava() : access.admitsJson(offered);
        if (admitted) {
            in.mayIdle(patience.idle());
        }
        return admitted;
    }
}
