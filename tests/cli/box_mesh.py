"""Boxes of every kind of element, bent to any shape, as a .msh file (2.2): bodies with a named surface on each side."""

import itertools

# Edges in the order of Gmsh's mid-edge nodes, faces (outward) in that of its mid-face nodes.
EDGES = {"tet": [(0, 1), (1, 2), (2, 0), (3, 0), (3, 2), (3, 1)],
         "wedge": [(0, 1), (0, 2), (0, 3), (1, 2), (1, 4), (2, 5), (3, 4), (3, 5), (4, 5)],
         "hex": [(0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7)]}
FACES = {"tet": [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)],
         "wedge": [(0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)],
         "hex": [(0, 3, 2, 1), (0, 1, 5, 4), (0, 4, 7, 3), (1, 2, 6, 5), (3, 7, 6, 2), (4, 5, 6, 7)]}
# The unit cube cut into cells of each shape: itself, two wedges, six tetrahedra around a diagonal.
CUBE = {"hex": [[(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]],
        "wedge": [[(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1)],
                  [(0, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1), (0, 1, 1)]],
        "tet": []}
for axes in itertools.permutations(range(3)):
    path = [(0, 0, 0)]
    for axis in axes:
        path.append(tuple(path[-1][k] + (k == axis) for k in range(3)))
    odd = axes in ((0, 2, 1), (1, 0, 2), (2, 1, 0))
    CUBE["tet"].append([path[0], path[2], path[1], path[3]] if odd else path)
# Gmsh's numbers of the cells, and of their faces by the count of corners.
CELLS = {"tet4": (4, {3: 2}), "tet10": (11, {3: 9}), "wedge6": (6, {3: 2, 4: 3}), "wedge15": (18, {3: 9, 4: 16}),
         "hex8": (5, {4: 3}), "hex20": (17, {4: 16}), "hex27": (12, {4: 10})}
SIDES = [(axis, side) for axis in range(3) for side in (0, 1)]


class BoxMesh:
    """Nodes are named by their body and twice their place in the lattice of corners; a body shares none with others."""

    def __init__(self):
        self.numbers, self.places, self.cells, self.groups = {}, [], [], {}

    def add(self, body, kind, counts, shape):
        """@param shape  takes a place in the lattice, 0..counts, to its place in space; surfaces: <body>_x0, ..._z1"""
        code, face_codes = CELLS[kind]
        form = kind.rstrip("0123456789")
        for base in itertools.product(*map(range, counts)):
            for cube in CUBE[form]:
                corners = [tuple(2 * (b + c) for b, c in zip(base, corner)) for corner in cube]
                self.cell(code, body, 3, self.nodes(body, corners, kind, shape))
                for face in FACES[form]:
                    on = [corners[k] for k in face]
                    for axis, side in SIDES:
                        if all(corner[axis] == 2 * side * counts[axis] for corner in on):
                            nodes = self.face_nodes(body, on, kind, shape)
                            self.cell(face_codes[len(on)], f"{body}_{'xyz'[axis]}{side}", 2, nodes)

    def cell(self, code, group, dimension, nodes):
        number = self.groups.setdefault((group, dimension), len(self.groups) + 1)
        self.cells.append((code, number, nodes))

    def nodes(self, body, corners, kind, shape):
        form, places = kind.rstrip("0123456789"), list(corners)
        if kind not in ("tet4", "wedge6", "hex8"):
            places += [mean(corners[a], corners[b]) for a, b in EDGES[form]]
        if kind == "hex27":
            places += [mean(*(corners[k] for k in face)) for face in FACES[form]] + [mean(*corners)]
        return [self.node(body, place, shape) for place in places]

    def face_nodes(self, body, corners, kind, shape):
        places = list(corners)
        if kind not in ("tet4", "wedge6", "hex8"):
            places += [mean(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]
        if kind == "hex27":
            places.append(mean(*corners))
        return [self.node(body, place, shape) for place in places]

    def node(self, body, place, shape):
        if (body, place) not in self.numbers:
            self.places.append(shape(*(0.5 * c for c in place)))
            self.numbers[body, place] = len(self.places)
        return self.numbers[body, place]

    def write(self, path):
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(self.groups))]
        lines += [f'{dimension} {number} "{name}"' for (name, dimension), number in self.groups.items()]
        lines += ["$EndPhysicalNames", "$Nodes", str(len(self.places))]
        lines += [f"{i} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(self.places, 1)]
        lines += ["$EndNodes", "$Elements", str(len(self.cells))]
        lines += [f"{i} {code} 2 {group} {group} " + " ".join(map(str, nodes))
                  for i, (code, group, nodes) in enumerate(self.cells, 1)]
        path.write_text("\n".join(lines + ["$EndElements", ""]))


def mean(*places):
    return tuple(sum(place[k] for place in places) // len(places) for k in range(3))
