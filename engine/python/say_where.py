# SPDX-License-Identifier: BSD-3-Clause
"""Says at the end of an installation where the Python package is. usage: say_where.py FOLDER"""
import os
import sys

folder = sys.argv[1]
found = os.path.realpath(folder) in map(os.path.realpath, sys.path)
print(f"-- The Python module is in {folder}" +
      (f", where {sys.executable} finds it" if found else f". To use it: export PYTHONPATH={folder}"))
