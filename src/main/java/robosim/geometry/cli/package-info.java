/**
 * The command line: the only package that parses arguments or exits the process. It needs picocli and the JDK's
 * java.desktop.
 */
@NullMarked
package robosim.geometry.cli;

import org.jspecify.annotations.NullMarked;
