# SPDX-License-Identifier: BSD-3-Clause
"""Checks who may include what, where instruction sets may be named, and equation ids.

usage: check_layering.py ROOT      prints one line per violation; exit code 1 if there is any
"""
import pathlib
import re
import sys

SOURCE_SUFFIXES = {".hpp", ".cpp", ".h", ".inl"}
CODE_FOLDERS = ("kernels", "engine", "bench", "validation", "tests")

# library: (pattern of its includes, folders or file stems that may include it)
THIRD_PARTY = {
    "xsimd": (r"xsimd/", ("kernels/", "tests/kernels/", "bench/")),
    "HDF5": (r"(hdf5|H5\w*|hdf5_hl)\.h", ("engine/output/", "tests/engine/")),
    "zlib": (r"zlib\.h", ("engine/output/", "tests/engine/")),
    "OpenMP": (r"omp\.h", ("engine/parallel.",)),
    "Eigen": (r"Eigen/", ("engine/", "validation/", "tests/")),
    "toml++": (r"toml(\+\+|plusplus)?[/.]", ("engine/scene/", "engine/cli/", "validation/", "tests/")),
    "CLI11": (r"CLI/", ("engine/cli/", "engine/distributed/", "validation/", "bench/")),
    "MPI": (r"mpi\.h", ("engine/distributed/",)),
    "LAMMPS": (r"(atom|comm|domain|fix|lammps|library|modify)\.h", ("engine/distributed/",)),
    "nlohmann-json": (r"nlohmann/", ("engine/", "validation/", "bench/", "tests/")),
    "muParser": (r"muParser", ("engine/", "tests/")),
    "pybind11": (r"pybind11/", ("engine/python/",)),
    "fmt": (r"fmt/", ("engine/", "validation/", "bench/", "tests/")),
}
# Standard headers that mean allocation or I/O; kernels are arithmetic on views.
NOT_IN_KERNELS = {"vector", "iostream", "fstream", "sstream", "memory", "map", "unordered_map", "thread"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)
PRAGMA_OMP = re.compile(r'#\s*pragma\s+omp\b|_Pragma\s*\(\s*"omp\b')
TARGET_IN_SOURCE = re.compile(r"#\s*pragma\s+GCC\s+target|__attribute__\s*\(\(\s*target\b|\[\[gnu::target")
MACHINE_FLAG = re.compile(r"""(?:^|[\s"';:=(,>])(-m[a-z0-9][\w=.+-]*)""")
EQUATION = re.compile(r"\bEquations?:\s*((?:[A-Z]{1,2}\d+[a-z]?(?:\s*\([^)]*\))?(?:\s*,\s*|\s+and\s+)?)+)")
EQUATION_ID = re.compile(r"\b[A-Z]{1,2}\d+[a-z]?\b")


def without_comments(text):
    """The text with C++ comments blanked, so that words in them count for nothing."""
    blank = lambda m: re.sub(r"[^\n]", " ", m.group()) if m.group()[0] == "/" else m.group()
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', blank, text, flags=re.S)


class Tree:
    """The source files under a root, and what each includes."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.text = {}
        for folder in CODE_FOLDERS:
            for path in sorted((self.root / folder).rglob("*")):
                if path.suffix in SOURCE_SUFFIXES and path.is_file():
                    self.text[path.relative_to(self.root).as_posix()] = path.read_text("utf-8")
        self.includes = {f: INCLUDE.findall(without_comments(t)) for f, t in self.text.items()}

    def in_folder(self, *folders):
        return (f for f in self.text if f.startswith(folders))

    def closure(self, files):
        """The files and every project file they include, directly or not."""
        seen, todo = set(), [f for f in files if f in self.text]
        while todo:
            file = todo.pop()
            if file not in seen:
                seen.add(file)
                todo += [i for _, i in self.includes[file] if i in self.text]
        return sorted(seen)


def is_oracle(file):
    """The plain scalar references the kernels are tested against; no kernel includes them."""
    return re.search(r"_reference\.\w+$", file) is not None


def may_include(file, name):
    return file.startswith(THIRD_PARTY[name][1]) or (name == "Eigen" and is_oracle(file))


def third_party_in(include):
    return next((name for name, (p, _) in THIRD_PARTY.items() if re.match(p, include)), None)


def check_third_party(tree):
    for file in tree.text:
        for _, include in tree.includes[file]:
            name = third_party_in(include)
            if name and not may_include(file, name):
                yield f"{file}: includes {name} ({include}), allowed only in {', '.join(THIRD_PARTY[name][1])}"
        if PRAGMA_OMP.search(without_comments(tree.text[file])) and not file.startswith("engine/parallel."):
            yield f"{file}: uses an OpenMP pragma, allowed only in engine/parallel.hpp"


def check_directions(tree):
    """validation, bench, cli, python -> engine -> kernels, never back."""
    forbidden = {
        "kernels/": ("engine/", "validation/", "bench/", "tests/"),
        "engine/": ("validation/", "bench/", "tests/"),
        "validation/": ("bench/", "tests/"),
        "bench/": ("tests/",),
    }
    for layer, above in forbidden.items():
        for file in tree.in_folder(layer):
            for _, include in tree.includes[file]:
                if include.startswith(above):
                    yield f"{file}: includes {include} of a layer above {layer}"
                if layer == "engine/" and include.startswith(FRONT_ENDS) and not file.startswith(FRONT_ENDS):
                    yield f"{file}: includes {include}, but the library knows nothing of the command line and Python"


# The floors of engine/: a file includes headers of its own entry and of the floors below. Phases are functions of
# the whole state, so that their sources may also include state.hpp and the headers of other phases; but nothing
# below the facade includes what stands on it.
FLOORS = (
    ("errors.",),
    ("stop.", "machine.", "parallel.", "plain_text.", "team."),
    ("scene/",),
    ("particles/",),
    ("cells/", "step/"),
    ("neighbours/", "sweep/"),
    ("boundary/",),
    ("sleep/",),
    ("integrate/", "energy/", "stages/", "watch/", "features.", "isa_names.", "run_options."),
    ("state.",),
    ("setup.", "checkpoint/", "integrate/stress_phase."),
    ("simulation.",),
    ("custom_model.", "converge/", "element/", "output/"),
    ("run/",),
    ("check/", "fos/"),
    ("cli/", "scarp."),
    ("distributed/", "python/"),
)
FRONT_ENDS = ("engine/cli/", "engine/distributed/", "engine/python/")
FACADE = FLOORS.index(("simulation.",))
NO_PHASES = {"scene/", "particles/", "cells/"}  # their sources know no state either


def floor_of(file):
    """(number of the floor, its entry) of a file of engine/; none for what is not named."""
    name = file.removeprefix("engine/")
    entries = [(len(entry), number, entry) for number, floor in enumerate(FLOORS) for entry in floor
               if name.startswith(entry)]
    return max(entries)[1:] if entries else None


def check_floors(tree):
    for file in tree.in_folder("engine/"):
        if floor_of(file) is None:
            if file.count("/") > 1:
                yield f"{file}: its folder has no place in FLOORS of check_layering.py"
            continue
        number, entry = floor_of(file)
        strict = file.endswith(".hpp") or number > FACADE or entry in NO_PHASES
        for _, include in tree.includes[file]:
            if not include.startswith("engine/") or floor_of(include) is None:
                continue
            other, other_entry = floor_of(include)
            if strict and other >= number and other_entry != entry:
                yield f"{file}: {entry} must not include {include} (FLOORS in check_layering.py)"
            elif number < FACADE <= other:
                yield f"{file}: includes {include}, which stands on the state that it is part of"


def check_spelling(tree):
    for file in tree.text:
        if file.startswith("tests/embed/"):
            continue  # an outside program: it sees the installed headers
        for bracket, include in tree.includes[file]:
            if bracket == '"' and not (tree.root / include).is_file():
                yield f'{file}: "{include}" is not the path of a file from the root of the repository'


def public_headers(root):
    text = (pathlib.Path(root) / "cmake/public_headers.cmake").read_text("utf-8")
    match = re.search(r"set\(scarp_public_headers\s+([^)]*)\)", text)
    return match.group(1).split() if match else []


def check_public_headers(tree):
    headers = public_headers(tree.root)
    if not headers:
        yield "cmake/public_headers.cmake: no list scarp_public_headers"
    for header in headers:
        if header not in tree.text:
            yield f"cmake/install.cmake: {header} does not exist"
    for file in tree.closure(headers):
        if file not in headers:
            yield f"{file}: included by a public header, but not installed (scarp_public_headers in cmake/public_headers.cmake)"
        for _, include in tree.includes[file]:
            if third_party_in(include):
                yield f"{file}: a public header must not include {third_party_in(include)} ({include})"


def check_kernels(tree):
    kernels = [f for f in tree.in_folder("kernels/") if not is_oracle(f)]
    for file in tree.closure(kernels):
        if is_oracle(file):
            yield f"{file}: a reference for tests, but a kernel includes it"
        for _, include in tree.includes[file]:
            if third_party_in(include) not in (None, "xsimd") or include in NOT_IN_KERNELS:
                yield f"{file}: kernels are arithmetic on views and include no {include}"


def check_machine_flags(tree):
    """Instruction sets are named in cmake/isa.cmake alone."""
    files = [p for p in tree.root.rglob("CMakeLists.txt")] + list((tree.root / "cmake").glob("*"))
    files += [tree.root / "CMakePresets.json"]
    for path in sorted(files):
        name = path.relative_to(tree.root).as_posix()
        if not path.is_file() or name == "cmake/isa.cmake" or name.startswith(("build/", "out/")):
            continue
        for number, line in enumerate(path.read_text("utf-8").splitlines(), 1):
            for flag in MACHINE_FLAG.findall(line.split("#")[0]):
                yield f"{name}:{number}: {flag} belongs in cmake/isa.cmake"
    for file in tree.text:
        if TARGET_IN_SOURCE.search(without_comments(tree.text[file])):
            yield f"{file}: sets an instruction set in the source; only cmake/isa.cmake does"


def check_equations(tree):
    tags = {}
    for file in tree.in_folder("kernels/", "engine/", "validation/"):
        joined = re.sub(r"\n\s*//+!?<?", " ", tree.text[file])  # a tag may run over a line's end
        for match in EQUATION.finditer(joined):
            for identifier in EQUATION_ID.findall(re.sub(r"\([^)]*\)", "", match.group(1))):
                tags.setdefault(identifier, file)
    if not tags:
        return
    register = tree.root / "kernels/EQUATIONS.md"
    if not register.is_file():
        yield f"kernels/EQUATIONS.md: missing, but {len(tags)} equations are named in the sources"
        return
    known = set(EQUATION_ID.findall(register.read_text("utf-8")))
    for identifier, file in sorted(tags.items()):
        if identifier not in known:
            yield f"{file}: equation {identifier} is not in kernels/EQUATIONS.md"


CHECKS = (check_third_party, check_directions, check_floors, check_spelling, check_public_headers, check_kernels,
          check_machine_flags, check_equations)


def violations(root):
    tree = Tree(root)
    if not tree.text:
        return [f"{root}: no source files found"]
    return [line for check in CHECKS for line in check(tree)]


if __name__ == "__main__":
    found = violations(sys.argv[1] if len(sys.argv) > 1 else ".")
    print("\n".join(found) or "layering holds")
    sys.exit(1 if found else 0)
