package robosim.geometry.net;

import java.nio.CharBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;

/** A secret that peers must know. Only its digest is kept, and it is never printed. */
final class Secret {
    /** A shorter secret could be found by trial. */
    private static final int SHORTEST = 16;

    private final byte[] digest;

    private Secret(byte[] digest) {
        this.digest = digest;
    }

    /**
     * Makes a secret; keeps only its digest.
     *
     * @param letters at least 16; the caller may overwrite them afterwards
     */
    public static Secret of(char[] letters) {
        Checks.present("letters", letters);
        Checks.refuse(
                letters.length < SHORTEST, "a secret must have at least " + SHORTEST + " letters", letters.length);
        return new Secret(digest(CharBuffer.wrap(letters)));
    }

    /** Whether this is the secret; takes the same time wherever the two first differ. */
    boolean matches(@Nullable String offered) {
        return MessageDigest.isEqual(digest, digest(CharBuffer.wrap(offered == null ? "" : offered)));
    }

    private static byte[] digest(CharBuffer letters) {
        try {
            MessageDigest sha = MessageDigest.getInstance("SHA-256");
            sha.update(StandardCharsets.UTF_8.encode(letters));
            return sha.digest();
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    @Override
    public String toString() {
        return "a secret";
    }
}
