# SPDX-License-Identifier: BSD-3-Clause
"""Checks that objects built for wide instruction sets keep to themselves.

The linker keeps one copy of a weak symbol for the whole program. If that copy comes from an AVX-512
object, the program dies on a machine without AVX-512, far from any kernel. So these objects may define
weak symbols only in scarp::kernels and xsimd, and none that another object defines too.

usage: check_isa_symbols.py NM ISA_OBJECT... -- OTHER_OBJECT_OR_ARCHIVE...
"""
import re
import subprocess
import sys

# Mangled names: only there is the enclosing namespace apart from argument and return types.
OWN = re.compile(r"_Z(?:GVZ?|TV|TI|TS|TT|Z)*N[rVK]*[RO]?(?:5scarp7kernels|5xsimd)")
POINTER = re.compile(r"DW\.ref\.")  # gcc's pointer to a run-time function: no instructions in it
WEAK = "VWuvw"
DEFINED = "TDBRVWuC"


def symbols(nm, files):
    """{object: [(type, mangled name)]} of the defined symbols."""
    lines = subprocess.run([nm, "-A", "--defined-only", *files], check=True, capture_output=True,
                           text=True).stdout.splitlines()
    table = {}
    for line in lines:
        match = re.match(r"(.*):\s*[0-9a-f]*\s+(\S)\s+(\S+)$", line)
        if match:
            table.setdefault(match.group(1), []).append((match.group(2), match.group(3)))
    return table


def violations(nm, isa_objects, other_objects):
    isa = symbols(nm, isa_objects)
    if len(isa) != len(isa_objects):
        yield f"symbols found in {len(isa)} of {len(isa_objects)} objects"
    names = {object_: {n for t, n in s if t in DEFINED} for object_, s in isa.items()}
    elsewhere = {n for s in symbols(nm, other_objects).values() for t, n in s if t in DEFINED} \
        if other_objects else set()
    for object_, table in isa.items():
        others = elsewhere.union(*(n for o, n in names.items() if o != object_))
        for kind, name in table:
            if POINTER.match(name):
                continue
            if kind in WEAK and not OWN.match(name):
                yield f"{object_}: weak {name} outside scarp::kernels and xsimd"
            elif kind in WEAK and name in others:
                yield f"{object_}: weak {name} is also defined without these instructions"


if __name__ == "__main__":
    split = sys.argv.index("--")
    found = list(violations(sys.argv[1], sys.argv[2:split], sys.argv[split + 1:]))
    demangled = subprocess.run(["c++filt"], input="\n".join(found), capture_output=True, text=True).stdout
    print(demangled or "no weak symbol leaves the objects of the instruction sets")
    sys.exit(1 if found else 0)
