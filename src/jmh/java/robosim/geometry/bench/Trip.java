package robosim.geometry.bench;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * Moves and turns of a world's robots as they were asked once, with exact verdicts: the same questions again and again,
 * whatever is answered. A robot that an answer has led elsewhere is put back every few questions.
 */
final class Trip {
    private static final int ROUNDS = 200;
    private static final int LEG = 50;

    /** One question and where its robot stood; a way of 0 is a turn. */
    private record Question(String robot, double way, double degrees, Point center, double heading) {
        String text() {
            return String.join(
                    ";",
                    robot,
                    "" + way,
                    "" + degrees,
                    "" + center.x(),
                    "" + center.y(),
                    "" + center.z(),
                    "" + heading);
        }

        static Question of(String text) {
            String[] parts = text.split(";", -1);
            double[] numbers = new double[6];
            for (int k = 0; k < 6; k++) {
                numbers[k] = Double.parseDouble(parts[1 + k]);
            }
            Point center = new Point(numbers[2], numbers[3], numbers[4]);
            return new Question(parts[0], numbers[0], numbers[1], center, numbers[5]);
        }
    }

    private final Geometry geometry;
    private final List<Question> questions;
    private long strayed;

    private Trip(Geometry geometry, List<Question> questions) {
        this.geometry = geometry;
        this.questions = questions;
    }

    /** Lets robots go ahead, turn where they are refused, and back where there is no room for that either. */
    static List<String> record(Geometry geometry) {
        List<String> robots = geometry.objects().stream()
                .filter(GeometryObject::isMoveable)
                .map(GeometryObject::name)
                .toList();
        SplittableRandom random = new SplittableRandom(4);
        List<String> asked = new ArrayList<>();
        for (int round = 0; round < ROUNDS; round++) {
            for (String robot : robots) {
                double way = random.nextDouble(0.04, 0.06);
                if (!ask(geometry, robot, way, 0, asked)
                        && !ask(geometry, robot, 0, random.nextDouble(-90, 90), asked)) {
                    ask(geometry, robot, -way, 0, asked);
                }
            }
        }
        return asked;
    }

    private static boolean ask(Geometry geometry, String robot, double way, double degrees, List<String> asked) {
        GeometryObject now = geometry.getObject(robot);
        Question question = new Question(robot, way, degrees, now.center(), now.heading());
        asked.add(question.text());
        return answer(geometry, question);
    }

    private static boolean answer(Geometry geometry, Question question) {
        return question.way == 0
                ? geometry.simpleTurn(question.robot, question.degrees)
                : geometry.simpleMove(question.robot, question.way, 0, 0);
    }

    /** A trip recorded in a world that looks the same. */
    static Trip of(Geometry geometry, List<String> asked) {
        return new Trip(geometry, asked.stream().map(Question::of).toList());
    }

    int legs() {
        return (questions.size() + LEG - 1) / LEG;
    }

    /** Puts the robots where they stood at the beginning of a leg. */
    void prepare(int leg) {
        boolean moved = true;
        boolean astray = true;
        // One may stand where another has to.
        for (int pass = 0; moved && astray && pass < questions.size(); pass++) {
            moved = false;
            astray = false;
            Set<String> seen = new HashSet<>();
            for (Question question : leg(leg)) {
                GeometryObject now = geometry.getObject(question.robot);
                if (seen.add(question.robot)
                        && !(now.center().equals(question.center) && now.heading() == question.heading)) {
                    boolean placed = geometry.placeObject(question.robot, question.center, question.heading);
                    moved |= placed;
                    astray |= !placed;
                }
            }
        }
        strayed += astray ? 1 : 0;
    }

    /** Legs that began with a robot elsewhere, as a wrong verdict refused its place. */
    long strayed() {
        return strayed;
    }

    /** Asks the questions of a leg and answers how many. */
    int ask(int leg) {
        List<Question> part = leg(leg);
        for (Question question : part) {
            answer(geometry, question);
        }
        return part.size();
    }

    private List<Question> leg(int leg) {
        return questions.subList(leg * LEG, Math.min(questions.size(), (leg + 1) * LEG));
    }
}
