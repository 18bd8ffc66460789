"""Mesh files that attack, break or disappoint: whatever they hold, the program ends with a sentence and status 3."""

import json
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import unittest

from says import Says
from study_case import BASE, GEOMETRY, PROGRAM
from without_seccomp import forbid_seccomp
from waiting import LONGEST, wait_until

SQUARE = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
1
1 3 2 1 1 1 2 3 4
$EndElements
"""


# Two unit cubes side by side, as Salome and Nastran's preprocessors write them.
NODES = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1, 2)]
CUBES = [[1, 2, 5, 4, 7, 8, 11, 10], [2, 3, 6, 5, 8, 9, 12, 11]]
LEFT_FACE, RIGHT_FACE = [1, 4, 10, 7], [3, 6, 12, 9]


def unv():
    """Groups of elements, by their names: a volume and two faces."""
    def dataset(number, lines):
        return "    -1\n" + f"{number:6}\n" + "".join(line + "\n" for line in lines) + "    -1\n"

    def elements():
        for number, (kind, nodes) in enumerate([(94, LEFT_FACE), (94, RIGHT_FACE), (115, CUBES[0]), (115, CUBES[1])], 1):
            yield "".join(f"{field:10}" for field in (number, kind, 1, 1, 7, len(nodes)))
            yield "".join(f"{node:10}" for node in nodes)

    def groups():
        for number, (name, members) in enumerate((("left", [1]), ("right", [2]), ("bar", [3, 4]), ("corner", [-3, -6])), 1):
            yield "".join(f"{field:10}" for field in (number, 0, 0, 0, 0, 0, 0, len(members)))
            yield name
            fields = [field for member in members for field in (8 if member > 0 else 7, abs(member), 0, 0)]  # 7: a node
            for i in range(0, len(fields), 8):
                yield "".join(f"{field:10}" for field in fields[i:i + 8])

    nodes = [line for number, x in enumerate(NODES, 1)
             for line in (f"{number:10}{1:10}{1:10}{11:10}", "".join(f"{c:25.16E}" for c in x).replace("E", "D"))]
    return dataset(2411, nodes) + dataset(2412, elements()) + dataset(2467, groups())


def bdf():
    """Properties in place of groups: 1 the volume, 2 and 3 the faces."""
    lines = [f"GRID,{number},,{x[0]:.1f},{x[1]:.1f},{x[2]:.1f}" for number, x in enumerate(NODES, 1)]
    lines += [f"CQUAD4,{number},{number + 1}," + ",".join(map(str, nodes)) for number, nodes in ((1, LEFT_FACE), (2, RIGHT_FACE))]
    for number, nodes in enumerate(CUBES, 3):
        lines += [f"CHEXA,{number},1," + ",".join(map(str, nodes[:6])) + f",+{number}", f"+{number}," + ",".join(map(str, nodes[6:]))]
    return "BEGIN BULK\n" + "\n".join(lines) + "\nENDDATA\n"


class MeshTest(Says, unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)
        self.write("cube.geo", GEOMETRY)
        self.write("cube.toml", BASE)
        self.write("msh.toml", BASE.replace("cube.geo", "cube.msh").replace("order = 1\n", ""))

    def write(self, name, text):
        (self.directory / name).write_text(text)

    def call(self, command, *options, **settings):
        return subprocess.run([PROGRAM, command, "cube.toml", *options], cwd=self.directory, capture_output=True,
                              text=True, timeout=LONGEST, **settings)

    def check(self, *options, **settings):
        return self.call("check", *options, **settings)

    def check_msh(self):
        return subprocess.run([PROGRAM, "check", "msh.toml"], cwd=self.directory, capture_output=True, text=True,
                              timeout=LONGEST)

    def made(self, name="made"):
        return (self.directory / name).exists()

    def expect_error(self, done, *facts):
        self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
        for line in done.stderr.splitlines():
            self.assertRegex(line, "^(error|warning): ")
        self.assertSays(done.stderr, *facts)


class Attacks(MeshTest):
    def test_a_geometry_runs_no_program(self):
        self.write("cube.geo", 'SystemCall "touch made";\n' + GEOMETRY)
        self.expect_error(self.check(), "cube.geo:1: 'SystemCall'", "--trust-geometry")
        self.assertFalse(self.made())
        self.assertEqual(self.check("--trust-geometry").returncode, 0)
        self.assertTrue(self.made())

    def test_nor_does_a_statement_that_hides(self):
        self.write("part.geo", '\nSystemCall "touch made";\n')
        self.write("cube.geo", GEOMETRY + 'Include Sprintf("part.geo");\n')
        self.expect_error(self.check(), "cube.geo: ", "tried", "program", "--trust-geometry")
        self.assertFalse(self.made())

    def test_nor_where_there_is_no_seccomp(self):
        self.assertEqual(self.check(preexec_fn=forbid_seccomp).returncode, 0)
        self.write("part.geo", 'SystemCall "touch made";\n')
        self.write("cube.geo", GEOMETRY + 'Include Sprintf("part.geo");\n')
        self.expect_error(self.check(preexec_fn=forbid_seccomp), "cube.geo: ", "seccomp", "--trust-geometry")
        self.write("cube.geo", GEOMETRY + 'Include "part.geo";\n')
        self.expect_error(self.check(preexec_fn=forbid_seccomp), "part.geo:1: 'SystemCall'")
        self.assertFalse(self.made())

    def with_parameters(self, line):
        self.write("cube.toml", BASE.replace("order = 1\n", "order = 1\n[mesh.parameters]\n" + line + "\n"))

    def test_names_of_parameters_run_no_program(self):
        run = 'SystemCall "touch made"; x'
        for name, text in (("a", f"DefineConstant[ '{run}' = 1 ];\n"), ("b", f"DefineConstant[ {{1, '{run}'}}, n = 2 ];\n"),
                           ("c", f"DefineConstant[ n = {{2, Name '{run}', '{run}' = 3}}, '{run}' ];\n"),
                           ("d", 'DefineConstant[ n = 2 ];\n')):
            self.write("cube.geo", text + GEOMETRY)
            self.with_parameters(f"{json.dumps(run)} = 1")
            for options in ({}, {"preexec_fn": forbid_seccomp}):
                done = self.check(**options)
                self.assertEqual(done.returncode, 2, name + done.stderr)
                self.assertSays(done.stderr, "mesh.parameters: ", "underscores")
            self.check("--trust-geometry")
            self.assertFalse(self.made())
        for name in ('x = 1; y', 'System "touch made"; y', "x\ny", "1x", "x.y", "\u00e9", "", " x"):
            self.with_parameters(f"{json.dumps(name)} = 1")
            self.assertEqual(self.check("--trust-geometry").returncode, 2, name)
        for value in ("inf", "nan"):
            self.write("cube.geo", "DefineConstant[ n = 2 ];\n" + GEOMETRY)
            self.with_parameters(f"n = {value}")
            self.assertEqual(self.check().returncode, 2)
        self.assertFalse(self.made())

    def test_the_mesher_takes_no_other_names(self):
        mesher = pathlib.Path(os.environ.get("CREEPCONTACT_MESHER") or pathlib.Path(PROGRAM).with_name("creepcontact-mesher"))
        if not mesher.exists():
            self.skipTest("creepcontact-mesher is elsewhere")
        done = subprocess.run([mesher, self.directory / "cube.geo", "3", "1", "0", "1", "0", 'System "touch made"; x', "1"],
                              cwd=self.directory, capture_output=True, text=True, timeout=LONGEST,
                              preexec_fn=lambda: os.dup2(2, 3))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertFalse(self.made())

    def hostile(self):
        """Geometries that a look for statements may miss."""
        self.write("part.geo", 'SystemCall "touch made";\n')
        self.write("part.stp", 'SystemCall "touch made";\n')
        self.write("part.BREP", 'SystemCall "touch made";\n')
        self.write("large.geo", 'SystemCall "touch made";\n' + "//\n" * 6_000_000)
        (self.directory / "C:").mkdir(exist_ok=True)
        self.write("C:/part.geo", 'SystemCall "touch made";\n')
        self.write("$(touch made).gz", "x\n")
        self.write("a;touch made;.gz", "x\n")
        long = "x" * 1023
        return {
            "macro": 'Macro run /*\nSystemCall "touch made";\nReturn\n*/\nReturn\nCall run;\n',
            "macro_line": "Macro run // '\nSystemCall 'touch made';\nReturn\nCall run;\n",
            "long": f'a = "{long}; SystemCall "touch made"; b = "";\n',
            "long_include": f'a = "{long}; Include "part.geo"; b = "";\n',
            "nul": '// \0 SystemCall "touch made";\n',
            "nul_include": '// \0 Include "part.geo";\n',
            "name": 'StringToName["SystemCall"] "touch made";\n',
            "s2n": 'S2N[StrCat("System", "Call")] "touch made";\n',
            "named_include": 'S2N["Include"] "part.geo";\n',
            "box": 'MergeWithBoundingBox "part.geo";\n',
            "cad": 'Include "part.stp";\n',
            "cad_case": 'Merge "part.BREP";\n',
            "large": 'Include "large.geo";\n',
            "drive": 'Include "C:/part.geo";\n',
            "gz": 'Merge "$(touch made).gz";\n',
            "gz_semicolon": 'Merge "a;touch made;.gz";\n',
            "gz_computed": 'Merge StrCat("a;touch made;.", "gz");\n',
            "field": GEOMETRY + 'Field[1] = ExternalProcess;\nField[1].CommandLine = "touch made";\nBackground Field = 1;\n',
            "field_text": GEOMETRY + 'Field[1] = ExternalProcess;\nField[1].CommandLine = StrCat("touch ", "made");\nBackground Field = 1;\n',
            "onelab": 'OnelabRun("a", "touch made");\n',
            "condition": 'If(0)\n"\nEndIf\nSystemCall "touch made";\nElse " EndIf\n',
            "printf": 'Printf("a") > "made";\n',
            "printf_computed": 'Printf("a") >> StrCat("ma", "de");\n',
            "view": 'View "a" { SP(0,0,0){1}; };\nSave View[0] "made";\n',
            "syntax": 'Point(1) = ; SystemCall "touch made";\n',
        }

    def test_no_hostile_geometry_runs_a_program(self):
        for name, text in self.hostile().items():
            self.write("cube.geo", text if text.startswith("Point(1) = {0") else text + GEOMETRY)
            for options in ({}, {"preexec_fn": forbid_seccomp}):
                done = self.check(**options)
                self.assertFalse(self.made(), f"{name} {options}: {done.stderr}")
                self.assertIn(done.returncode, (0, 2, 3), name + done.stderr)

    def test_meshes_of_other_programs_run_no_program(self):
        for extension in ("unv", "bdf", "nas", "med"):
            for head in ("", "$MeshFormat\n", "-1\n", "$PostFormat\n", "View \"a\" {\n", "    -1\n  2411\n"):
                self.write("cube." + extension, head + 'SystemCall "touch made";\n')
                self.write("cube." + extension + ".opt", 'SystemCall "touch made";\n')
                self.write("cube.toml", BASE.replace("cube.geo", "cube." + extension).replace("order = 1\n", ""))
                for options in ({}, {"preexec_fn": forbid_seccomp}):
                    self.assertNotEqual(self.check(**options).returncode, 0)
                    self.assertFalse(self.made())

    def test_trust_reaches_the_runs_of_a_study(self):
        self.write("cube.geo", 'SystemCall "touch made";\n' + GEOMETRY)
        self.write("study.toml", 'base = "cube.toml"\n[[runs]]\nset = { time.end = 0.2, time.output = [0.2] }\n')
        command = [PROGRAM, "study", "study.toml"]
        done = subprocess.run(command, cwd=self.directory, capture_output=True, text=True, timeout=LONGEST)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("SystemCall", done.stdout + done.stderr)
        done = subprocess.run([*command, "--trust-geometry"], cwd=self.directory, capture_output=True, text=True,
                              timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_mesh_runs_no_program(self):
        self.write("cube.msh", 'SystemCall "touch made";\n' + SQUARE)
        self.write("cube.msh.opt", 'SystemCall "touch made";\n')
        self.write("cube.geo.opt", 'SystemCall "touch made";\n')
        self.expect_error(self.check_msh(), "cube.msh: ", "$MeshFormat")
        self.write("cube.msh", SQUARE)
        self.expect_error(self.check_msh(), "cube.msh")
        self.assertEqual(self.check().returncode, 0)
        self.assertFalse(self.made())

    def test_settings_of_the_user_are_not_read(self):
        for name in (".gmshrc", ".gmsh-options"):
            self.write(name, 'SystemCall "touch made";\n')
        self.assertEqual(self.check(env={**os.environ, "HOME": str(self.directory)}).returncode, 0)
        self.assertFalse(self.made())

    def test_exit_is_no_success(self):
        self.write("cube.geo", GEOMETRY + "Exit;\n")
        self.expect_error(self.call("run"), "'Exit'", "--trust-geometry")
        self.expect_error(self.call("run", "--trust-geometry"), "cube.geo: ", "Exit")


class Ends(MeshTest):
    def test_endless_loop(self):
        self.write("cube.geo", "For i In {1 : 2}\n  i = 1;\nEndFor\n")
        self.expect_error(self.check("--set", "mesh.time_limit=0.5"), "cube.geo: ", "mesh.time_limit = 0.5 s")

    def test_endless_words(self):
        self.write("cube.geo", 'For i In {1 : 2}\n  i = 1; Printf("Warning : all is well");\nEndFor\n')
        for seconds in (1, 10, 100):  # Gmsh's start takes longer on a busy machine
            done = self.check("--set", f"mesh.time_limit={seconds}")
            if "all is well" in done.stderr:
                break
        self.expect_error(done, f"mesh.time_limit = {seconds} s", "all is well (", " times)")
        self.assertLess(len(done.stderr), 5000)

    def test_memory(self):
        if subprocess.run(["grep", "-q", "__asan_init", PROGRAM]).returncode == 0:
            self.skipTest("the address sanitizer takes more than any bound")
        self.write("cube.geo", "a[] = {1:1e9};\n" + GEOMETRY)
        self.expect_error(self.check("--set", "mesh.memory_limit_mb=50"), "cube.geo: ", "mesh.memory_limit_mb = 50")

    def test_a_file_that_includes_itself(self):
        self.write("cube.geo", 'Include "cube.geo";\n')
        self.expect_error(self.check(), "cube.geo: Gmsh", "includes itself")

    def test_damaged_meshes(self):
        self.write("cube.geo", GEOMETRY + 'Mesh.MshFileVersion = 4.1;\nMesh.Binary = 1;\nMesh 3;\nSave "cube.msh";\n')
        self.assertEqual(self.check("--trust-geometry").returncode, 0)
        whole = (self.directory / "cube.msh").read_bytes()
        self.assertEqual(self.check_msh().returncode, 0)
        for size in range(0, whole.rindex(b"$EndElements"), 997):
            (self.directory / "cube.msh").write_bytes(whole[:size])
            self.expect_error(self.check_msh(), "cube.msh")

    def test_the_mesher_ends_with_the_program(self):
        self.write("cube.geo", "For i In {1 : 2}\n  i = 1;\nEndFor\n")
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL):
            process = subprocess.Popen([PROGRAM, "check", "cube.toml"], cwd=self.directory, stderr=subprocess.DEVNULL)
            self.addCleanup(process.kill)
            mesher = self.child_of(process.pid)
            process.send_signal(number)
            process.wait(timeout=LONGEST)
            wait_until(lambda: not pathlib.Path(f"/proc/{mesher}").exists(), f"the mesher ends after {number}")

    def child_of(self, process):
        children = pathlib.Path(f"/proc/{process}/task/{process}/children")
        found = []

        def look():
            for child in children.read_text().split():
                # between fork and exec it still has the name of its parent
                if pathlib.Path(f"/proc/{child}/cmdline").read_bytes().startswith(b"/") and \
                        b"creepcontact-mesher" in pathlib.Path(f"/proc/{child}/cmdline").read_bytes():
                    found.append(child)
            return found

        wait_until(look, "a mesher is started")
        return found[0]


class Surroundings(MeshTest):
    def test_closed_descriptors(self):
        for closed in ((0,), (0, 1), (0, 1, 2)):
            done = self.check(preexec_fn=lambda: [os.close(number) for number in closed])
            if 1 not in closed:
                self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotEqual(done.returncode, 3, done.stderr)

    def test_no_temporary_directory(self):
        done = self.check(env={**os.environ, "TMPDIR": "/nowhere"})
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_mesher_that_is_not_there(self):
        done = self.check(env={**os.environ, "CREEPCONTACT_MESHER": "/nowhere/mesher"})
        self.expect_error(done, "'/nowhere/mesher'", "No such file or directory")

    def test_side_by_side(self):
        processes = [subprocess.Popen([PROGRAM, "check", "cube.toml"], cwd=self.directory, stdout=subprocess.PIPE,
                                      stderr=subprocess.STDOUT) for _ in range(3)]
        outputs = [process.communicate(timeout=LONGEST)[0] for process in processes]
        self.assertEqual([process.returncode for process in processes], [0, 0, 0])
        without_memory = [re.sub(rb"memory: \d+ MB", b"", output) for output in outputs]  # that of the process itself
        self.assertEqual(len(set(without_memory)), 1)

    def test_libraries_at_the_start(self):
        """Gmsh and what comes with it (OpenCASCADE, FLTK, VTK) are the mesher's alone."""
        loaded = subprocess.run([PROGRAM, "--version"], env={**os.environ, "LD_TRACE_LOADED_OBJECTS": "1"},
                                capture_output=True, text=True).stdout.split("\n\t")
        self.assertEqual([name for name in loaded if re.search("gmsh|libTK|fltk|vtk|libX11|libGL", name)], [])
        self.assertLess(len(loaded), 34)


class Disappointments(MeshTest):
    def test_a_mesh_of_surfaces(self):
        self.write("cube.msh", SQUARE)
        self.expect_error(self.check_msh(), "cube.msh: ", "surface cells", 'analysis = "axisymmetric"')
        self.write("cube.geo", 'SetFactory("OpenCASCADE");\nRectangle(1) = {0, 0, 0, 1, 1};\n'
                   'Physical Surface("cube") = {1};\n')
        self.expect_error(self.check(), "cube.geo: ", "surface cells", 'analysis = "axisymmetric"')

    def test_pyramids(self):
        self.write("cube.geo", GEOMETRY.split("Physical")[0] +
                   "Transfinite Surface{out[0]}; Recombine Surface{out[0]};\nMesh.Algorithm3D = 1;\n"
                   "p[] = Extrude {0, 0, 100} { Surface{out[0]}; };\nPhysical Volume(\"cube\") = {p[1]};\n")
        done = self.check()
        self.expect_error(done, "cube.geo: ", "'cube'", "'Pyramid ", "hexahedra")

    def test_a_missing_file(self):
        self.write("cube.toml", BASE.replace("cube.geo", "cubee.geo"))
        self.expect_error(self.check(), "cube.toml:2:8: mesh.file: ", "'cubee.geo'", "'cube.geo'")
        self.write("cube.toml", BASE.replace("cube.geo", "turbine.geo"))
        self.expect_error(self.check(), "cube.toml:2:8: mesh.file: ", "'turbine.geo'", "cube.geo")
        self.write("cube.toml", BASE.replace("cube.geo", "none/cube.geo"))
        self.expect_error(self.check(), "cube.toml:2:8: mesh.file: ", "directory 'none'")


class OtherFormats(MeshTest):
    """A bar of two cubes, pulled: through Gmsh's readers."""

    CONFIG = """[mesh]
file = "{file}"
[bodies.bar]
region = "{bar}"
material = "steel"
[materials.steel]
young_modulus = 1e5
poisson_ratio = 0.0
[[supports]]
on = "{left}"
displacement = {{ x = 0, y = 0, z = 0 }}
[[loads]]
on = "{right}"
traction = [100, 0, 0]
[time]
end = 1
[[probes]]
name = "u"
quantity = "displacement_x"
on = "{probe}"
"""

    def run_mesh(self, file, content, **groups):
        self.write(file, content)
        self.write("bar.toml", self.CONFIG.format(**{"file": file, "probe": groups["right"], **groups}))
        done = subprocess.run([PROGRAM, "run", "bar.toml", "--output", "results", "--set", "output.frd=true"], cwd=self.directory,
                              capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertAlmostEqual(float((self.directory / "results/history.csv").read_text().split(",")[-1]), 0.002, delta=1e-9)
        self.assertRegex((self.directory / "results/fields.frd").read_text(), r"(?m)^ -1 +3 +1 +0 +1$")  # its number
        return done.stdout + done.stderr

    def test_unv_groups_of_other_programs(self):
        """A node of a group that no element has is left out; of groups with one name that of nodes is told by its kind."""
        orphan = unv().replace("    -1\n    -1\n  2412", f"{99:10}{1:10}{1:10}{11:10}\n" + "   5.0000000000000000D-01" * 3 + "\n    -1\n    -1\n  2412", 1)
        self.assertIn("        99", orphan)
        group = f"{9:10}" + f"{0:10}" * 6 + f"{{n:10}}\n{{name}}\n" + "{members}\n    -1\n"

        def with_group(text, name, nodes):
            members = "".join(f"{field:10}" for node in nodes for field in (7, node, 0, 0))
            return text[:text.rindex("    -1\n")] + group.format(n=len(nodes), name=name, members=members)
        said = self.run_mesh("bar.unv", with_group(orphan, "all", [1, 99]), bar="bar", left="left", right="right")
        self.assertSays(said, "warning: ", "1 of 2 nodes", "'all'")
        said = self.run_mesh("bar.unv", with_group(unv(), "left", [1, 2]), bar="bar", left="left", right="right")
        self.assertSays(said, "warning: ", "'left'", "2 nodes", "'left (nodes)'")
        self.run_mesh("bar.unv", with_group(unv(), "left", LEFT_FACE), bar="bar", left="left (nodes)", right="right")
        self.run_mesh("bar.unv", with_group(orphan, "none", [99]), bar="bar", left="left", right="right")

    def test_decks_as_meshes(self):
        """Sets of elements, surfaces and sets of nodes; materials and steps of the deck do not count."""
        nodes = "".join(f"{1 + k + 2 * j + 4 * i}, {i}, {j}, {k}\n" for i in range(3) for j in (0, 1) for k in (0, 1))
        elements = "3, 1, 3, 4, 2, 5, 7, 8, 6\n4, 5, 7, 8, 6, 9, 11, 12, 10\n"
        deck = (f"** a mesh alone\n*NODE, NSET=Nall\n{nodes}*ELEMENT, TYPE=C3D8, ELSET=Bar\n{elements}*NSET, NSET=Left\n1, 2, 3, 4\n"
                "*SURFACE, NAME=Right, TYPE=ELEMENT\n4, S2\n")
        self.run_mesh("bar.inp", deck, bar="Bar", left="Left", right="Right")
        # of a mesh program: the faces on the right are elements too, in a set of theirs
        faces = "*ELEMENT, TYPE=CPS4, ELSET=right faces\n5, 9, 10, 12, 11\n*ELEMENT, TYPE=T3D2, ELSET=edge\n6, 1, 2\n"
        said = self.run_mesh("salome.inp", deck + faces, bar="Bar", left="Left", right="right faces")
        self.assertSays(said, "warning: ", "salome.inp", "left out")
        finished = deck + "*MATERIAL, NAME=M\n*ELASTIC\n1., 0.\n*SOLID SECTION, ELSET=Bar, MATERIAL=M\n*STEP\n*STATIC\n*END STEP\n"
        self.run_mesh("finished.inp", finished, bar="Bar", left="Left", right="Right")

    def test_unv_with_groups(self):
        self.run_mesh("bar.unv", unv(), bar="bar", left="left", right="right")
        self.run_mesh("bar.unv", unv(), bar="bar", left="left", right="right", probe="corner")

    def test_bdf_by_its_properties(self):
        self.run_mesh("bar.bdf", bdf(), bar="volume_1", left="surface_2", right="surface_3")

    def test_damaged_or_of_an_unknown_kind(self):
        self.write("bar.toml", self.CONFIG.format(file="bar.unv", bar="bar", left="left", right="right", probe="right"))
        for content in ("", "    -1\n  2411\n", unv().replace("D+00", "X+00"), "\x00" * 1000):
            self.write("bar.unv", content)
            done = subprocess.run([PROGRAM, "check", "bar.toml"], cwd=self.directory, capture_output=True, text=True, timeout=LONGEST)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertRegex(done.stderr, "error: .*bar.unv")


if __name__ == "__main__":
    unittest.main()
