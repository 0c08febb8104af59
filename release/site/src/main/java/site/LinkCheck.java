package site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Follows each link of written pages that stays on the site. */
final class LinkCheck {
    private static final Pattern LINK = Pattern.compile("<(?:a|img|link|script)\\b[^>]*?\\b(?:href|src)=\"([^\"]*)\"");
    private static final Pattern NAME = Pattern.compile("\\b(?:id|name)=\"([^\"]+)\"");
    private static final Pattern ADDRESS = Pattern.compile("^(?:[a-z][a-z0-9+.-]*:|//)");

    private final Path root;
    private final Map<Path, Set<String>> names = new HashMap<>();
    private final List<String> faults = new ArrayList<>();
    private int links;

    LinkCheck(Path root) {
        this.root = root.normalize();
    }

    void page(Path page) throws IOException {
        Matcher link = LINK.matcher(Files.readString(page));
        while (link.find()) {
            String address = link.group(1).replace("&amp;", "&");
            if (!ADDRESS.matcher(address).find()) {
                links++;
                if (!leadsSomewhere(page, address)) {
                    faults.add(root.relativize(page) + ": " + address);
                }
            }
        }
    }

    private boolean leadsSomewhere(Path page, String address) throws IOException {
        String file = address.replaceFirst("[#?].*", "");
        String name = address.contains("#") ? address.substring(address.indexOf('#') + 1) : "";
        Path target = file.isEmpty() ? page : page.resolveSibling(file).normalize();
        if (!target.startsWith(root) || !Files.isRegularFile(target)) {
            return false;
        }
        return name.isEmpty() || !target.toString().endsWith(".html") || names(target).contains(name);
    }

    private Set<String> names(Path page) throws IOException {
        Set<String> known = names.get(page);
        if (known == null) {
            known = new HashSet<>();
            Matcher name = NAME.matcher(Files.readString(page));
            while (name.find()) {
                known.add(name.group(1));
            }
            names.put(page, known);
        }
        return known;
    }

    int links() {
        return links;
    }

    List<String> faults() {
        return faults;
    }
}
