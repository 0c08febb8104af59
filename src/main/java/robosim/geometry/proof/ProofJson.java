package robosim.geometry.proof;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.stream.Collectors;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * Proofs and scenes as JSON, for programs in other languages: {@code docs/proofs.md} describes the form. Numbers are written such that
 * reading them as doubles gives the same bits; a number that is infinite is null.
 */
final class ProofJson {
    /** A number of so few letters has 15 digits at most, and no two decimals of so few are the same double. */
    private static final int MOST_SURE = 16;

    private ProofJson() {}

    /** A proof together with the scene that it is about, as one object. */
    static String of(Proof proof, Scene scene) {
        return "{\"scene\":" + of(scene) + ",\"proof\":" + of(proof) + "}";
    }

    /** The pieces of a scene, as the numbers that are stored. */
    static String of(Scene scene) {
        Checks.present("scene", scene);
        Point size = scene.size();
        StringBuilder text = new StringBuilder("{\"dimension\":\"").append(scene.dimension());
        text.append("\",\"size\":").append(size == null ? "null" : point(size)).append(",\"objects\":[");
        for (int k = 0; k < scene.objects().size(); k++) {
            text.append(k == 0 ? "" : ",").append(object(scene.objects().get(k)));
        }
        return text.append("]}").toString();
    }

    private static String object(GeometryObject object) {
        List<int[]> solids = ScenePieces.solids(object, 0);
        return "{\"pieces\":["
                + Piece.stored(object).stream().map(ProofJson::numbers).collect(Collectors.joining(","))
                + "],\"solids\":["
                + solids.stream().map(s -> "[" + s[0] + "," + s[1] + "]").collect(Collectors.joining(","))
                + "],\"center\":" + point(object.center()) + "}";
    }

    private static String numbers(double[] row) {
        StringBuilder text = new StringBuilder("[");
        for (double v : row) {
            text.append(text.length() > 1 ? "," : "").append(number(v));
        }
        return text.append("]").toString();
    }

    /** A proof; it is about a scene that is given elsewhere. */
    static String of(Proof proof) {
        return "{\"claim\":" + claim(Checks.present("proof", proof).claim()) + ",\"witness\":"
                + witness(proof.witness()) + "}";
    }

    private static String claim(Claim claim) {
        if (claim instanceof Claim.Apart c) {
            return body("apart", c.body()) + ",\"self\":" + c.self() + ",\"other\":" + c.other() + touched(c.touched());
        } else if (claim instanceof Claim.Touching c) {
            return body("touching", c.body()) + ",\"other\":" + c.other() + "}";
        } else if (claim instanceof Claim.Distance c) {
            return body("distance", c.body()) + ",\"self\":" + c.self() + ",\"other\":" + c.other()
                    + range(c.low(), c.high());
        } else if (claim instanceof Claim.Translation c) {
            return body("translation", c.body()) + ",\"self\":" + c.self() + ",\"displacement\":"
                    + point(c.displacement()) + ",\"free\":" + number(c.free()) + touched(c.touched());
        } else if (claim instanceof Claim.Blocked c) {
            return body("blocked", c.body()) + ",\"self\":" + c.self() + ",\"displacement\":" + point(c.displacement())
                    + ",\"free\":" + number(c.free()) + ",\"at\":" + number(c.at()) + ",\"other\":" + c.other()
                    + touched(c.touched());
        } else if (claim instanceof Claim.Turn c) {
            return body("turn", c.body()) + ",\"self\":" + c.self() + ",\"axis\":" + point(c.axis()) + ",\"tangent\":"
                    + number(c.tangent()) + touched(c.touched());
        } else if (claim instanceof Claim.Ray c) {
            return "{\"kind\":\"ray\"" + beam(c.start(), c.direction()) + ",\"self\":" + c.self() + ",\"other\":"
                    + c.other() + range(c.low(), c.high());
        }
        Claim.Cone c = (Claim.Cone) claim;
        return "{\"kind\":\"cone\"" + beam(c.start(), c.direction()) + ",\"cosine\":" + number(c.cosine())
                + ",\"self\":" + c.self() + ",\"other\":" + c.other() + range(c.low(), c.high());
    }

    private static String body(String kind, GeometryObject body) {
        return "{\"kind\":\"" + kind + "\",\"body\":" + object(body);
    }

    private static String beam(Point start, Point direction) {
        return ",\"start\":" + point(start) + ",\"direction\":" + point(direction);
    }

    private static String range(double low, double high) {
        return ",\"low\":" + number(low) + ",\"high\":" + number(high) + "}";
    }

    private static String touched(List<Integer> touched) {
        return ",\"touched\":" + integers(touched) + "}";
    }

    private static String witness(Witness w) {
        Witness.Contact contact = w.contact();
        String common = w.common().stream().map(ProofJson::point).collect(Collectors.joining(","));
        String slabs = w.slabs().stream().map(ProofJson::slab).collect(Collectors.joining(","));
        String outsides = w.outsides().stream().map(ProofJson::outside).collect(Collectors.joining(","));
        return "{\"common\":[" + common + "],\"slabs\":[" + slabs + "],\"contact\":"
                + (contact == null ? "null" : contact(contact)) + ",\"outsides\":[" + outsides + "],\"reach\":"
                + number(w.reach()) + "}";
    }

    private static String slab(Witness.Slab s) {
        Point n = s.normal();
        return numbers(new double[] {s.from(), s.to(), n.x(), n.y(), n.z(), s.along()})
                .replaceFirst("\\[", "[" + s.mine() + "," + s.theirs() + ",");
    }

    private static String outside(Witness.Outside o) {
        return "[" + o.mine() + "," + o.theirs() + "," + o.isTheirsSolid() + "," + point(o.direction()) + "]";
    }

    private static String contact(Witness.Contact c) {
        String anchors = c.anchors().stream()
                .map(a -> "[" + point(a.at()) + "," + point(a.offset()) + "]")
                .collect(Collectors.joining(","));
        return "{\"mine\":" + c.mine() + ",\"theirs\":" + c.theirs() + ",\"form\":\"" + c.form() + "\",\"corners\":"
                + integers(c.corners()) + ",\"point\":" + point(c.point()) + ",\"anchors\":[" + anchors + "]}";
    }

    private static String integers(List<Integer> list) {
        return list.stream().map(String::valueOf).collect(Collectors.joining(",", "[", "]"));
    }

    private static String point(Point p) {
        return numbers(new double[] {p.x(), p.y(), p.z()});
    }

    private static String number(double v) {
        return v == Double.POSITIVE_INFINITY
                ? "null"
                : v == Math.rint(v) && Math.abs(v) < 1e9 ? String.valueOf((long) v) : fraction(v);
    }

    /** Digits that identify a double, the same on every JVM: {@link Double#toString} of some has more than it needs. */
    private static String fraction(double v) {
        String usual = String.valueOf(v);
        if (usual.length() <= MOST_SURE) {
            return usual;
        }
        BigDecimal exact = new BigDecimal(v);
        String rounded = "";
        for (int digits = 15; digits <= 17 && (rounded.isEmpty() || Double.parseDouble(rounded) != v); digits++) {
            rounded = exact.round(new MathContext(digits)).toString();
        }
        return rounded;
    }
}
