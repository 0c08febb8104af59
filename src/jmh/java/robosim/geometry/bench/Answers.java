package robosim.geometry.bench;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import robosim.geometry.Geometry;
import robosim.geometry.bench.Questions.Family;
import robosim.geometry.bench.Questions.Subject;
import robosim.geometry.narrow.leaf.LeafKind;

/** The answers to many {@link Questions}, of this JVM or of another that is started with the same classes. */
public final class Answers {
    private Answers() {}

    /** So many answers of each family, one family after the other. */
    public static double[] here(List<Family> families, long seed, int count) {
        double[] answers = new double[families.size() * count];
        Questions questions = new Questions();
        int n = 0;
        for (Family family : families) {
            for (int k = 0; k < count; k++) {
                questions.make(family, seed, k);
                answers[n++] = questions.ask();
            }
        }
        return answers;
    }

    /** The same answers of a JVM with further options, as {@code -D}. */
    public static double[] forked(List<String> options, List<Family> families, long seed, int count)
            throws IOException {
        Path file = Files.createTempFile("answers", ".bin");
        try {
            List<String> arguments = new ArrayList<>(List.of(file.toString(), Long.toString(seed), "" + count));
            families.forEach(family -> arguments.add(text(family)));
            String said = run(options, Answers.class, arguments);
            double[] answers = new double[families.size() * count];
            try (DataInputStream in = new DataInputStream(new BufferedInputStream(Files.newInputStream(file)))) {
                for (int k = 0; k < answers.length; k++) {
                    answers[k] = in.readDouble();
                }
            } catch (IOException e) {
                throw new IOException(said, e);
            }
            return answers;
        } finally {
            Files.delete(file);
        }
    }

    /** Runs a program in a JVM of its own, with the classes of this one, and answers all that it says. */
    public static String run(List<String> options, Class<?> program, List<String> arguments) throws IOException {
        return run(Path.of(System.getProperty("java.home"), "bin", "java"), options, program, arguments);
    }

    static String run(Path java, List<String> options, Class<?> program, List<String> arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(java.toString(), "-cp", classPath()));
        command.addAll(options);
        command.add(program.getName());
        command.addAll(arguments);
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }

    /** Where these classes and the product's lie. */
    static String classPath() {
        return ClassPath.of(Answers.class, Geometry.class);
    }

    private static String text(Family family) {
        return family.subject() + ":" + family.planar() + ":" + family.kindA() + ":" + family.kindB();
    }

    private static Family family(String text) {
        String[] parts = text.split(":", -1);
        return new Family(
                Subject.valueOf(parts[0]),
                Boolean.parseBoolean(parts[1]),
                LeafKind.valueOf(parts[2]),
                LeafKind.valueOf(parts[3]));
    }

    /** Writes the answers to a file: its name, the seed, how many of each family, the families. */
    public static void main(String[] args) throws IOException {
        List<Family> families = Arrays.stream(args).skip(3).map(Answers::family).toList();
        double[] answers = here(families, Long.parseLong(args[1]), Integer.parseInt(args[2]));
        try (DataOutputStream out =
                new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(new File(args[0]).toPath())))) {
            for (double answer : answers) {
                out.writeDouble(answer);
            }
        }
    }
}
