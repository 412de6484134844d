"""No include runs from an earlier room to a later one; and the check does see those that would."""

import sys
import tempfile
import unittest
from pathlib import Path

from include_graph import ROOMS, IncludeGraph

PROJECT = Path(sys.argv.pop(1))


class TheProject(unittest.TestCase):
    def test_has_no_wrong_arrow(self):
        self.assertEqual(IncludeGraph(PROJECT).problems, [])

    def test_was_really_read(self):
        graph = IncludeGraph(PROJECT)
        arrows = {(source, target) for source, targets in graph.edges.items() for target in targets}
        self.assertIn(("src/scene/scene.hpp", "src/network/network.hpp"), arrows)
        rooms = {str(Path(file).parent) for file in graph.edges}
        self.assertEqual(set(ROOMS) - rooms, set(), "rooms without a source file")


class APlantedTree(unittest.TestCase):
    """Small trees, right but for one file."""

    GOOD = {
        "src/base/errors.hpp": "#pragma once\n",
        "src/scene/scene.hpp": '#include "base/errors.hpp"\n',
        "src/problem/problem.hpp": '#include "scene/scene.hpp"\n',
        "src/critical/critical.hpp": '#include "problem/problem.hpp"\n',
        "src/simulation/system/system.hpp": '#include "problem/problem.hpp"\n',
        "symbolic/derivation/derivation.hpp": '#include <ginac/ginac.h>\n#include "problem/problem.hpp"\n',
        "symbolic/emit/generate.hpp": '#include "derivation/derivation.hpp"\n',
        "validation/compare/agreement.hpp": '#include "simulation/system/system.hpp"\n#include "critical/critical.hpp"\n',
        "validation/report/report.hpp": '#include "compare/agreement.hpp"\n',
        "app/main.cpp": '#include "report/report.hpp"\n',
        "bench/speed/speed.hpp": '#include <ginac/ginac.h>\n#include "compare/agreement.hpp"\n',
    }

    def problems(self, **changes):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (self.GOOD | changes.pop("files", {})).items():
                file = Path(folder) / name
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
            return IncludeGraph(folder).problems

    def assert_found(self, name, text, expected):
        found = self.problems(files={name: text})
        self.assertEqual(len(found), 1, found)
        self.assertIn(expected, found[0])
        self.assertIn(name, found[0])

    def test_is_right_as_it_stands(self):
        self.assertEqual(self.problems(), [])

    def test_may_include_what_the_build_writes(self):
        files = {
            "validation/report/assets.cpp": '#include "assets.inc"\n',
            "validation/report/assets.inc.in": "int assets;\n",
        }
        self.assertEqual(self.problems(files=files), [])

    def test_may_write_code_with_includes(self):
        text = 'const char* code = R"x(\n#include "other.hpp"\n)x";\n'
        self.assertEqual(self.problems(files={"symbolic/emit/header.cpp": text}), [])

    def test_a_raw_string_hides_nothing_after_it(self):
        text = 'const char* code = R"(\n)";\n#include "scene/scene.hpp"\n'
        self.assert_found("src/base/wrong.cpp", text, "comes after")

    def test_base_may_not_know_the_scene(self):
        self.assert_found("src/base/wrong.cpp", '#include "scene/scene.hpp"\n', "comes after")

    def test_simulation_may_not_know_the_formula(self):
        self.assert_found("src/simulation/motion/wrong.cpp", '#include "critical/critical.hpp"\n', "must not know")

    def test_other_methods_may_not_know_the_exact_one(self):
        for room in ["motion", "steady"]:
            files = {
                f"src/simulation/{room}/exact.hpp": "#pragma once\n",
                "src/simulation/methods/wrong.cpp": f'#include "simulation/{room}/exact.hpp"\n',
            }
            found = self.problems(files=files)
            self.assertEqual(len(found), 1, found)
            self.assertIn("must not know", found[0])

    def test_a_scene_is_resolved_before_it_is_used(self):
        for name in ["src/critical/wrong.cpp", "symbolic/emit/wrong.cpp", "validation/compare/wrong.cpp", "app/wrong.cpp"]:
            self.assert_found(name, '#include "scene/scene.hpp"\n', "resolved before it is used")

    def test_the_simulation_may_ask_the_rulebook(self):
        files = {"src/rules/rulebook.hpp": "#pragma once\n"}
        text = '#include "rules/rulebook.hpp"\n'
        self.assertEqual(self.problems(files=files | {"src/simulation/system/right.cpp": text}), [])

    def test_neither_simulation_nor_indenter_may_know_the_answers(self):
        files = {"src/answers/critical_onset.hpp": "#pragma once\n"}
        for room in ["simulation/steady", "indenter"]:
            wrong = {f"src/{room}/wrong.cpp": '#include "answers/critical_onset.hpp"\n'}
            found = self.problems(files=files | wrong)
            self.assertEqual(len(found), 1, found)
            self.assertIn("comes after", found[0])

    def test_the_rules_may_not_know_the_formula(self):
        self.assert_found("src/rules/wrong.cpp", '#include "critical/critical.hpp"\n', "comes after")

    def test_the_normal_force_may_not_know_the_rules(self):
        files = {"src/rules/rulebook.hpp": "#pragma once\n", "src/normal/wrong.cpp": '#include "rules/rulebook.hpp"\n'}
        found = self.problems(files=files)
        self.assertEqual(len(found), 1, found)
        self.assertIn("comes after", found[0])

    def test_v_star_is_asked_of_the_answers(self):
        files = {"src/critical/certified.hpp": "#pragma once\n"}
        for name in ["src/sweep/wrong.cpp", "src/design/wrong.cpp", "app/wrong.cpp", "python/wrong.cpp"]:
            found = self.problems(files=files | {name: '#include "critical/certified.hpp"\n'})
            self.assertEqual(len(found), 1, found)
            self.assertIn("asked of src/answers", found[0])
        for name in ["src/answers/right.cpp", "validation/compare/right.cpp", "symbolic/analysis/right.cpp"]:
            self.assertEqual(self.problems(files=files | {name: '#include "critical/certified.hpp"\n'}), [])

    def test_the_formula_may_not_know_simulation(self):
        self.assert_found("src/critical/wrong.cpp", '#include "simulation/system/system.hpp"\n', "comes after")

    def test_the_derivation_may_not_know_simulation(self):
        name, text = "symbolic/derivation/wrong.cpp", '#include "simulation/system/system.hpp"\n'
        self.assert_found(name, text, "must not know")

    def test_the_derivation_may_not_know_the_emitter(self):
        name, text = "symbolic/derivation/wrong.cpp", '#include "emit/generate.hpp"\n'
        self.assert_found(name, text, "comes after")

    def test_the_library_may_not_use_algebra(self):
        self.assert_found("src/critical/wrong.cpp", "#include <ginac/ginac.h>\n", "algebra")

    def test_one_room_compiles_decompositions(self):
        self.assert_found("src/critical/wrong.cpp", "#include <Eigen/Dense>\n", "src/linear")
        self.assertEqual(self.problems(files={"src/critical/right.cpp": "#include <Eigen/Core>\n",
                                              "src/linear/lu.cpp": "#include <Eigen/LU>\n"}), [])

    def test_the_product_may_not_know_the_benchmarks(self):
        for room in ["src/base", "symbolic/emit", "validation/report", "app", "python"]:
            self.assert_found(f"{room}/wrong.cpp", '#include "speed/speed.hpp"\n', "comes after")

    def test_a_relative_path_does_not_hide_the_arrow(self):
        self.assert_found("src/base/wrong.hpp", ' # include "../scene/scene.hpp"\n', "comes after")

    def test_a_missing_file_is_named(self):
        self.assert_found("src/base/wrong.hpp", '#include "base/nothing.hpp"\n', "not there")

    def test_a_file_outside_the_rooms_is_named(self):
        self.assert_found("src/wrong.hpp", "#pragma once\n", "in no room")

    def test_a_cycle_inside_a_room_is_found(self):
        files = {
            "src/base/one.hpp": '#include "base/two.hpp"\n',
            "src/base/two.hpp": '#include "one.hpp"\n',
        }
        found = self.problems(files=files)
        self.assertEqual(found, ["cycle: src/base/one.hpp -> src/base/two.hpp -> src/base/one.hpp"])


if __name__ == "__main__":
    unittest.main()
