# SPDX-License-Identifier: MIT
"""documents.py TREE [PYTHON]: every code block of every page, compiled or run in TREE, a copy of the source with build/stad in it.

C is compiled with warnings as errors; shell lines are run, one state for all pages, README.md first; Python is run by PYTHON, which
has the package. What is not run stands in NOT_RUN with its reason, and the files that it names must exist. Of commands that only
stand in a sentence, the options are checked; of links, that they lead somewhere; of prose, that no line is longer than WIDTH."""
import os
import re
import subprocess
import sys
from pathlib import Path

TREE = Path(sys.argv[1])
PYTHON = sys.argv[2] if len(sys.argv) > 2 else None
CC = os.environ.get("CC", "cc")

NOT_RUN = [
    (r"cmake -S \. -B build\b", "build/ is the build under test"),
    (r"cmake --build build( |$)", "build/ is the build under test"),
    (r"(UNITY_DIR=\S+ )?(tools/demo|test/run|test/target/run)", "the whole of it; run by hand and by the continuous check"),
    (r"cmake --preset|build-[a-z0-9-]+/", "boards and sanitizers have tiers of their own: target, fault"),
    (r"(STAD_DATA=(?:<[^>]*>|\S+) )?(python3 )?tools/(study|bench|count)/", "minutes to hours, some with scenes that are not here"),
    (r"pip install", "test_pip_install.sh and test_python.sh do"),
    (r"python3 -m stadimeter\.study", "test_python.sh does, on scenes of its own"),
    (r"west |idf\.py ", "Zephyr and ESP-IDF are in no package"),
    (r"(SCENES=all )?test/(golden|versions)/|(\S*/)?stad-verify", "needs OpenCV; the golden and long tiers do"),
]
COMMAND = re.compile(r"((?:STAD_DATA|UNITY_DIR)=(?:<[^>]*>|\S+) )?(build\S*/|tools/|test/|stad |cmake |python3 |pip |cc |west |idf\.py |make |git )")
# What stands for the reader's own files in some lines.
SAMPLES = {"LEFT": "pair/left.png", "RIGHT": "pair/right.png", "disp.pfm": "pair/disp.pfm"}
# For fragments of C: names that the text around them explains.
PRELUDE = """#include <stad/stad.h>
enum { W = 64, H = 48, D = 16, BLOCK = 5, P2 = 800, CAP = 63 };
extern stad_geometry geometry;
void fragment(void);
void fragment(void)
{
%s    (void)work, (void)bytes;
}
"""
PYTHON_PRELUDE = """
import numpy as np
import stadimeter
from drawn import frames, height, truth, width
left, right = frames[1]
disparity, scorer = stadimeter.StereoSGBM_create(0, 64, 5).compute(left, right), stadimeter.Scorer(numDisparities=64)
"""
WIDTH = 128  # columns of prose; tables, code, pictures and where a link leads may take more
failures = []


def fail(where, why):
    failures.append(where)
    print(f"FAILED: {where}: {why}")


def pages():
    first = ["README.md", "docs/MIGRATION.md", "docs/TUNING-GUIDE.md"]
    rest = sorted(p.relative_to(TREE).as_posix()
                  for pattern in ("*.md", "docs/*.md", "docs/*/*.md", "test/*.md", "tools/*/*.md", "examples/*/*.md")
                  for p in TREE.glob(pattern))
    return first + [p for p in rest if p not in first]


def blocks(text):
    """(line, language, lines); the language of an indented block is ''."""
    lines, i = text.split("\n"), 0
    while i < len(lines):
        fence = re.match(r"\s*```(.*)$", lines[i])
        start = i + 1
        if fence:
            end = next(k for k in range(start, len(lines)) if lines[k].strip() == "```")
            yield start + 1, fence.group(1).strip(), lines[start:end]
            i = end + 1
        elif lines[i].startswith("    ") and (i == 0 or not lines[i - 1].strip()):
            end = next((k for k in range(i, len(lines)) if lines[k].strip() and not lines[k].startswith("    ")), len(lines))
            yield start, "", [line[4:] for line in lines[i:end] if line.strip()]
            i = end
        else:
            i += 1


def compile_c(where, text):
    source = TREE / "block.c"
    if "STAD_PORT_H" in text:  # a port's header: the library must take it
        (TREE / "block_port").mkdir(exist_ok=True)
        (TREE / "block_port/stad_port.h").write_text(text)
        source, include = TREE / "lib/src/match/sweep.c", [f"-I{TREE}/lib/src", f"-I{TREE}/block_port"]
    else:
        source.write_text(text if "#include" in text else PRELUDE % text)
        include = []
    done = subprocess.run([CC, "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", f"-I{TREE}/lib/include", *include, "-c", source,
                           "-o", TREE / "block.o"], capture_output=True, text=True)
    if done.returncode:
        fail(where, done.stderr)


def run_line(where, line):
    for pattern, reason in NOT_RUN:
        if re.match(pattern, line):
            named = re.findall(r"(?:^|[ =])((?:tools|test|examples|docs)/[\w./-]*\w)", line)
            for name in named:
                if not (TREE / name).exists():
                    fail(where, f"there is no {name}: {line}")
            not_run[reason] = not_run.get(reason, 0) + 1
            return
    for name, path in SAMPLES.items():
        line = re.sub(rf"(?<![\w./]){re.escape(name)}\b", path, line)
    line = re.sub(r"^stad ", "build/stad ", line)
    done = subprocess.run(["bash", "-euc", line], cwd=TREE, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if done.returncode:
        fail(where, f"{line}\n{done.stdout}{done.stderr}")


def shell_lines(lines):
    """Commands: continued lines joined; in an indented block what follows three spaces is said about the command."""
    joined = "\n".join(lines).replace("\\\n", " ").split("\n")
    return [re.split(r"\s{3,}|\s+# ", line.strip())[0] for line in joined if line.strip() and not line.strip().startswith("#")]


def run_python(where, text):
    if PYTHON is None:
        not_run["no Python with the package"] = not_run.get("no Python with the package", 0) + 1
        return
    done = subprocess.run([PYTHON, "-c", PYTHON_PRELUDE + text], cwd=TREE, capture_output=True, text=True)
    if done.returncode:
        fail(where, done.stderr)


def draw_frames():
    """What the Python blocks speak of: a recording, and truth of one of its frames."""
    (TREE / "drawn.py").write_text('''
import numpy as np
from stadimeter.files import read_grey, read_pfm
frames = [(read_grey(f"recording/{i:03d}_left.png"), read_grey(f"recording/{i:03d}_right.png")) for i in range(5)]
truth = read_pfm("recording/001_disp.pfm")
height, width = truth.shape
''')


def check_block(where, language, lines):
    text = "\n".join(lines) + "\n"
    if language == "c" or (language == "" and re.match(r"(static|const|int|size_t) .*;$", lines[0])):
        compile_c(where, text)
    elif language == "python":
        run_python(where, text)
    elif language == "sh" or (language == "" and COMMAND.match(lines[0])):
        for line in shell_lines(lines):
            run_line(where, line)
    elif language == "":
        return "drawing"
    elif language != "text":
        fail(where, f"a block of {language!r}: c, sh, python or text")
    return language or "code"


def check_sentences(page, text):
    text = re.sub(r"```.*?```", "", text, flags=re.DOTALL)
    for command, rest in re.findall(r"`(?:build/)?stad ([a-z]+)((?: [^`]*)?)`", text):
        for name in re.findall(r"--([a-z0-9-]+)", rest):
            if f"--{name}" not in helps.setdefault(command, help_of(command)) and name != "help":
                fail(page, f"`stad {command}` has no --{name}")
    for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", text):
        if not ((TREE / page).parent / target).exists():
            fail(page, f"a link to {target}, which is not there")


def check_width(page, text):
    text = re.sub(r"```.*?```", lambda block: "\n" * block.group().count("\n"), text, flags=re.DOTALL)
    for number, line in enumerate(text.split("\n"), 1):
        if not line.lstrip().startswith(("|", "![")) and not line.startswith("    "):
            columns = len(re.sub(r"\]\([^)]*\)", "]", line))
            if columns > WIDTH:
                fail(f"{page}:{number}", f"{columns} columns of prose, {WIDTH} at most")


def help_of(command):
    return subprocess.run([TREE / "build/stad", command, "--help"], capture_output=True, text=True).stdout


not_run, helps, kinds = {}, {}, {}
for page in pages():
    text = (TREE / page).read_text()
    for line, language, lines in blocks(text):
        kind = check_block(f"{page}:{line}", language, lines)
        kinds[kind] = kinds.get(kind, 0) + 1
    check_sentences(page, text)
    check_width(page, text)
    if page == "README.md":
        for name in ("one_pair", "disp.npy", "disp.png", "tuned.json", "tuned.html", "better.npy", "board.html"):
            if not (TREE / name).exists() or (TREE / name).stat().st_size == 0:
                fail(page, f"{name} was not written")
        draw_frames()
print("blocks: " + ", ".join(f"{count} {kind}" for kind, count in sorted(kinds.items())))
for reason, count in not_run.items():
    print(f"not run, {count}: {reason}")
sys.exit(1 if failures else 0)
