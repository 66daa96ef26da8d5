#!/usr/bin/python3
"""Checks that the tree keeps the rules of ARCHITECTURE.md.

Usage: check_architecture.py [SOURCE_DIR]. Prints one line a violation; exit 1 if there is any.
The rooms, which of them are pure and who may use whom are read from the table in ARCHITECTURE.md.
"""

import pathlib
import re
import sys

THESIS_ROOMS = ("attention", "active_vision", "navigation", "rangefinder", "recognition", "geons")
EMBREE_ROOMS = ("sim", "evaluation")
# What a single pure room may use beyond Eigen and OpenCV's core.
OWN_LIBRARIES = {"calibration": ("ceres/", "opencv2/calib3d.hpp")}
SIM_USERS = ("geon", "lockstep", "simulator")
MAX_FILE_LINES = 400
MAX_MAIN_LINES = 30

IMPURE_INCLUDE = re.compile(
    r"lcm/|geon/|zmq|opencv2/(?!(core|imgproc|ml)(/|\.hpp))|iostream|fstream|ofstream|unistd\.h|termios\.h"
    r"|thread|mutex|future|condition_variable|chrono|ctime|time\.h|fcntl\.h|poll\.h|sys/|netinet/|spdlog/|CLI/|csignal")
IMPURE_WORD = re.compile(
    r"random_device|\bstd::c(out|err|in)\b|\bprintf\(|\bputs\(|\bfopen\(|\bgetenv\(|\bclock_gettime\(|\bgettimeofday\(|\brand\(\)"
    r"|\bfilesystem::(?!path\b)\w+")
PURE_LIBRARIES = ("Eigen/", "opencv2/")
UNIT = re.compile(
    r"_(m|rad|deg|arcsec|s|us|px|counts|e|1|hz|level|levels|kelvin|V|m_s|rad_s|m_s2|rad_s2|counts_s|counts_s2|rad_m|m_px"
    r"|rad_px|m2|px2)$|^rotation_[A-Z]+$|^normal_[A-Z]$")
FIELD = re.compile(
    r"^\s*(?:std::(?:array|vector|optional)<\s*)?(?:double|float)\b(?:\s*,\s*[\w: ]+)?\s*>?\s+"
    r"(\w+[^;(]*);", re.MULTILINE)
UNFINISHED = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")


class Tree:
    """The source tree, read once."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.files = {}
        for folder in ("common", "procs", "tests", "lcmtypes", "scripts"):
            for path in sorted((self.root / folder).rglob("*")):
                if path.is_file() and "__pycache__" not in path.parts:
                    self.files[path.relative_to(self.root)] = path.read_text(errors="replace")
        self.rooms, self.pure = self._read_table()

    def _read_table(self):
        rooms, pure = {}, set()
        text = (self.root / "ARCHITECTURE.md").read_text()
        section = text.partition("\n## Rooms")[2].partition("\n## ")[0]
        for row in re.finditer(r"^\| `(\w+)` \|([^|]*)\|[^|]*\|([^|]*)\|$", section, re.MULTILINE):
            rooms[row[1]] = set(row[3].split())
            if row[2].strip().startswith("P"):
                pure.add(row[1])
        return rooms, pure

    def code(self, folder):
        """(path, text) of the C++ files below a folder."""
        below = pathlib.PurePath(folder).parts
        for path, text in self.files.items():
            if path.suffix in (".h", ".cc") and path.parts[: len(below)] == below:
                yield path, text

    def text(self, relative):
        path = self.root / relative
        return path.read_text() if path.is_file() else ""


def includes(text):
    """(line number, what is between the quotes or brackets) of every include."""
    for match in re.finditer(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^">]+)[">]', text, re.MULTILINE):
        yield text.count("\n", 0, match.start()) + 1, match[1]


def without_comments(text):
    text = re.sub(r"/\*.*?\*/", lambda m: "\n" * m[0].count("\n"), text, flags=re.DOTALL)
    return re.sub(r"//[^\n]*", "", text)


def body_after(text, start):
    """The text between the first brace after `start` and its partner."""
    begin = text.find("{", start)
    depth = 0
    for i in range(begin, len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return text[begin + 1 : i]
    return ""


def check_table(tree):
    """The table exists, names only rooms it defines, every room of common/ is in it, and it has no cycle."""
    if not tree.rooms:
        yield "ARCHITECTURE.md: no table of rooms found"
    for room, used in tree.rooms.items():
        for other in sorted(used - tree.rooms.keys()):
            yield f"ARCHITECTURE.md: {room} may use {other}, which is no room"
    for room in sorted({path.parts[1] for path in tree.files if path.parts[0] == "common" and len(path.parts) > 2}):
        if room not in tree.rooms:
            yield f"common/{room}: not in the table of ARCHITECTURE.md"
    done = set()

    def visit(room, trail):
        if room in trail:
            yield "ARCHITECTURE.md: cycle " + " -> ".join(trail[trail.index(room) :] + [room])
        elif room not in done:
            for other in sorted(tree.rooms.get(room, ())):
                yield from visit(other, trail + [room])
            done.add(room)

    for room in sorted(tree.rooms):
        yield from visit(room, [])


def check_include_edges(tree):
    """Rooms include only rooms of their row; nobody in common/ includes procs/ or tests/."""
    for path, text in tree.code("common"):
        room = path.parts[1]
        allowed = tree.rooms.get(room, set()) | {room}
        for line, name in includes(text):
            first = name.split("/")[0]
            if first in tree.rooms and "/" in name and first not in allowed:
                yield f"{path}:{line}: {room} may not use {first}"
            elif first in ("procs", "tests", "common"):
                yield f"{path}:{line}: a room may not include {name}"
            elif first == "geon" and room != "messaging":
                yield f"{path}:{line}: only messaging sees lcmtypes"


def check_linked_rooms(tree):
    """What CMake links is within the table too."""
    for path, text in tree.files.items():
        declared = re.search(r"geon_room\((\w+)([^)]*)\)", text) if path.name == "CMakeLists.txt" else None
        if not declared or path.parts[0] != "common":
            continue
        depends = re.search(r"DEPENDS((?:\s+[a-z_]+)+)", declared[2])
        linked = set(depends[1].split()) if depends else set()
        linked |= set(re.findall(r"\bgeon_(\w+)", declared[2])) & tree.rooms.keys()
        for other in sorted(linked - tree.rooms.get(declared[1], set())):
            yield f"{path}: {declared[1]} may not link {other}"


def check_purity(tree):
    """Pure rooms, and the device room's codecs, touch no outside world."""
    for path, text in tree.code("common"):
        room = path.parts[1]
        if room not in tree.pure and not path.stem.endswith("_codec"):
            continue
        for line, name in includes(text):
            own = name.split("/")[0] in tree.rooms
            system_library = "/" in name and not own and not name.startswith(PURE_LIBRARIES)
            embree = room in EMBREE_ROOMS and name.startswith("embree3/")
            special = name.startswith(OWN_LIBRARIES.get(room, ("\0",)))
            if not own and not embree and not special and (system_library or IMPURE_INCLUDE.match(name)):
                yield f"{path}:{line}: a pure room may not include <{name}>"
        for number, content in enumerate(without_comments(text).split("\n"), 1):
            found = IMPURE_WORD.search(content)
            if found:
                yield f"{path}:{number}: a pure room may not use {found[0].rstrip('(')}"


def check_sim_users(tree):
    """Only the simulator, the lock-step and the `geon` command use the room sim."""
    for path, text in tree.code("procs"):
        for line, name in includes(text):
            if name.startswith("sim/") and path.parts[1] not in SIM_USERS:
                yield f"{path}:{line}: only {' and '.join('procs/' + user for user in SIM_USERS)} may use sim"


def check_simulator_has_no_bus(tree):
    """geon-sim speaks at the hardware boundary: no LCM, no host side."""
    for path, text in tree.code("procs/simulator"):
        for line, name in includes(text):
            if name.split("/")[0] in ("messaging", "device", "lcm", "geon"):
                yield f"{path}:{line}: the simulator may not include {name}"


def check_mirrored_tests(tree):
    """Every common/x/y.cc has tests/common/x/y_test.cc."""
    for path, _ in tree.code("common"):
        test = pathlib.Path("tests") / path.parent / (path.stem + "_test.cc")
        if path.suffix == ".cc" and test not in tree.files:
            yield f"{path}: no {test}"


def check_sources(tree):
    """Every header of a thesis room says where its method comes from."""
    for room in THESIS_ROOMS:
        for path, text in tree.code(f"common/{room}"):
            if path.suffix == ".h" and "Source:" not in text:
                yield f"{path}: no 'Source:' (section, equation, paper)"


def fields_without_unit(text):
    for match in FIELD.finditer(text):
        for declarator in re.sub(r"\{[^}]*\}|\[[^\]]*\]", "", match[1]).split(","):
            name = declarator.split("=")[0].strip()
            if re.fullmatch(r"[A-Za-z]\w*", name) and not UNIT.search(name):
                yield name


def check_units(tree):
    """Floating-point fields of messages and options carry their unit (_1: a pure number)."""
    for path, text in tree.files.items():
        if path.suffix == ".lcm":
            for name in fields_without_unit(without_comments(text)):
                yield f"{path}: field {name} has no unit in its name"
    for folder in ("common", "procs"):
        for path, text in tree.code(folder):
            clean = without_comments(text)
            for struct in re.finditer(r"\bstruct (\w*Options)\b[^;{]*\{", clean):
                for name in fields_without_unit(body_after(clean, struct.start())):
                    yield f"{path}: {struct[1]}::{name} has no unit in its name"


def check_main(tree):
    """main() is short."""
    for path, text in tree.code("procs"):
        start = re.search(r"^int main\(", text, re.MULTILINE)
        lines = body_after(text, start.start()).count("\n") if start else 0
        if lines > MAX_MAIN_LINES:
            yield f"{path}: main() has {lines} lines, more than {MAX_MAIN_LINES}"


def check_files(tree):
    """Files have one idea each: a telling name, at most 400 lines, nothing left unfinished."""
    for path, text in tree.files.items():
        if re.search(r"(^|[_/])(utils?|helpers?|misc)([_./]|$)", str(path)):
            yield f"{path}: name it by what it answers"
        if path.suffix not in (".h", ".cc"):
            continue
        lines = text.count("\n")
        if lines > MAX_FILE_LINES:
            yield f"{path}: {lines} lines, more than {MAX_FILE_LINES}"
        for number, content in enumerate(text.split("\n"), 1):
            if UNFINISHED.search(content):
                yield f"{path}:{number}: unfinished ({UNFINISHED.search(content)[0]})"


def check_channels(tree):
    """docs/channels.md lists every channel."""
    documented = tree.text("docs/channels.md")
    for name in re.findall(r'"([A-Z][A-Z_]+)"', tree.text("common/messaging/channels.h")):
        if not re.search(rf"\b{name}", documented):
            yield f"docs/channels.md: channel {name} is not described"


def check_processes(tree):
    """Every program is in the table of ARCHITECTURE.md."""
    table = tree.text("ARCHITECTURE.md")
    for path, text in tree.files.items():
        for program in re.findall(r"^geon_program\((\S+)", text, re.MULTILINE) if path.parts[0] == "procs" else ():
            if f"| `{program}` |" not in table:
                yield f"{path}: {program} is not in the table of processes of ARCHITECTURE.md"


def check_links(tree):
    """Links between our documents, and the files that the thesis map names, exist."""
    documents = [tree.root / name for name in ("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    for document in [d for d in documents if d.is_file()] + sorted((tree.root / "docs").rglob("*.md")):
        text = document.read_text()
        for target in re.findall(r"\]\((?!https?:|#|mailto:)([^)#\s]+)", text):
            if not (document.parent / target).exists():
                yield f"{document.relative_to(tree.root)}: link to {target}, which does not exist"
        for target in re.findall(r"`((?:common|procs|scripts|tests|lcmtypes)/[\w./-]+\.\w+)`", text):
            if not (tree.root / target).exists():
                yield f"{document.relative_to(tree.root)}: names {target}, which does not exist"


RULES = (check_table, check_include_edges, check_linked_rooms, check_purity, check_sim_users,
         check_simulator_has_no_bus, check_mirrored_tests, check_sources, check_units, check_main, check_files,
         check_channels, check_processes, check_links)


def violations(root):
    tree = Tree(root)
    return [violation for rule in RULES for violation in rule(tree)]


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2]
    found = violations(root)
    print("\n".join(found) if found else f"{len(RULES)} rules hold")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
