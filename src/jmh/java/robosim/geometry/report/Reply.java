package robosim.geometry.report;

/**
 * What another engine said to a question, in projection.
 *
 * @param text what it said, or why it could not be asked
 */
record Reply(Kind kind, String text) {
    /** What its answer is worth. */
    enum Kind {
        RIGHT,
        WRONG,
        /** Explained by what it declares its sets or tolerances to be. */
        DIFFERS,
        CANNOT
    }

    static Reply cannot(String why) {
        return new Reply(Kind.CANNOT, why);
    }
}
