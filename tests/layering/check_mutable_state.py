# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the library keeps no state outside its objects.

Two simulations of one process, in one thread or two, know nothing of each other only if nothing of the
library's own can be written but what an object owns: no variable of scarp lies in writable memory. The one
exception is the lock on HDF5, which is itself one for the whole process.

usage: check_mutable_state.py OBJDUMP OBJECT_OR_ARCHIVE...
"""
import re
import subprocess
import sys

# Sections that a running program can write; those that end in .ro are sealed once it is loaded.
WRITABLE = re.compile(r"\.(?:t?bss|t?data)(?!.*\.ro\b)")
SYMBOL = re.compile(r"[0-9a-f]{16} .{7} (\S+)\t([0-9a-f]+)\s+(?:\.hidden )?(.+)$")
OWN = re.compile(r"(?:guard variable for )?scarp::")
LOCK = re.compile(r"(?:guard variable for )?scarp::hdf5::\(anonymous namespace\)::library_mutex\(\)::one$")


def violations(objdump, files):
    lines = subprocess.run([objdump, "-t", "-C", *files], check=True, capture_output=True, text=True).stdout.splitlines()
    symbols = [match.groups() for match in map(SYMBOL.match, lines) if match]
    if not symbols:
        yield "no symbols were found"
    for section, size, name in symbols:
        if int(size, 16) > 0 and WRITABLE.match(section) and OWN.match(name) and not LOCK.match(name):
            yield f"{name} ({int(size, 16)} bytes in {section}) can be written"


if __name__ == "__main__":
    found = list(violations(sys.argv[1], sys.argv[2:]))
    print("\n".join(found) or "no variable of scarp can be written")
    sys.exit(1 if found else 0)
