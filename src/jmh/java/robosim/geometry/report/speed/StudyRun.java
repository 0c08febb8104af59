package robosim.geometry.report.speed;

import java.io.IOException;

/** Runs one study in this JVM and prints its figures as lines, and how far it is behind at signs. */
public final class StudyRun {
    static final String PROGRESS = "@";

    private StudyRun() {}

    /**
     * Runs a study.
     *
     * @param args the study's name and the form's
     */
    public static void main(String[] args) throws IOException {
        Study.of(args[0])
                .run(
                        Form.of(args[1]),
                        (subject, scene, query, metric, value) ->
                                System.out.println(new Measure(args[0], subject, scene, query, metric, value).line()),
                        share -> System.out.println(PROGRESS + share));
    }
}
