# SPDX-License-Identifier: BSD-3-Clause
"""Each mutant's expression stands once in its file, so that tests/mutation/run can change it."""
import importlib.machinery
import importlib.util
import pathlib
import tomllib
import unittest

HERE = pathlib.Path(__file__).resolve().parent
LOADER = importlib.machinery.SourceFileLoader("mutation_run", str(HERE / "run"))
MUTATION = importlib.util.module_from_spec(importlib.util.spec_from_loader(LOADER.name, LOADER))
LOADER.exec_module(MUTATION)
MUTANTS = tomllib.loads((HERE / "mutants.toml").read_text(encoding="utf-8"))["mutant"]


class MatchTest(unittest.TestCase):
    def test_every_expression_is_there_once(self):
        sources = MUTATION.Sources()
        for mutant in MUTANTS:
            with self.subTest(file=mutant["file"], what=mutant["what"]):
                try:
                    sources.replace_once(mutant["file"], mutant["from"], lambda text: text)
                except SystemExit as missing:
                    self.fail(str(missing))

    def test_a_missing_expression_is_found(self):
        with self.assertRaises(SystemExit):
            MUTATION.Sources().replace_once(MUTANTS[0]["file"], "an expression that is not there", str)


if __name__ == "__main__":
    unittest.main()
