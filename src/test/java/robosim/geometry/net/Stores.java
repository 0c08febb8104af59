package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.util.ArrayList;
import java.util.List;

/** Keys and who trusts them, made when they are needed by the JDK's own tool, so that none expires in a folder. */
final class Stores {
    static final String PASSWORD = "of a test alone";

    private final Path folder;

    /** A module and an environment that trust each other, and a stranger who trusts the module. */
    Stores(Path folder) throws IOException, InterruptedException, GeneralSecurityException {
        this.folder = folder;
        for (String who : List.of("module", "environment", "stranger")) {
            make(who, "-0d");
        }
        trust("module", "environment");
        trust("environment", "module");
        trust("stranger", "module");
    }

    /** A key of that name, which is valid for two days from a start as in {@code +1d}. */
    void make(String who, String start) throws IOException, InterruptedException {
        keytool(
                who + ".p12",
                "-genkeypair",
                "-alias",
                who,
                "-keyalg",
                "EC",
                "-groupname",
                "secp256r1",
                "-startdate",
                start,
                "-validity",
                "2",
                "-dname",
                "CN=" + who,
                "-ext",
                "SAN=ip:127.0.0.1,dns:localhost");
    }

    /** A store of the certificates that somebody trusts. */
    void trust(String who, String... others) throws IOException, GeneralSecurityException {
        char[] password = PASSWORD.toCharArray();
        KeyStore trusts = KeyStore.getInstance("PKCS12");
        trusts.load(null, password);
        for (String whom : others) {
            trusts.setCertificateEntry(
                    whom,
                    KeyStore.getInstance(path(whom + ".p12").toFile(), password).getCertificate(whom));
        }
        try (OutputStream out = Files.newOutputStream(path(who + "-trusts.p12"))) {
            trusts.store(out, password);
        }
    }

    private void keytool(String store, String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "keytool").toString());
        command.addAll(List.of(arguments));
        command.addAll(List.of(
                "-J-XX:TieredStopAtLevel=1",
                "-J-XX:+UseSerialGC",
                "-storetype",
                "PKCS12",
                "-storepass",
                PASSWORD,
                "-keystore",
                path(store).toString()));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        process.getOutputStream().close();
        String said = new String(process.getInputStream().readAllBytes(), java.nio.charset.StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(said).isZero();
    }

    Path path(String store) {
        return folder.resolve(store);
    }

    Tls of(String who) {
        char[] password = PASSWORD.toCharArray();
        return Tls.load(path(who + ".p12"), password, path(who + "-trusts.p12"), password);
    }
}
