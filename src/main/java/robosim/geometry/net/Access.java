package robosim.geometry.net;

import java.net.InetAddress;
import org.jspecify.annotations.Nullable;

/**
 * Who gets in. Off the loopback address a server wants at least one of the two.
 *
 * @param tls    with it every connection is TLS, and both ends show a certificate that the other trusts; null without
 * @param secret with it a peer that speaks JSON must show it in its hello, and one that speaks Java serialization, which
 *               has no place for it, is served over TLS alone; null without
 */
public record Access(@Nullable Tls tls, @Nullable Secret secret) {
    /** Nobody is asked who he is: for the loopback address. */
    public static final Access ANYBODY = new Access(null, null);

    /**
     * Refuses to listen where strangers can dial and nothing would keep them out.
     *
     * @throws IllegalArgumentException saying what would
     */
    void check(InetAddress address) {
        if (tls == null && secret == null && !address.isLoopbackAddress()) {
            throw new IllegalArgumentException(
                    "a server off the loopback address must know who dials in: give it TLS with"
                            + " the certificates that it trusts, or a secret for peers that speak JSON; or let a GeometryClient"
                            + " dial the environment (got: " + address.getHostAddress() + " with neither)");
        }
    }

    /** Whether a peer that speaks JSON and shows that secret, or null for none, may go on. */
    boolean admitsJson(@Nullable String offered) {
        return secret == null || secret.matches(offered);
    }

    /** Whether a peer may speak Java serialization. */
    boolean admitsJava() {
        return tls != null || secret == null;
    }
}
