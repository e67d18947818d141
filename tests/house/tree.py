"""The tracked files of this repository, and the comments and words of a source. Used by the checks
beside it."""

import pathlib
import re
import subprocess

root = pathlib.Path(__file__).resolve().parents[2]

# Strings and characters are matched so that a // inside them does not start a comment.
_pieces = re.compile(
    r'R"(?P<mark>\w*)\(.*?\)(?P=mark)"'
    r'|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'"
    r"|(?P<comment>//[^\n]*|/\*.*?\*/)",
    re.DOTALL,
)

# A page's: templates and HTML's comments as well.
_page_pieces = re.compile(
    r'"(?:\\.|[^"\\\n])*"'
    r"|'(?:\\.|[^'\\\n])*'"
    r"|`(?:\\.|[^`\\])*`"
    r"|(?P<comment>(?<![:\\])//[^\n]*|/\*.*?\*/|<!--.*?-->)",
    re.DOTALL,
)


def tracked_files():
    """Paths relative to the root: what git tracks, or would with `git add`; without git, every
    file."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=root, capture_output=True, text=True)
    if listed.returncode == 0 and listed.stdout:
        return sorted(name for name in set(listed.stdout.splitlines()) if (root / name).is_file())
    files = (path.relative_to(root) for path in root.rglob("*") if path.is_file())
    return sorted(str(path) for path in files if path.parts[0] not in ("build", ".git"))


def text_of(name):
    return (root / name).read_text(encoding="utf-8", errors="replace")


def is_source(name):
    return name.endswith((".h", ".cpp"))


def is_page_source(name):
    """Of web/: components, scripts, style sheets."""
    return name.startswith("web/") and name.endswith((".svelte", ".ts", ".js", ".css"))


def is_script(name):
    path = root / name
    return name.endswith((".py", ".cmake", "CMakeLists.txt")) or ("." not in path.name
        and text_of(name).startswith("#!"))


def comments_of(name):
    """(line number, text) of each comment line. A script's comments start with #."""
    text = text_of(name)
    if is_source(name) or is_page_source(name):
        found = []
        for match in (_pieces if is_source(name) else _page_pieces).finditer(text):
            if match["comment"]:
                first = text.count("\n", 0, match.start()) + 1
                found += [(first + i, line) for i, line in enumerate(match["comment"].split("\n"))]
        return found
    if is_script(name):
        lines = enumerate(text.split("\n"), 1)
        return [(n, found[1]) for n, line in lines
                if (found := re.search(r"(?:^|\s)#([^!].*)", line))]
    return []


def code_of(name):
    """The text without comments, strings kept. It has the same lines."""
    text = text_of(name)
    if is_source(name) or is_page_source(name):
        pieces = _pieces if is_source(name) else _page_pieces
        return pieces.sub(
            lambda match: " " + "\n" * match[0].count("\n") if match["comment"] else match[0], text)
    if is_script(name):
        return re.sub(r"(?m)(?:^|(?<=\s))#[^!].*$", "", text)
    return text


def finish(check, complaints, summary):
    """Prints the complaints and ends the program: 1 where there are any."""
    for complaint in complaints:
        print(f"{check}: {complaint}")
    print(f"{check}: {len(complaints)} complaints; {summary}")
    raise SystemExit(1 if complaints else 0)
