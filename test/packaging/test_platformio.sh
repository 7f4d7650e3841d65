#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# library.json: PlatformIO's own packer takes it, and the sources that its filter picks from what was packed build and run with
# the flags of the manifest. PlatformIO's compilers come over the network: no board is built. Nor is the list of licences
# fetched by which it checks "MIT".
. "$(dirname "$0")/common.sh"
venv_with platformio 'platformio~=6.1'
copy_source "$work/copy"
export PLATFORMIO_CORE_DIR=$work/core PLATFORMIO_SETTING_ENABLE_TELEMETRY=no PLATFORMIO_SETTING_CHECK_PLATFORMIO_INTERVAL=9999
quietly "$venv/bin/python" - "$work" <<'END'
import json, sys
from pathlib import Path
from platformio import fs
from platformio.package.manifest.schema import ManifestSchema
from platformio.package.pack import PackagePacker
ManifestSchema.load_spdx_licenses = staticmethod(lambda: {"licenses": [{"licenseId": "MIT"}]})
work = Path(sys.argv[1])
archive = PackagePacker(str(work / "copy")).pack(str(work))
import tarfile
with tarfile.open(archive) as tar:
    tar.extractall(work / "library")
build = json.loads((work / "library/library.json").read_text())["build"]
sources = fs.match_src_files(str(work / "library" / build["srcDir"]), build["srcFilter"], ["c"])
assert len(sources) > 50, sources
(work / "sources").write_text("".join(f"{build['srcDir']}/{s}\n" for s in sources))
(work / "flags").write_text(" ".join([f"-I {build['includeDir']}", *build["flags"]]))
END
cd "$work/library"
[ ! -e tools ] && [ ! -e test ] || { echo "FAILED: more was packed than the library"; exit 1; }
# shellcheck disable=SC2046  # lists
quietly "$cc" -O1 $(cat "$work/flags") $(cat "$work/sources") examples/01_one_pair.c -o "$work/main"
quietly "$work/main"
