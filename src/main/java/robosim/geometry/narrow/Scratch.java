package robosim.geometry.narrow;

import robosim.geometry.narrow.cone.ConeScratch;

/** The working memory of all kernels. One for each owner of queries; never shared between threads. */
public final class Scratch extends ConeScratch {}
