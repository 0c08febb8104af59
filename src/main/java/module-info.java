/** Collision, motion and range queries for robot simulators: what may be where, how far it may move, what is next. */
module robosim.geometry {
    requires java.xml;
    requires static com.fasterxml.jackson.core;
    requires static info.picocli;
    requires static java.desktop;
    requires static java.logging;
    requires static java.management;
    requires static jdk.httpserver;
    requires static org.jspecify;
    requires static org.junit.jupiter.api;
    requires static org.snakeyaml.engine;

    exports robosim.geometry;
    exports robosim.geometry.collision;
    exports robosim.geometry.dynamics;
    exports robosim.geometry.junit;
    exports robosim.geometry.material;
    exports robosim.geometry.model;
    exports robosim.geometry.net;
    exports robosim.geometry.proof;
    exports robosim.geometry.protocol;
    exports robosim.geometry.render;
    exports robosim.geometry.scenario;
    exports robosim.geometry.sensor;
    exports robosim.geometry.sweep;
    exports robosim.geometry.world;

    uses robosim.geometry.protocol.MessageTranslator;

    // JUnit makes the extensions of tests.
    opens robosim.geometry.junit to
            org.junit.platform.commons;

    // The command line is read into annotated fields.
    opens robosim.geometry.cli to
            info.picocli;
    opens robosim.geometry.cli.demo to
            info.picocli;
    opens robosim.geometry.cli.network to
            info.picocli;
    opens robosim.geometry.cli.studies to
            info.picocli;
    opens robosim.geometry.cli.terminal to
            info.picocli;
    opens robosim.geometry.cli.worlds to
            info.picocli;
}
