#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The CMSIS-Pack description: well-formed, every file there, and what each variant lists builds with nothing else.

Its schema and the pack tools are in no package, so neither is asked; the plain variant is linked and run, the others are compiled
for their cores where the cross compiler is there."""
import os
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(os.environ.get("STAD_SOURCE", Path(__file__).resolve().parents[2]))
CROSS = "arm-none-eabi-gcc"
VARIANTS = {
    "plain C": [os.environ.get("CC", "cc")],
    "Arm DSP": [CROSS, "-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"],
    "Arm MVE": [CROSS, "-mcpu=cortex-m55", "-mthumb", "-mfloat-abi=hard"],
}
MAIN = ROOT / "examples/01_one_pair.c"


def build(component, compiler, folder):
    files = [(f.get("category"), f.get("name")) for f in component.iter("file")]
    missing = [name for _, name in files if not (ROOT / name).exists()]
    assert not missing, f"no such files: {missing}"
    sources = [ROOT / name for kind, name in files if kind == "source"] + [MAIN]
    assert len({s.name for s in sources}) == len(sources), "two files of one name"
    # Only what is listed: a copy, so that a header left out is missed.
    tree = folder / "tree"
    for _, name in files:
        if not name.endswith("/"):
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, tree / name)
    flags = ["-std=c99", "-O1"] + [f"-I{tree / name}" for kind, name in files if kind == "include"]

    def compile_one(source):
        path = source if source == MAIN else tree / source.relative_to(ROOT)
        out = folder / (source.stem + ".o")
        done = subprocess.run([*compiler, *flags, "-c", path, "-o", out], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return out

    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(compile_one, sources))


def main():
    packs = list(ROOT.glob("*.pdsc"))
    assert len(packs) == 1, packs
    pack = ElementTree.parse(packs[0]).getroot()
    vendor, name = pack.findtext("vendor"), pack.findtext("name")
    assert packs[0].name == f"{vendor}.{name}.pdsc", "a pack's file is called VENDOR.NAME.pdsc"
    assert (ROOT / pack.findtext("license")).exists()
    newest = pack.find("releases/release").get("version")
    components = {c.get("Cvariant"): c for c in pack.iter("component")}
    assert components.keys() == VARIANTS.keys(), list(components)
    conditions = {c.get("id") for c in pack.iter("condition")}
    for variant, component in components.items():
        assert component.get("Cversion") == newest
        assert component.get("condition", "DSP") in conditions
        if not shutil.which(VARIANTS[variant][0]):
            print(f"{variant}: UNAVAILABLE, {VARIANTS[variant][0]} is missing")
            continue
        with tempfile.TemporaryDirectory() as folder:
            objects = build(component, VARIANTS[variant], Path(folder))
            if variant == "plain C":
                subprocess.run([*VARIANTS[variant], *objects, "-o", Path(folder) / "main"], check=True)
                subprocess.run([Path(folder) / "main"], check=True, stdout=subprocess.DEVNULL)
            print(f"{variant}: {len(objects)} files built")


if __name__ == "__main__":
    try:
        main()
    except AssertionError as failure:
        print(f"FAILED: {failure}")
        sys.exit(1)
