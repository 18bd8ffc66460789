#!/usr/bin/env python3
"""The house rules find what breaks them."""

import contextlib
import io
import shutil
import tempfile
import unittest
from pathlib import Path

import check


MODULES = """
# creepcontact_module(this is a comment USES creepcontact_nothing)
creepcontact_module(base USES fmt::fmt PRIVATE_USES OpenMP::OpenMP_CXX)
creepcontact_module(mesh USES creepcontact_base)
creepcontact_module(fem USES creepcontact_mesh)
creepcontact_module(ode USES creepcontact_base)
creepcontact_module(config USES creepcontact_base)
creepcontact_module(contact USES creepcontact_fem
                    PRIVATE_USES creepcontact_ode)
creepcontact_module(simulation USES creepcontact_contact)
"""


class Rules(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve()
        self.write("CMakeLists.txt", MODULES)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def broken(self, rule):
        return list(check.RULES[rule](self.root))

    def test_a_module_may_include_what_it_rests_on(self):
        self.write("src/contact/a.cpp", '#include "creepcontact/mesh/mesh.hpp"\n#include "b.hpp"\n#include <vector>\n')
        self.write("src/contact/b.hpp", "")
        self.assertEqual(self.broken("module_includes"), [])

    def test_a_header_that_only_its_own_module_uses_is_not_public(self):
        self.write("include/creepcontact/mesh/mesh.hpp", '#include "creepcontact/mesh/cell.hpp"\n')
        self.write("include/creepcontact/mesh/cell.hpp", "")
        self.write("include/creepcontact/mesh/tree.hpp", "")
        self.write("src/mesh/tree.cpp", '#include "creepcontact/mesh/tree.hpp"\n')
        self.assertEqual(len(self.broken("public_headers")), 3)
        self.write("src/contact/a.cpp", '#include "creepcontact/mesh/mesh.hpp"\n')
        self.assertEqual([line.split(":")[0] for line in self.broken("public_headers")],
                         ["include/creepcontact/mesh/tree.hpp"])
        self.write("tests/style/consumer/main.cpp", "#include <creepcontact/mesh/tree.hpp>\n")
        self.assertEqual(self.broken("public_headers"), [])

    def test_what_a_module_uses_privately_is_its_own(self):
        self.write("cmake/program.cmake", "creepcontact_program(tool creepcontact_tool USES creepcontact_mesh)\n")
        self.write("src/contact/a.cpp", '#include "creepcontact/ode/integrator.hpp"\n')
        self.write("src/tool/a.cpp", '#include "creepcontact/base/error.hpp"\n')
        self.assertEqual(self.broken("module_includes"), [])
        self.write("src/simulation/a.cpp", '#include "creepcontact/ode/integrator.hpp"\n')
        self.write("src/tool/b.cpp", '#include "creepcontact/fem/quadrature.hpp"\n')
        self.assertEqual(len(self.broken("module_includes")), 2)

    def test_subfolders_of_a_module(self):
        self.write("src/contact/solver/a.cpp", '#include "../b.hpp"\n#include "../geometry/c.hpp"\n'
                                               '#include "creepcontact/contact/geometry/pair.hpp"\n')
        self.write("src/contact/b.hpp", '#include "geometry/c.hpp"\n#include "creepcontact/fem/quadrature.hpp"\n')
        self.write("src/contact/geometry/c.hpp", "")
        self.assertEqual(self.broken("module_includes"), [])
        self.write("src/contact/geometry/d.cpp", '#include "../../mesh/e.hpp"\n#include "c/d/f.hpp"\n')
        self.write("include/creepcontact/fem/shapes/a.hpp", '#include "creepcontact/contact/geometry/pair.hpp"\n')
        self.write("src/mesh/e.hpp", "")
        self.write("src/contact/geometry/c/d/f.hpp", "")
        self.assertEqual(len(self.broken("module_includes")), 3)

    def test_a_module_may_not_include_what_rests_on_it(self):
        self.write("include/creepcontact/ode/a.hpp", '#pragma once\n#include "creepcontact/fem/quadrature.hpp"\n')
        self.assertIn("ode/a.hpp:2", self.broken("module_includes")[0])

    def test_headers_of_other_modules_come_by_their_public_name(self):
        self.write("src/fem/a.cpp", '#include "../mesh/b.hpp"\n#include "gone.hpp"\n'
                                    "#include <creepcontact/mesh/mesh.hpp>\n")
        self.write("src/mesh/b.hpp", "")
        self.assertEqual(len(self.broken("module_includes")), 3)

    def test_a_folder_that_is_no_module(self):
        self.write("src/helpers/a.cpp", "#include <vector>\n")
        self.write("src/b.cpp", "")
        self.assertEqual(len(self.broken("module_includes")), 2)

    def test_the_table_of_modules(self):
        rows = "| module | holds | may include |\n|---|---|---|\n| `base` | errors | - |\n| `src/mesh` | cells | `base` |\n"
        self.write("CMakeLists.txt", "creepcontact_module(base)\ncreepcontact_module(mesh USES creepcontact_base)\n")
        self.write("docs/architecture.md", rows)
        self.assertEqual(self.broken("module_table"), [])
        self.write("docs/architecture.md", rows.replace("| - |", "| `mesh` |") + "| `fem` | elements | `mesh` |\n")
        self.assertEqual(len(self.broken("module_table")), 2)

    def test_libraries_stay_at_home(self):
        self.write("src/config/a.cpp", "#include <toml++/toml.h>\n")
        self.write("src/ode/a.cpp", "#include <cvode/cvode.h>\n")
        self.assertEqual(self.broken("library_includes"), [])
        self.write("src/simulation/a.cpp", "#include <toml++/toml.h>\n#include <nvector/nvector_serial.h>\n")
        self.assertEqual(len(self.broken("library_includes")), 2)

    def test_decompositions(self):
        self.write("src/linalg/dense.cpp", "Eigen::JacobiSVD<Eigen::MatrixXd> svd;\n")
        self.write("src/base/tensor.cpp", "Eigen::SelfAdjointEigenSolver<Matrix3> eigen;\n")
        self.write("src/base/a.cpp", "x = a.llt().solve(b);\n")
        self.assertEqual(self.broken("decompositions"), [])
        self.write("src/base/a.cpp", "x = a.colPivHouseholderQr().solve(b);\n#include <Eigen/SVD>\n")
        self.assertEqual([line.split(": ")[0] for line in self.broken("decompositions")], ["src/base/a.cpp:1", "src/base/a.cpp:2"])

    @unittest.skipUnless(shutil.which("clang-format"), "clang-format is not installed")
    def test_formatting(self):
        self.write(".clang-format", "BasedOnStyle: Google\n")
        self.write("src/base/a.cpp", "int a;\n")
        self.assertEqual(self.broken("formatting"), [])
        self.write("src/base/b.cpp", "int  a ;\n")
        self.assertIn("src/base/b.cpp", self.broken("formatting")[0])

    def test_long_files_are_warned_of(self):
        self.write("src/base/a.cpp", "\n" * check.LONG_FILE)
        self.assertEqual(self.broken("file_length"), [])
        self.write("src/base/b.cpp", "\n" * (check.LONG_FILE + 1))
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            self.assertEqual(check.main(["file_length", str(self.root)]), 0)
        self.assertRegex(printed.getvalue(), r"^warning: src/base/b\.cpp .*401")

    def test_machine_paths(self):
        self.write("README.md", "see docs/work/flow.md\nsee /" + "work/flow.md\n")
        found = self.broken("machine_paths")
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith("README.md:2: '/" + "work/'"), found)

    def test_isolated_interpreters(self):
        self.write("scripts/a", "#!/usr/bin/env python3\necho | python3 -c 'x'\npython3 -I - <<END\n# python3 is needed\n")
        self.write("scripts/b", "#!/usr/bin/env -S python3 -I\n")
        self.assertEqual([line.split(": ")[0] for line in self.broken("isolated_interpreters")], ["scripts/a:1", "scripts/a:2"])


if __name__ == "__main__":
    unittest.main()
