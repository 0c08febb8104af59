package robosim.geometry.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.lang.reflect.InvocationTargetException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;
import javax.tools.ToolProvider;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.discovery.DiscoverySelectors;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;

/** Compiles and runs snippets. */
final class SnippetRunner {
    private static final JavaCompiler COMPILER = ToolProvider.getSystemJavaCompiler();

    /** One for all snippets: it keeps the jars of the class path open. */
    private static final StandardJavaFileManager FILES =
            COMPILER.getStandardFileManager(null, null, StandardCharsets.UTF_8);

    private SnippetRunner() {}

    /** Compiles a snippet into a folder; throws what the compiler says. */
    static void compile(Block block, Snippet snippet, Path into) {
        DiagnosticCollector<JavaFileObject> said = new DiagnosticCollector<>();
        try {
            FILES.setLocationFromPaths(StandardLocation.CLASS_OUTPUT, List.of(into));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        List<String> options = List.of("-proc:none", "-nowarn");
        if (!COMPILER.getTask(null, FILES, said, options, null, List.of(snippet.file()))
                .call()) {
            List<String> lines = snippet.source.lines().toList();
            throw new AssertionError(said.getDiagnostics().stream()
                    .map(each -> block.place() + ": " + each.getMessage(null) + "\n  in: "
                            + lines.get((int) Math.max(0, Math.min(lines.size(), each.getLineNumber()) - 1))
                                    .strip())
                    .collect(Collectors.joining("\n")));
        }
    }

    /** Runs statements, a main method or JUnit's tests, and throws what they throw. */
    static void run(Block block, Snippet snippet, Path compiled) throws Throwable {
        PrintStream out = System.out;
        try (URLClassLoader loader =
                new URLClassLoader(new URL[] {compiled.toUri().toURL()}, SnippetRunner.class.getClassLoader())) {
            System.setOut(new PrintStream(OutputStream.nullOutputStream()));
            Class<?> type = loader.loadClass(snippet.className);
            if (snippet.isTest && snippet.shape != Snippet.Shape.STATEMENTS) {
                runTests(block, type);
            } else if (snippet.shape == Snippet.Shape.STATEMENTS) {
                type.getMethod("run").invoke(null);
            }
        } catch (InvocationTargetException e) {
            throw new AssertionError(block.place() + ": " + e.getCause(), e.getCause());
        } finally {
            System.setOut(out);
        }
    }

    private static void runTests(Block block, Class<?> type) {
        List<TestExecutionResult> results = new ArrayList<>();
        LauncherFactory.create()
                .execute(
                        LauncherDiscoveryRequestBuilder.request()
                                .selectors(DiscoverySelectors.selectClass(type))
                                .build(),
                        new TestExecutionListener() {
                            @Override
                            public void executionFinished(TestIdentifier test, TestExecutionResult result) {
                                if (test.isTest() || result.getThrowable().isPresent()) {
                                    results.add(result);
                                }
                            }
                        });
        assertThat(results).as("tests in %s", block.place()).isNotEmpty();
        results.forEach(result -> result.getThrowable().ifPresent(thrown -> {
            throw new AssertionError(block.place() + ": " + thrown.getMessage(), thrown);
        }));
    }

    /** Compiles a block, and runs it unless it says otherwise. */
    static void check(Block block, String before, Path folder) throws Throwable {
        Snippet snippet = snippet(block, before);
        compile(block, snippet, folder);
        if (!block.isOnlyCompiled()) {
            run(block, snippet, folder);
        }
    }

    private static Snippet snippet(Block block, String before) throws IOException {
        return new Snippet(block, before);
    }
}
