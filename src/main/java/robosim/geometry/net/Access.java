package robosim.geometry.net;

import java.net.InetAddress;
import org.jspecify.annotations.Nullable;

/**
 * Who may connect. On any address but loopback, a server requires TLS, a secret, or both.
 *
 * @param tls    if not null, every connection uses TLS, and each end presents a certificate that the other trusts
 * @param secret if not null, a peer that speaks JSON must present it in its hello; a peer that speaks Java
 *               serialization, which has no place for it, is then served over TLS only
 */
public record Access(@Nullable Tls tls, @Nullable Secret secret) {
    /** No authentication, for the loopback address. */
    public static final Access ANYBODY = new Access(null, null);

    /** Refuses an address that other machines can reach unless something keeps strangers out. */
    void check(InetAddress address) {
        if (tls == null && secret == null && !address.isLoopbackAddress()) {
            throw new IllegalArgumentException(
                    "a server on any address but loopback must authenticate its peers: give it TLS with the"
                            + " certificates that it trusts, or a secret for peers that speak JSON; or let a"
                            + " GeometryClient dial the environment (got: " + address.getHostAddress()
                            + " with neither)");
        }
    }

    /** Whether a peer that speaks JSON and presents this secret, null for none, is admitted. */
    boolean admitsJson(@Nullable String offered) {
        return secret == null || secret.matches(offered);
    }

    /** Whether a peer may speak Java serialization. */
    boolean admitsJava() {
        return tls != null || secret == null;
    }
}
