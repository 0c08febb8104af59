package robosim.geometry.cases;

import java.util.Arrays;
import java.util.Map;
import java.util.stream.Collectors;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** The questions that are about more than one answer: refusals, many turns, scans. */
final class Oddities {
    private Oddities() {}

    /** The message with which a value is refused, or that it was not. */
    static String refusal(HardCase.Refusal question) {
        Map<String, Object> shape = question.shape();
        try {
            if (shape.containsKey("ray")) {
                double[] r = ShapeReader.numbers(shape.get("ray"));
                new Geometry().castRay(new Ray(new Point(r[0], r[1], r[2]), new Point(r[3], r[4], r[5])), 1);
            } else if (shape.containsKey("move")) {
                double[] m = ShapeReader.numbers(shape.get("move"));
                Geometry world = new Geometry();
                world.addObject(new BoxObject(new Point(), 1, 1, 1).moveable("robot"));
                world.move("robot", new Move(m[0], m[1], m[2], m[3], m[4]));
            } else {
                return "accepted: " + new ShapeReader(false).object(shape);
            }
        } catch (IllegalArgumentException e) {
            return String.valueOf(e.getMessage());
        }
        return "accepted";
    }

    static boolean refuses(HardCase.Refusal question) {
        String message = refusal(question);
        return message.contains("(got: ") && message.startsWith(question.truth());
    }

    static double heading(HardCase.Spin question) {
        Geometry world = new Geometry();
        world.addObject(
                new BoxObject(new Point(), 1, 1, 1).turned(0, question.start()).moveable("robot"));
        for (int k = 0; k < question.times(); k++) {
            if (!world.simpleTurn("robot", question.degrees())) {
                throw new IllegalStateException("nothing stands in the way of the turn");
            }
        }
        return world.getObject("robot").heading();
    }

    static String scan(HardCase hard, HardCase.Scan question, Variant variant) {
        GeometryObject scanner = variant.place(hard.object(question.scanner())).moveable("scanner");
        Geometry world = Trial.world(
                variant.dimension(),
                hard.objects().values().stream().map(variant::place).toList(),
                Truth.size(scanner));
        world.addObjectUnchecked(scanner);
        for (GeometryObject object : hard.objects(question.of())) {
            world.addObjectUnchecked(variant.place(object));
        }
        double max = question.max() * variant.scale();
        return Arrays.stream(world.scan("scanner", question.first(), question.step(), question.count(), 0, max))
                .mapToObj(Trial::text)
                .collect(Collectors.joining(" "));
    }

    /** Whether each ray of a scan sees what the file says, at the scale of the variant. */
    static boolean sees(HardCase.Scan question, Variant variant, String ours) {
        String[] answers = ours.split(" ");
        String[] truths = question.truth().split("\\s+");
        boolean right = answers.length == truths.length;
        for (int k = 0; right && k < truths.length; k++) {
            if (truths[k].equals("miss") || answers[k].equals("miss")) {
                right = truths[k].equals(answers[k]);
            } else {
                double truth = Double.parseDouble(truths[k]) * variant.scale();
                double moved = Truth.size(Trial.point(variant.offset()));
                double allowed = question.within() * variant.scale() + 8 * Math.ulp(Math.max(moved, truth));
                right = Math.abs(Double.parseDouble(answers[k]) - truth) <= allowed;
            }
        }
        return right;
    }
}
