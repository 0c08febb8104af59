package robosim.geometry.docs;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ExpressionStatementTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.SourcePositions;
import com.sun.source.util.TreeScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.net.URI;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;

/**
 * A block of Java as a program: imports before it, statements in a method, members in a class; behind each statement whose
 * comment begins with a value, that value is compared.
 */
final class Snippet {
    private static final String IMPORTS = """
            import java.io.*;
            import java.net.*;
            import java.nio.file.*;
            import java.time.*;
            import java.util.*;
            import java.util.random.*;
            import java.util.stream.*;
            import robosim.geometry.*;
            import robosim.geometry.collision.*;
            import robosim.geometry.material.*;
            import robosim.geometry.dynamics.*;
            import robosim.geometry.model.*;
            import robosim.geometry.net.*;
            import robosim.geometry.proof.*;
            import robosim.geometry.protocol.*;
            import robosim.geometry.scenario.*;
            import robosim.geometry.render.*;
            import robosim.geometry.sensor.*;
            import robosim.geometry.sweep.*;
            import robosim.geometry.world.*;
            """;
    private static final String TESTS = """
            import static org.junit.jupiter.api.Assertions.*;
            import org.junit.jupiter.api.*;
            import robosim.geometry.junit.*;
            """;
    private static final Pattern TYPE =
            Pattern.compile("\\A(?:\\s|//.*\\n|/\\*(?s:.*?)\\*/|@\\w+(?:\\([^)]*\\))?|public |final |abstract )*"
                    + "(?:class|interface|record|enum) (\\w+)");
    private static final Pattern MEMBER = Pattern.compile(
            "\\A(?:\\s|//.*\\n)*(?:@\\w+|(?:public |private |static )*[\\w<>\\[\\], ]+ \\w+\\([^)]*\\)[^;{=]*\\{)");

    /** What a block is. */
    enum Shape {
        TYPE,
        MEMBERS,
        STATEMENTS
    }

    private final Block block;
    final Shape shape;
    final String className;
    final String source;
    final boolean isTest;

    /** A block with the blocks that it continues before it. */
    Snippet(Block block, String before) throws IOException {
        this.block = block;
        // A class that is gone on with stands beside the statements, in their file.
        boolean isBesideType = TYPE.matcher(before).find();
        StringBuilder imports = new StringBuilder();
        StringBuilder code = new StringBuilder();
        ((isBesideType ? "" : before) + block.code()).lines().forEach(line -> {
            (line.startsWith("import ") ? imports : code).append(line).append('\n');
        });
        String text = code.toString();
        String beside = isBesideType ? before.replaceFirst("(?m)^public ", "") : "";
        Matcher type = TYPE.matcher(text);
        isTest = Pattern.compile("@(?:Test|ScenarioTest|TestFactory|World)\\b|RobotWorld")
                .matcher(text)
                .find();
        // Two packages have a World: that of files, and the annotation.
        String world = "import robosim.geometry." + (text.contains("@World") ? "junit" : "world") + ".World;\n";
        String all = imports + IMPORTS + (isTest ? TESTS : "") + world;
        if (type.find()) {
            shape = Shape.TYPE;
            className = type.group(1);
            source = all + text;
        } else if (MEMBER.matcher(text).find()) {
            shape = Shape.MEMBERS;
            className = "Snippet";
            source = all + "class Snippet {\n" + text + "}\n";
        } else {
            shape = Shape.STATEMENTS;
            className = "Snippet";
            source = checked(all + beside + "public class Snippet {\npublic static void run("
                    + block.given().orElse("") + ") throws Exception {\n" + text + "}\n}\n");
        }
    }

    /** The source with a comparison behind each statement that states its value. */
    private String checked(String text) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        JavacTask task = (JavacTask) compiler.getTask(
                null, null, new DiagnosticCollector<>(), List.of("-proc:none"), null, List.of(file("Snippet", text)));
        CompilationUnitTree unit = task.parse().iterator().next();
        SourcePositions positions = Trees.instance(task).getSourcePositions();
        Map<Integer, String> edits = new TreeMap<>(java.util.Comparator.reverseOrder()); // from the end on
        new TreeScanner<Void, Void>() {
            @Override
            public Void visitExpressionStatement(ExpressionStatementTree node, Void nothing) {
                String stated = stated(node);
                if (stated != null) {
                    edits.put((int) positions.getEndPosition(unit, node.getExpression()), ")");
                    edits.put((int) positions.getStartPosition(unit, node), check(stated));
                }
                return super.visitExpressionStatement(node, nothing);
            }

            @Override
            public Void visitVariable(VariableTree node, Void nothing) {
                String stated = stated(node);
                if (stated != null) {
                    edits.put((int) positions.getEndPosition(unit, node), check(stated) + node.getName() + ");");
                }
                return super.visitVariable(node, nothing);
            }

            private String stated(Tree node) {
                int end = (int) positions.getEndPosition(unit, node);
                if (end < 0) {
                    return null; // as of what javac made up behind a fault
                }
                Matcher value = Stated.VALUE.matcher(
                        text.substring(end).lines().findFirst().orElse(""));
                return value.find() ? value.group(1) : null;
            }

            private String check(String stated) {
                return "robosim.geometry.docs.Stated.check(\"" + block.place() + "\", \""
                        + stated.replace("\\", "\\\\").replace("\"", "\\\"") + "\", ";
            }
        }.scan(unit, null);
        StringBuilder edited = new StringBuilder(text);
        edits.forEach(edited::insert);
        return edited.toString();
    }

    JavaFileObject file() {
        return file(className, source);
    }

    private static JavaFileObject file(String name, String text) {
        return new SimpleJavaFileObject(URI.create("string:///" + name + ".java"), JavaFileObject.Kind.SOURCE) {
            @Override
            public CharSequence getCharContent(boolean ignoreEncodingErrors) {
                return text;
            }
        };
    }
}
