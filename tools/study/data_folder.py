# SPDX-License-Identifier: MIT
"""The folder of scenes that STAD_DATA names."""
import json
import os
import sys


def entries(folder):
    """What its MANIFEST.json lists."""
    path = os.path.join(folder, "MANIFEST.json")
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except OSError as error:
        sys.exit(f"{path} cannot be read ({error.strerror}): STAD_DATA names the folder of scenes")
