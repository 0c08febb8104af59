package robosim.geometry.net;

import java.net.InetAddress;
import org.jspecify.annotations.Nullable;

/** Who may connect. On any address but loopback, a server requires TLS, a secret, or both. */
final class Access {
    /** No authentication, for the loopback address. */
    static final Access ANYBODY = of(null, null);

    private final @Nullable Tls tls;
    private final @Nullable Secret secret;

    private Access(@Nullable Tls tls, @Nullable Secret secret) {
        this.tls = tls;
        this.secret = secret;
    }

    /** Access by TLS, a secret, or both. */
    static Access of(@Nullable Tls tls, char @Nullable [] secret) {
        return new Access(tls, secret == null ? null : Secret.of(secret));
    }

    /** Null for plain connections. */
    @Nullable
    Tls tls() {
        return tls;
    }

    boolean hasSecret() {
        return secret != null;
    }

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
