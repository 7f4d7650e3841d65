#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`stad COMMAND --help` names every option that the command's table holds, and none that it does not; examples included."""
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(os.environ.get("STAD_SOURCE", Path(__file__).resolve().parents[2]))
STAD = Path(os.environ["STAD_BUILD"]) / "stad"
OPTION = re.compile(r'\{\s*"([a-z0-9-]+)",\s*(?:no|required|optional)_argument')


def run(*words):
    done = subprocess.run([STAD, *words], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def accepted(command):
    """From the table of the command, and of the options it shares."""
    text = (ROOT / f"tools/stad/cmd_{command}.c").read_text()
    shared = (ROOT / "tools/stad/match_options.h").read_text() if re.search(r"\bMATCH_OPTIONS\b", text) else ""
    return set(OPTION.findall(text)) | set(OPTION.findall(shared))


def check(command):
    status, text, errors = run(command, "--help")
    wrong = []
    if status or errors or not text.startswith(f"usage: stad {command} "):
        wrong.append(f"--help ends with {status}, says {text[:40]!r}, complains {errors!r}")
    if "Example: stad" not in text:
        wrong.append("no example")
    own = "\n".join(line for line in text.splitlines() if not re.match(r"(Example:|\s+)\s*stad (?!%s\b)" % command, line))
    own = re.sub(r"`stad (?!%s\b)[^`]*`" % command, "", own)
    own = re.sub(r"(&& stad (?!%s\b)).*" % command, "", own)
    named, table = set(re.findall(r"--([a-z0-9][a-z0-9-]*)", own)), accepted(command) - {"help"}
    if len(table) == 0:
        wrong.append("no table of options found")
    wrong += [f"--{name} is accepted but not told" for name in sorted(table - named)]
    wrong += [f"--{name} is told but not accepted" for name in sorted(named - table - {"help"})]
    for name in sorted(table):
        if "unrecognized" in run(command, f"--{name}")[2]:
            wrong.append(f"--{name} stands in the table but is not recognized")
    wide = [line for line in text.splitlines() if len(line) > 130]
    wrong += [f"too wide: {line}" for line in wide]
    for problem in wrong:
        print(f"FAILED: stad {command}: {problem}")
    return not wrong


def main():
    if not STAD.exists():
        print(f"SKIPPED: {STAD} is not built")
        return 77
    status, text, _ = run("--help")
    commands = re.findall(r"^  ([a-z]+) ", text, re.MULTILINE)
    files = {path.stem[4:] for path in (ROOT / "tools/stad").glob("cmd_*.c")}
    if status or set(commands) != files:
        print(f"FAILED: stad --help names {commands}, the sources have {sorted(files)}")
        return 1
    good = [check(command) for command in commands]
    print(f"{sum(good)} of {len(good)} commands")
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
