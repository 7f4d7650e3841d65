#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The scripts where things go wrong: a signal ends them and leaves nothing behind, lists of packages are old, tools are missing.

Each runs with a folder of links to this machine's programs as its PATH, but for those that are left out or played by a stand-in.
"""
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(os.environ.get("STAD_SOURCE", pathlib.Path(__file__).resolve().parent.parent.parent))
TRAPS = "; trap 'exit 130' INT; trap 'exit 143' TERM"
PRIVILEGED = "#!/bin/sh\nwhile [ \"${1#-}\" != \"$1\" ]; do shift; done\nexec \"$@\"\n"
failures = []


def check(ok, *what):
    if not ok:
        failures.append(what)
        print("FAILED:", *what)


def programs(folder, leave_out, stand_ins):
    """A PATH of everything but what leave_out matches, and of these scripts."""
    folder.mkdir()
    for place in os.environ["PATH"].split(os.pathsep):
        for program in pathlib.Path(place).glob("*"):
            if not re.fullmatch(leave_out, program.name) and not (folder / program.name).is_symlink():
                (folder / program.name).symlink_to(program)
    for name, text in stand_ins.items():
        (folder / name).unlink(missing_ok=True)
        (folder / name).write_text(text)
        (folder / name).chmod(0o755)
    return {**os.environ, "PATH": str(folder)}


def copy(tree, *files):
    for file in files:
        (tree / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / file, tree / file)


def start(command, env):
    return subprocess.Popen(command, env=env, start_new_session=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))


def stop(child, there):
    """Status and words after Ctrl-C, once a file is there."""
    limit = time.monotonic() + 60
    while not there.exists() and child.poll() is None and time.monotonic() < limit:
        time.sleep(0.05)
    if child.poll() is None:
        os.killpg(child.pid, signal.SIGINT)
    text = child.communicate(timeout=60)[0]
    return child.returncode, text


def every_script_stops():
    for file in [*ROOT.glob("test/**/*"), *ROOT.glob("tools/**/*"), *ROOT.glob(".ci/*")]:
        if file.is_file() and file.suffix in ("", ".sh") and file.read_bytes()[:2] in (b"#!", b"# "):
            for line in file.read_text(errors="replace").splitlines():
                if re.match(r"\s*trap .*\bEXIT\b", line):
                    check(line.endswith(" EXIT" + TRAPS), f"{file.relative_to(ROOT)}: Ctrl-C does not end it: {line}")


def setup_stops(work):
    env = programs(work / "bin", "apt-get", {"apt-get": f"#!/bin/sh\ntouch {work}/asked\nexec sleep 30\n"})
    (work / "tmp").mkdir()
    status, text = stop(start([ROOT / "test/setup", work / "unity"], {**env, "TMPDIR": str(work / "tmp")}), work / "asked")
    check(status == 130 and not list((work / "tmp").iterdir()), f"test/setup after Ctrl-C: status {status}, {text}")


def demo_fetches_old_lists_again(work):
    apt = f"""#!/bin/sh
echo $1 >>{work}/calls
case $1 in
install) [ "$(grep -c install {work}/calls)" -gt 1 ] && printf '#!/bin/sh\\n' >{work}/bin/cmake && chmod 755 {work}/bin/cmake ;;
download) touch {work}/asked; exec sleep 30 ;;
esac
"""
    env = programs(work / "bin", "apt-get|cmake|sudo", {"apt-get": apt, "sudo": PRIVILEGED})
    copy(work, "tools/demo")
    (work / "build/demo").mkdir(parents=True)
    (work / "build/demo/lists-fetched").touch()
    status, text = stop(start([work / "tools/demo"], env), work / "asked")
    calls = (work / "calls").read_text().split()
    check(calls[:3] == ["install", "update", "install"], f"tools/demo with old lists: {calls}, {text}")
    check(status == 130 and not list((work / "build/demo").glob("fetch.*")), f"tools/demo after Ctrl-C: status {status}, {text}")


def run_without_apt(work):
    cmake = f"#!/bin/sh\nmkdir -p {work}/build-test\necho \"$@\" >>{work}/calls\n"
    env = programs(work / "bin", "apt-get|dpkg.*|cmake", {"cmake": cmake})
    env.pop("UNITY_DIR", None)
    copy(work, "test/run", "test/setup", "test/packages")
    done = subprocess.run([work / "test/run", "proof"], env=env, capture_output=True, text=True)
    check("no Debian" in done.stdout and "frama-c-base" in done.stdout, "test/run does not say what it needs:", done.stdout)
    check("UNITY_DIR" in done.stdout and "UNITY_DIR" in done.stderr, "test/run does not tell of UNITY_DIR:", done.stdout, done.stderr)
    (work / "own").mkdir()
    (work / "own/unity.c").touch()
    done = subprocess.run([work / "test/run", "proof"], env={**env, "UNITY_DIR": "own"}, cwd=work, capture_output=True, text=True)
    check(f"-DUNITY_DIR={work}/own" in (work / "calls").read_text() and "Unity" not in done.stdout + done.stderr,
          "test/run does not take a Unity of one's own:", done.stdout, done.stderr)


def count_without_emulators(work):
    env = programs(work / "bin", "qemu-.*", {})
    done = subprocess.run([ROOT / "tools/count/count", "--check"], env={**env, "STAD_BUILD_ROOT": str(work)}, capture_output=True, text=True)
    check(done.returncode == 77, f"tools/count/count without emulators: status {done.returncode}, {done.stdout}")


every_script_stops()
for test in (setup_stops, demo_fetches_old_lists_again, run_without_apt, count_without_emulators):
    with tempfile.TemporaryDirectory() as folder:
        test(pathlib.Path(folder).resolve())
print("the scripts stop, fetch again and say what is missing" if not failures else f"{len(failures)} failed")
sys.exit(1 if failures else 0)
