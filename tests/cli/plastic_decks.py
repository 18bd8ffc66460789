"""Decks with *PLASTIC, and what CalculiX makes of them.

usage: python3 plastic_decks.py INCREMENTS

prints VALUES, which are in this file so that tests need no ccx: of each deck, at the end of each step, the displacements of some
nodes and the largest equivalent plastic strain at integration points. Those below are of ccx 2.20 with 640 increments in a step.
"""

import math
import pathlib
import re
import subprocess
import sys
import tempfile


def step(cards, procedure="*STATIC\n1., 1."):
    return f"*STEP, INC=10000\n{procedure}\n{cards}*NODE PRINT, NSET=Nall\nU\n*EL PRINT, ELSET=Body\nS, PEEQ\n*END STEP\n"


class Grid:
    """Quadratic elements in a grid; place(i, j, k) is where its corners and middles of edges, of whole and half numbers, are."""

    def __init__(self, n, place, kind, elset, after=None):
        dim = len(n)
        n = (*n, 0)[:3]
        first_node, self.first_element = (len(after.nodes), len(after.elements)) if after else (0, 0)
        steps = [(i, j, k) for k in range(2 * n[2] + 1) for j in range(2 * n[1] + 1) for i in range(2 * n[0] + 1)
                 if i % 2 + j % 2 + k % 2 <= 1]
        self.numbers = {p: first_node + m for m, p in enumerate(steps, 1)}
        self.nodes = {self.numbers[p]: (*place(*(x / 2 for x in p)), 0)[:3] for p in steps}
        corners = ((0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2))[:2**dim]
        edges = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))[:8 * dim - 12]
        places = corners + tuple(tuple((corners[a][d] + corners[b][d]) // 2 for d in range(3)) for a, b in edges)
        self.elements = [[self.numbers[2 * i + a, 2 * j + b, 2 * k + c] for a, b, c in places]
                         for k in range(max(n[2], 1)) for j in range(n[1]) for i in range(n[0])]
        newline = "\n"
        self.text = "*NODE, NSET=Nall\n" + "".join(f"{number}, {', '.join(f'{x:.10g}' for x in at)}\n"
                                                   for number, at in self.nodes.items())
        self.text += f"*ELEMENT, TYPE={kind}, ELSET={elset}\n" + "".join(
            f"{number}, {', '.join(map(str, own[:10]))}{',' + newline if dim == 3 else ''}{', '.join(map(str, own[10:]))}\n"
            for number, own in enumerate(self.elements, self.first_element + 1))

    def sets(self, **sides):
        return "".join(f"*NSET, NSET={name}\n" + "".join(f"{number},\n" for place, number in self.numbers.items() if lies(*place))
                       for name, lies in sides.items())

    def prescribed(self, lies, components):
        """Lines of *BOUNDARY: components {direction: function of the node's place}."""
        return "".join(f"{number}, {d}, {d}, {value(*self.nodes[number]):.10g}\n" for place, number in self.numbers.items()
                       if lies(*place) for d, value in components.items())


def material(name, plastic, elset):
    return f"*MATERIAL, NAME={name}\n*ELASTIC\n2e5, 0.3\n{plastic}*SOLID SECTION, ELSET={elset}, MATERIAL={name}\n"


def bar():
    """Bent beyond yield, then twisted and bent back."""
    grid = Grid((2, 2, 5), lambda i, j, k: (2 * (i - 1), 2 * (j - 1), 4 * k), "C3D20R", "Body")
    at_top = lambda i, j, k: k == 10
    twist = {1: lambda x, y, z: 0.1 - 0.06 * y, 2: lambda x, y, z: 0.06 * x}
    return (grid.text + grid.sets(Root=lambda i, j, k: k == 0, Top=at_top) + "*BOUNDARY\nRoot, 1, 3\n" +
            material("M", "*PLASTIC\n200, 0\n260, 0.002\n300, 0.01\n", "Body") +
            step("*BOUNDARY\nTop, 1, 1, 0.25\n") + step("*BOUNDARY\n" + grid.prescribed(at_top, twist))), [grid], ("Body",)


def cylinder():
    """Perfectly plastic, under pressure until more than half of the wall has yielded, then without."""
    grid = Grid((48, 1), lambda i, j, k: (10 * 2**(i / 48), j), "CAX8R", "Body")
    return (grid.text + grid.sets(Ends=lambda i, j, k: j in (0, 2)) + "*BOUNDARY\nEnds, 2\n" +
            material("M", "*PLASTIC\n200, 0\n", "Body") + step("*DLOAD\n1, P4, 150.\n") + step("*DLOAD\n1, P4, 0.\n")), [grid], ("Body",)


def plate():
    """A quarter of a plate with a hole in plane strain, pulled."""
    def place(i, j, k):
        angle = math.pi / 2 * (1 - i / 6)
        c, s = math.cos(angle), math.sin(angle)
        r = 5 + (20 / max(c, s) - 5) * (j / 4)**1.5
        return r * c, r * s
    grid = Grid((6, 4), place, "CPE8R", "Body")
    pulled = "".join(f"{19 + i}, P3, -140.\n" for i in range(3))
    return (grid.text + grid.sets(X0=lambda i, j, k: i == 0, Y0=lambda i, j, k: i == 12) + "*BOUNDARY\nX0, 1\nY0, 2\n" +
            material("M", "*PLASTIC\n200, 0\n250, 0.01\n", "Body") + step("*DLOAD\n" + pulled)), [grid], ("Body",)


def heated():
    """A bar between walls whose one end becomes hotter than the other, and cold again; all constants depend on T."""
    grid = Grid((1, 1, 3), lambda i, j, k: (2 * i, 2 * j, 3 * k), "C3D20R", "Body")
    sides = grid.sets(X0=lambda i, j, k: i == 0, Y0=lambda i, j, k: j == 0, Walls=lambda i, j, k: k in (0, 6), Hot=lambda i, j, k: k >= 4)
    return (grid.text + sides + "*BOUNDARY\nX0, 1\nY0, 2\nWalls, 3\n*MATERIAL, NAME=M\n*ELASTIC\n2e5, 0.3, 20\n1.6e5, 0.32, 620\n"
            "*EXPANSION, ZERO=20\n1.2e-5, 20\n1.5e-5, 620\n*PLASTIC\n200, 0, 20\n300, 0.01, 20\n100, 0, 620\n140, 0.01, 620\n"
            "*SOLID SECTION, ELSET=Body, MATERIAL=M\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNall, 70\n" +
            step("*TEMPERATURE\nNall, 220\nHot, 420\n") + step("*TEMPERATURE\nNall, 70\n")), [grid], ("Body",)


def blocks():
    """An elastic block pressed askew on one that yields, in a die, then the other way; the meshes of both do not match."""
    lower = Grid((8, 8), lambda i, j, k: (1.25 * i, 1.25 * j), "CPE8R", "Lower")
    upper = Grid((6, 4), lambda i, j, k: (5 / 3 * i, 10 + 2.5 * j), "CPE8R", "Upper", after=lower)
    at_top = lambda i, j, k: j == 8
    pressed = [upper.prescribed(at_top, {2: lambda x, y, z: -0.03 + side * 0.012 * math.cos(math.pi * x / 10)}) for side in (-1, 1)]
    return (lower.text + upper.text + "*ELSET, ELSET=Body\nLower, Upper\n" +
            lower.sets(Base=lambda i, j, k: j == 0, Die=lambda i, j, k: i in (0, 16)) + upper.sets(Die=lambda i, j, k: i in (0, 12)) +
            "*SURFACE, NAME=Slave\n" + "".join(f"{65 + i}, S1\n" for i in range(6)) +
            "*SURFACE, NAME=Master\n" + "".join(f"{57 + i}, S3\n" for i in range(8)) +
            "*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e7, 1., 1e-3\n"
            "*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nSlave, Master\n*BOUNDARY\nBase, 2\nDie, 1\n" +
            material("Soft", "*PLASTIC\n200, 0\n300, 0.01\n", "Lower") + material("Hard", "", "Upper") +
            "".join(step("*BOUNDARY\n" + lines) for lines in pressed)), [lower, upper], ("Lower", "Upper")


DECKS = {"bar": (bar, (31, 68, 82, 100)), "cylinder": (cylinder, (1, 97, 150, 200)), "plate": (plate, (1, 13, 19, 40, 60)),
         "heated": (heated, (12, 22, 27, 42, 44)), "blocks": (blocks, (139, 201, 205, 209, 217, 228, 240))}

VALUES = {
    "bar": (
        ({31: (0.01500071, 0.002895217, 0.01524731), 68: (0.05964088, -0.0004732837, -0.02627937), 82: (0.08728082, 0.0006199457, 0.02854855),
          100: (0.1172878, 0, 0.01521432)}, 0.002283231),
        ({31: (0.02282541, -0.01483547, 0.007355641), 68: (0.04884244, 0.04333647, -0.01570823), 82: (0.09583175, -0.05662482, 0.01216081),
          100: (0.0513212, -0.03477836, 0.006129471)}, 0.004751374),
    ),
    "cylinder": (
        ({1: (0.0229995, 0, 0), 97: (0.01347587, 0, 0), 150: (0.0224657, 0, 0),
          200: (0.01602155, 0, 0)}, 0.001883133),
        ({1: (0.008700229, 0, 0), 97: (0.004376331, 0, 0), 150: (0.008417933, 0, 0),
          200: (0.005250685, 0, 0)}, 0.001883133),
    ),
    "plate": (
        ({1: (0, 0.01284101, 0), 13: (-0.003697884, 0, 0), 19: (-0.005206338, 0.003803027, 0),
          40: (-0.007059459, 0, 0), 60: (-0.007694822, 0, 0)}, 0.002388094),
    ),
    "heated": (
        ({12: (0.004549886, 0.004549886, 0.001673616), 22: (0.006347374, 0, 0.001831955), 27: (0.01198219, 0, 0.001372222),
          42: (0, 0.01702227, 0), 44: (0.01675777, 0.01675777, 0)}, 0.00731792),
        ({12: (-0.002527663, -0.002527663, 0.004486801), 22: (-0.001083069, 0, 0.01106766), 27: (0.001485447, 0, 0.0107664),
          42: (0, 0.005924872, 0), 44: (0.00565711, 0.00565711, 0)}, 0.00731792),
    ),
    "blocks": (
        ({139: (0.0008544346, -0.009586642, 0), 201: (-4.85213e-05, -0.01701758, 0), 205: (-2.329281e-05, -0.0134366, 0),
          209: (0, -0.01829492, 0), 217: (-0.0005472349, -0.01543089, 0), 228: (0.001402819, -0.01794164, 0),
          240: (0.001012057, -0.02031224, 0)}, 0.0005348496),
        ({139: (-0.000278046, -0.009753242, 0), 201: (8.046452e-05, -0.01336828, 0), 205: (0.0002480401, -0.01538553, 0),
          209: (0, -0.01405589, 0), 217: (0.000551013, -0.01563952, 0), 228: (-0.001241931, -0.01427646, 0),
          240: (-0.001043599, -0.01534946, 0)}, 0.0005348496),
    ),
}


def by_calculix(deck, nodes, increments):
    """At the ends of the steps: {node: displacement}, largest equivalent plastic strain."""
    deck = re.sub(r"\*STATIC\n1\., 1\.", f"*STATIC, DIRECT\n{1 / increments:.12g}, 1.", deck)
    deck = deck.replace("*NODE PRINT, NSET=Nall", "*NODE PRINT, NSET=Nall, FREQUENCY=100000")
    deck = deck.replace("*EL PRINT, ELSET=Body\nS, PEEQ", "*EL PRINT, ELSET=Body, FREQUENCY=100000\nPEEQ")
    with tempfile.TemporaryDirectory() as scratch:
        (pathlib.Path(scratch) / "deck.inp").write_text(deck)
        done = subprocess.run(["ccx", "-i", "deck"], cwd=scratch, capture_output=True, text=True)
        if "Job finished" not in done.stdout:
            raise RuntimeError(f"ccx: {done.stdout[-500:]}")
        printed = (pathlib.Path(scratch) / "deck.dat").read_text()
    ends = []
    for block in re.split(r"(?m)^ (?=[a-z])", printed)[1:]:
        rows = [line.split() for line in block.splitlines()[1:] if line.strip()]
        if block.startswith("displacements"):
            u = {int(row[0]): tuple(float(value) for value in row[1:4]) for row in rows}
        else:
            ends.append(({number: u[number] for number in nodes}, max(float(row[2]) for row in rows)))
    return ends


if __name__ == "__main__":
    print("VALUES = {")
    for name, (make, nodes) in DECKS.items():
        print(f'    "{name}": (')
        for u, flow in by_calculix(make()[0], nodes, int(sys.argv[1])):
            places = [f"{number}: ({', '.join(f'{value:.7g}' for value in at)})" for number, at in u.items()]
            lines = [", ".join(places[i:i + 3]) for i in range(0, len(places), 3)]
            print("        ({" + (",\n          ".join(lines)) + f"}}, {flow:.7g}),")
        print("    ),")
    print("}")
