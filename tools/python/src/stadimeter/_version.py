# SPDX-License-Identifier: MIT
"""The version; the library's own is checked against it when it is loaded."""
__version__ = "0.1.0"
