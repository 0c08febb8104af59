package robosim.geometry.net;

import java.io.IOException;
import java.net.Socket;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLParameters;
import javax.net.ssl.SSLPeerUnverifiedException;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManagerFactory;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;

/**
 * TLS 1.3 or 1.2 in which both ends present a certificate, which must be valid at the time. Java does not check the dates
 * of a certificate that is itself in the trust store; here they are checked in every case.
 */
public final class Tls {
    private static final String[] VERSIONS = {"TLSv1.3", "TLSv1.2"};

    private final SSLContext context;

    private Tls(SSLContext context) {
        this.context = context;
    }

    /** TLS with the keys and trust of a given context. */
    public static Tls of(SSLContext context) {
        return new Tls(Checks.present("context", context));
    }

    /**
     * TLS with the key and certificate of one store and the trusted certificates of another; PKCS #12 or JKS. The
     * caller may overwrite the passwords afterwards.
     *
     * @param keyStore      contains this end's key with its certificate
     * @param trustStore    contains the certificates of the peers, or of their issuers, and no others
     * @param trustPassword null to trust a store whose integrity is not checked
     * @throws IllegalArgumentException if a store cannot be read with its password
     */
    public static Tls load(Path keyStore, char[] keyPassword, Path trustStore, char @Nullable [] trustPassword) {
        Checks.present("keyStore", keyStore);
        Checks.present("keyPassword", keyPassword);
        Checks.present("trustStore", trustStore);
        try {
            KeyManagerFactory keys = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
            keys.init(store("keyStore", keyStore, keyPassword), keyPassword);
            TrustManagerFactory trust = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
            trust.init(store("trustStore", trustStore, trustPassword));
            SSLContext context = SSLContext.getInstance("TLS");
            context.init(keys.getKeyManagers(), trust.getTrustManagers(), null);
            return new Tls(context);
        } catch (GeneralSecurityException e) {
            throw new IllegalArgumentException("the key of " + keyStore + " cannot be used: " + e.getMessage(), e);
        }
    }

    @SuppressWarnings("NullAway") // KeyStore takes null for no password
    private static KeyStore store(String argument, Path file, char @Nullable [] password) {
        try {
            return KeyStore.getInstance(Checks.present(argument, file).toFile(), password);
        } catch (IOException | GeneralSecurityException | IllegalArgumentException e) {
            throw new IllegalArgumentException(
                    argument + " must be a key store that its password opens (got: " + file + ", " + e.getMessage()
                            + ")",
                    e);
        }
    }

    /** The server's side of TLS, over a connected socket. */
    SSLSocket accept(Socket plain) throws IOException {
        SSLSocket socket = (SSLSocket) context.getSocketFactory().createSocket(plain, null, true);
        SSLParameters parameters = parameters();
        parameters.setNeedClientAuth(true);
        socket.setUseClientMode(false);
        socket.setSSLParameters(parameters);
        return socket;
    }

    /** The client's side of TLS, which requires a certificate for the given host. */
    SSLSocket dial(Socket plain, String host, int port) throws IOException {
        SSLSocket socket = (SSLSocket) context.getSocketFactory().createSocket(plain, host, port, true);
        SSLParameters parameters = parameters();
        parameters.setEndpointIdentificationAlgorithm("HTTPS");
        socket.setSSLParameters(parameters);
        return socket;
    }

    /** Why the peer's certificate cannot be used now, after the handshake; null if it can. */
    static @Nullable String refusal(SSLSocket agreed) throws SSLPeerUnverifiedException {
        if (!(agreed.getSession().getPeerCertificates()[0] instanceof X509Certificate leaf)) {
            return "the peer's certificate must be an X.509 certificate (got: another kind)";
        }
        try {
            leaf.checkValidity();
            return null;
        } catch (CertificateException e) {
            return "the peer's certificate must be valid now (got: " + leaf.getSubjectX500Principal() + ", valid from "
                    + leaf.getNotBefore().toInstant() + " to "
                    + leaf.getNotAfter().toInstant() + ")";
        }
    }

    private static SSLParameters parameters() {
        SSLParameters parameters = new SSLParameters();
        parameters.setProtocols(VERSIONS.clone());
        return parameters;
    }
}
