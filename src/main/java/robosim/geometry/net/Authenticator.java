package robosim.geometry.net;

import org.jspecify.annotations.Nullable;
import robosim.geometry.net.pace.Admissions;
import robosim.geometry.net.pace.PacedInput;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.channel.MessageChannel;
import robosim.geometry.protocol.json.PeerAdmission;

/** Admits a peer by its encoding and its secret; until it is admitted, shorter timeouts hold. */
final class Authenticator implements PeerAdmission {
    private final Access access;
    private final PacedInput in;
    private final Timeouts timeouts;
    private final Admissions.Newcomer newcomer;
    private @Nullable MessageChannel channel;

    Authenticator(Access access, PacedInput in, Timeouts timeouts, Admissions.Newcomer newcomer) {
        this.access = access;
        this.in = in;
        this.timeouts = timeouts;
        this.newcomer = newcomer;
        in.from(newcomer);
        if (access.secret() != null) {
            in.mayIdle(timeouts.stall());
        }
    }

    /** Sets the channel of the peer to authenticate. */
    void watch(MessageChannel made) {
        channel = made;
    }

    @Override
    public boolean admits(@Nullable String offered) throws ProtocolException {
        boolean java = channel != null && channel.encoding() == MessageChannel.Encoding.JAVA;
        boolean admitted = java ? access.admitsJava() : access.admitsJson(offered);
        if (admitted) {
            in.mayIdle(timeouts.idle());
            if (!java) {
                newcomer.admit(); // a hello is a complete message; one of Java has begun
            }
        }
        return admitted;
    }
}
