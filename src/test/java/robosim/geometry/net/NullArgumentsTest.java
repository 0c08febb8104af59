package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Parameter;
import java.net.InetAddress;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongSupplier;
import javax.net.ssl.SSLContext;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.dynamics.VelocityDrive;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Twist;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageTranslator;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.channel.MessageChannel;
import robosim.geometry.protocol.json.JsonRecord;
import robosim.geometry.protocol.json.PeerAdmission;
import robosim.geometry.protocol.pace.MessagePace;
import robosim.geometry.scenario.Recordings;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.ScenarioWriter;
import robosim.geometry.scenario.Step;
import robosim.geometry.scenario.Watching;

/**
 * Every public constructor and method of the protocol, the net and the scenarios, with null for one argument at a time:
 * what may not be null is refused by its name.
 */
class NullArgumentsTest {
    private static final String ROOT = "robosim.geometry.";

    /** Told to the module, or values that it makes for others to read. */
    private static final List<String> NOT_ASKED = List.of(
            "SessionListener",
            "PeerAdmission",
            "WorldLoader",
            "MessagePace",
            "MessageTranslator",
            "StepReader",
            "FiguresMXBean",
            "Lines",
            "Source",
            "Maker",
            "Encoding",
            "ProtocolException");

    /** What the module tells its listeners: that is never null. */
    private static final List<String> TOLD =
            List.of("equals", "main", "requested", "replied", "tried", "answered", "opened");

    private final Map<Class<?>, @Nullable Object> samples = new HashMap<>();

    private static final Step STEP = new Step(new MoveBundle(List.of()), null);

    private Map<Class<?>, @Nullable Object> samples() throws Exception {
        ScenarioHeader header = new ScenarioHeader("title", SessionOptions.ROBOSIM);
        ByteArrayOutputStream lines = new ByteArrayOutputStream();
        ScenarioWriter writer = new ScenarioWriter(lines, header);
        Recordings recordings = Recordings.inFolder(Path.of("nowhere"), SessionOptions.ROBOSIM);
        Object[] all = {
            SessionOptions.ROBOSIM,
            SessionListener.NONE,
            new Session(),
            NetOptions.defaults(),
            Timeouts.DEFAULT,
            Quotas.DEFAULT,
            Access.ANYBODY,
            Redial.DEFAULT,
            InetAddress.getLoopbackAddress(),
            Duration.ofSeconds(1),
            SSLContext.getDefault(),
            new VelocityDrive(Twist.drive(0, 0)),
            Body.of(1, 1),
            Surface.Mixing.MEAN,
            new StepBundle.Answer(List.of(), List.of(), List.of()),
            MessageTranslator.RECORDS,
            MessagePace.NONE,
            PeerAdmission.OPEN,
            new InitBundle(List.of()),
            new MoveBundle(List.of()),
            new DistanceBundle(List.of()),
            new Reply(new MoveBundle(List.of())),
            new MoveRequest("a", 0, 0, 0, 0, 0),
            new SonarRequest("a", 1, 0),
            Beam.LINE,
            new BatchRequestBundle(List.of()),
            new BatchAnswerBundle(List.of()),
            JsonRecord.read("{\"a\":\"b\"}"),
            new MessageChannel(
                    new ByteArrayInputStream(new byte[0]),
                    new ByteArrayOutputStream(),
                    MessageTranslator.RECORDS,
                    MessagePace.NONE,
                    PeerAdmission.OPEN),
            new MessageWriter(new ByteArrayOutputStream()),
            new MessageReader(new ByteArrayInputStream(new byte[0])),
            header,
            writer,
            ScenarioReader.of(new ByteArrayInputStream(lines.toByteArray()), "sample"),
            new Scenario(header, List.of()),
            STEP,
            new Replay(SessionOptions.ROBOSIM),
            recordings,
            new Watching(SessionOptions.ROBOSIM),
            Accuracy.EXACT,
            Dimension.PLANAR,
            new Geometry(10, 10, 10),
            Clock.systemUTC(),
            Path.of("nowhere"),
            (LongSupplier) System::nanoTime,
        };
        for (Object sample : all) {
            samples.put(sample.getClass(), sample);
        }
        return samples;
    }

    private @Nullable Object sample(Class<?> type) {
        if (type == int.class) {
            return 1;
        }
        if (type == long.class) {
            return 1L;
        }
        if (type == double.class) {
            return 1.0;
        }
        if (type == boolean.class) {
            return true;
        }
        if (type == String.class) {
            return "a";
        }
        if (type == List.class) {
            return List.of();
        }
        if (type == Map.class) {
            return Map.of();
        }
        if (type == byte[].class) {
            return new byte[0];
        }
        if (type == char[].class) {
            return new char[0];
        }
        if (type == java.io.InputStream.class) {
            return new ByteArrayInputStream(new byte[0]);
        }
        if (type == java.io.OutputStream.class) {
            return new ByteArrayOutputStream();
        }
        if (type == System.Logger.class) {
            return System.getLogger("nobody");
        }
        if (type == Bundle.class) {
            return new MoveBundle(List.of());
        }
        return samples.entrySet().stream()
                .filter(entry -> type.isAssignableFrom(entry.getKey()))
                .map(Map.Entry::getValue)
                .findFirst()
                .orElseGet(() -> type.isInterface() ? anything(type) : null);
    }

    private static Object anything(Class<?> type) {
        return java.lang.reflect.Proxy.newProxyInstance(
                type.getClassLoader(), new Class<?>[] {type}, (proxy, method, arguments) -> null);
    }

    private static List<Class<?>> publicTypes() throws Exception {
        List<Class<?>> types = new ArrayList<>();
        for (String room : new String[] {
            "protocol", "protocol/channel", "protocol/json", "net", "net/watch", "scenario", "scenario/source"
        }) {
            Path classes = Path.of(
                    Path.of(Session.class
                                    .getProtectionDomain()
                                    .getCodeSource()
                                    .getLocation()
                                    .toURI())
                            .toString(),
                    "robosim",
                    "geometry",
                    room);
            for (File file : classes.toFile().listFiles()) {
                String name = file.getName();
                if (name.endsWith(".class") && !name.equals("package-info.class")) {
                    Class<?> type =
                            Class.forName(ROOT + room.replace('/', '.') + "." + name.substring(0, name.length() - 6));
                    if (isSeen(type) && !NOT_ASKED.contains(type.getSimpleName())) {
                        types.add(type);
                    }
                }
            }
        }
        return types;
    }

    @Test
    void everyNullIsRefusedByItsName() throws Exception {
        samples();
        List<String> wrong = new ArrayList<>();
        int asked = 0;
        for (Class<?> type : publicTypes()) {
            List<Executable> all = new ArrayList<>(List.of(type.getConstructors()));
            for (Method method : type.getDeclaredMethods()) {
                boolean own = Modifier.isPublic(method.getModifiers())
                        && !method.isSynthetic()
                        && !TOLD.contains(method.getName());
                if (own) {
                    all.add(method);
                }
            }
            for (Executable each : all) {
                for (int k = 0; k < each.getParameterCount(); k++) {
                    Parameter parameter = each.getParameters()[k];
                    boolean nullable = each.getAnnotatedParameterTypes()[k].isAnnotationPresent(Nullable.class);
                    if (!parameter.getType().isPrimitive() && !nullable) {
                        asked++;
                        String problem = problem(type, each, k);
                        if (problem != null) {
                            wrong.add(problem);
                        }
                    }
                }
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(asked).isGreaterThan(120);
    }

    /** Null where it was refused as it should be. */
    private @Nullable String problem(Class<?> type, Executable each, int at) throws Exception {
        Object[] arguments = new Object[each.getParameterCount()];
        for (int k = 0; k < arguments.length; k++) {
            arguments[k] = k == at ? null : sample(each.getParameterTypes()[k]);
        }
        String call = type.getSimpleName() + "." + each.getName() + " argument " + at;
        try {
            if (each instanceof Constructor<?> constructor) {
                constructor.newInstance(arguments);
            } else {
                Method method = (Method) each;
                Object target = Modifier.isStatic(method.getModifiers()) ? null : sample(type);
                if (target == null && !Modifier.isStatic(method.getModifiers())) {
                    return null; // nobody but the module makes one
                }
                method.invoke(target, arguments);
            }
            return call + ": taken";
        } catch (InvocationTargetException e) {
            Throwable cause = e.getCause();
            boolean told = cause instanceof IllegalArgumentException
                    && String.valueOf(cause.getMessage()).contains("(got: null)");
            return told ? null : call + ": " + cause;
        } catch (IllegalArgumentException e) {
            throw new IOException(call, e);
        }
    }

    /** Whether other packages can name a class. */
    private static boolean isSeen(Class<?> type) {
        Class<?> outer = type.getEnclosingClass();
        return Modifier.isPublic(type.getModifiers()) && (outer == null || isSeen(outer));
    }
}
