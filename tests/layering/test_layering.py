# SPDX-License-Identifier: BSD-3-Clause
"""Each rule of check_layering.py, check_isa_symbols.py and check_mutable_state.py reports a tree that breaks it, and only then."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import check_isa_symbols
import check_layering
import check_mutable_state

CLEAN = {
    "cmake/public_headers.cmake": "set(scarp_public_headers engine/simulation.hpp)",
    "cmake/isa.cmake": "scarp_add_isa(avx2 -mavx2)",
    "kernels/simd.hpp": "#include <xsimd/xsimd.hpp>\n/// Equation: E25, S1; W. Equation: E12 (outer).",
    "kernels/EQUATIONS.md": "| E25 | S1 | E12 |",
    "engine/simulation.hpp": "#include <vector>\n// #include <Eigen/Dense> and omp in a comment",
    "engine/parallel.hpp": "#include <omp.h>\n#pragma omp parallel",
    "engine/cells.cpp": '#include "kernels/simd.hpp"\n#include "engine/parallel.hpp"',
    "engine/output/frames.cpp": '#include <hdf5.h>\n#include "engine/simulation.hpp"',
    "engine/state.hpp": '#include "engine/watch/watch.hpp"',
    "engine/watch/watch.hpp": '#include "engine/scene/scene.hpp"\n#include "engine/watch/lost.hpp"',
    "engine/watch/watch.cpp": '#include "engine/state.hpp"',
    "engine/watch/lost.hpp": "",
    "engine/scene/scene.hpp": "",
    "kernels/sweep_reference.cpp": "#include <Eigen/Dense>\n#include <vector>",
}
BROKEN = {
    "xsimd in the engine": {"engine/a.cpp": "#include <xsimd/xsimd.hpp>"},
    "HDF5 outside output": {"engine/a.cpp": "#include <hdf5.h>"},
    "omp.h": {"engine/a.cpp": "#include <omp.h>"},
    "OpenMP pragma": {"validation/a.cpp": "#pragma omp parallel for"},
    "kernel includes engine": {"kernels/a.hpp": '#include "engine/simulation.hpp"'},
    "kernel includes JSON": {"kernels/a.hpp": "#include <nlohmann/json.hpp>"},
    "kernel allocates": {"kernels/a.hpp": "#include <vector>"},
    "kernel with Eigen": {"kernels/a.hpp": "#include <Eigen/Dense>"},
    "kernel includes a reference": {"kernels/a.hpp": '#include "kernels/sweep_reference.cpp"'},
    "engine includes validation": {"engine/a.cpp": '#include "validation/a.hpp"', "validation/a.hpp": ""},
    "library includes cli": {"engine/a.cpp": '#include "engine/cli/a.hpp"', "engine/cli/a.hpp": ""},
    "cli includes the Python module": {"engine/cli/a.cpp": '#include "engine/python/a.hpp"', "engine/python/a.hpp": ""},
    "Python in the library": {"engine/a.cpp": "#include <pybind11/pybind11.h>"},
    "header of a lower floor includes a higher one": {
        "engine/cells/a.hpp": '#include "engine/sweep/a.hpp"', "engine/sweep/a.hpp": ""},
    "header of the same floor, another folder": {
        "engine/cells/a.hpp": '#include "engine/step/a.hpp"', "engine/step/a.hpp": ""},
    "header of a phase includes the state": {
        "engine/watch/a.hpp": '#include "engine/state.hpp"', "engine/state.hpp": ""},
    "reader includes a check": {"engine/scene/a.cpp": '#include "engine/check/a.hpp"', "engine/check/a.hpp": ""},
    "reader includes particles": {
        "engine/scene/a.cpp": '#include "engine/particles/a.hpp"', "engine/particles/a.hpp": ""},
    "output includes the loop": {"engine/output/a.cpp": '#include "engine/run/a.hpp"', "engine/run/a.hpp": ""},
    "folder without a floor": {"engine/odds/a.cpp": ""},
    "phase includes the facade": {"engine/watch/a.cpp": '#include "engine/simulation.hpp"'},
    "CLI11 in the library": {"engine/a.cpp": "#include <CLI/CLI.hpp>"},
    "include by relative path": {"engine/a.cpp": '#include "simulation.hpp"'},
    "public header with TOML": {"engine/simulation.hpp": "#include <toml++/toml.h>"},
    "public header with Eigen": {"engine/simulation.hpp": "#include <Eigen/Dense>"},
    "public header reaches a private one": {"engine/simulation.hpp": '#include "engine/parallel.hpp"'},
    "flag in CMakeLists": {"engine/CMakeLists.txt": "target_compile_options(a PRIVATE -mavx2)"},
    "flag in a preset": {"CMakePresets.json": '{"CMAKE_CXX_FLAGS": "-O3 -march=native"}'},
    "target attribute": {"engine/a.cpp": '__attribute__((target("avx2"))) void f();'},
    "unknown equation": {"kernels/a.hpp": "/// Equation: E25,\n/// E99; text"},
    "no register": {"kernels/EQUATIONS.md": None},
}


def found_in(files):
    with tempfile.TemporaryDirectory() as root:
        for name, text in files.items():
            if text is not None:
                path = pathlib.Path(root, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
        return check_layering.violations(root)


class CheckLayeringTest(unittest.TestCase):
    def test_accepts_a_clean_tree(self):
        self.assertEqual(found_in(CLEAN), [])

    def test_reports_each_broken_rule(self):
        for rule, change in BROKEN.items():
            with self.subTest(rule):
                self.assertNotEqual(found_in(CLEAN | change), [])

    def test_reports_an_empty_tree(self):
        self.assertNotEqual(found_in({}), [])


class CheckIsaSymbolsTest(unittest.TestCase):
    COMPILER, NM = "c++", "nm"

    def found_in(self, isa_source, other_source):
        with tempfile.TemporaryDirectory() as root:
            objects = []
            for name, source in (("isa", isa_source), ("other", other_source)):
                path = pathlib.Path(root, name + ".cpp")
                path.write_text(source)
                objects.append(str(path.with_suffix(".o")))
                subprocess.run([self.COMPILER, "-c", "-O0", str(path), "-o", objects[-1]], check=True)
            return list(check_isa_symbols.violations(self.NM, objects[:1], objects[1:]))

    KERNEL = "namespace scarp::kernels { template <class T> T twice(T a) { return a + a; } %s }"

    def test_accepts_own_templates(self):
        source = self.KERNEL % "template double twice(double);"
        self.assertEqual(self.found_in(source, "int other() { return 1; }"), [])

    def test_reports_a_weak_function_of_the_standard_library(self):
        source = "#include <algorithm>\ndouble f(double a, double b) { return std::max(a, b); }"
        self.assertNotEqual(self.found_in(source, "int other() { return 1; }"), [])

    def test_reports_a_kernel_function_that_is_also_compiled_elsewhere(self):
        source = self.KERNEL % "template double twice(double);"
        self.assertNotEqual(self.found_in(source, source), [])


class CheckMutableStateTest(unittest.TestCase):
    COMPILER, OBJDUMP = "c++", "objdump"

    def found_in(self, source):
        with tempfile.TemporaryDirectory() as root:
            path = pathlib.Path(root, "a.cpp")
            path.write_text("namespace scarp { extern int read; " + source + " }")
            subprocess.run([self.COMPILER, "-c", "-O2", "-fPIC", str(path), "-o", str(path) + ".o"], check=True)
            return list(check_mutable_state.violations(self.OBJDUMP, [str(path) + ".o"]))

    def test_accepts_constants_and_tables_of_pointers(self):
        self.assertEqual(self.found_in("""extern const int fixed = 3; void f(); extern void (*const calls[])() = {f};
                                          const char* name() { static const char text[] = "x"; return text; }"""), [])

    def test_reports_what_can_be_written(self):
        for source in ("int count = 0;", "int count = 1;", "thread_local int count;",
                       "int next() { static int count = 5; return ++count; }",
                       "extern int made(); int once() { static const int value = made(); return value; }"):
            with self.subTest(source):
                self.assertNotEqual(self.found_in(source), [])


if __name__ == "__main__":
    if len(sys.argv) > 3:
        CheckIsaSymbolsTest.COMPILER, CheckIsaSymbolsTest.NM = sys.argv[1:3]
        CheckMutableStateTest.COMPILER, CheckMutableStateTest.OBJDUMP = sys.argv[1], sys.argv[3]
    unittest.main(argv=sys.argv[:1])
