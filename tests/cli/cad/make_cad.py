#!/usr/bin/env python3
"""Writes the CAD files of this directory. Needs Gmsh for Python (Debian package python3-gmsh)."""

import pathlib
import re

import gmsh

HERE = pathlib.Path(__file__).parent


def plate_and_pin():
    """A plate with a hole, a pin that is 0.02 thicker, a washer on the plate."""
    occ = gmsh.model.occ
    plate = occ.cut([(3, occ.addBox(-20, -20, 0, 40, 40, 10))], [(3, occ.addCylinder(0, 0, 0, 0, 0, 10, 8))])[0]
    pin = occ.addCylinder(0, 0, 0, 0, 0, 10, 8.02)
    washer = occ.cut([(3, occ.addCylinder(0, 0, 10, 0, 0, 3, 18))], [(3, occ.addCylinder(0, 0, 10, 0, 0, 3, 10))])[0]
    return [(plate[0], "plate"), ((3, pin), 'pin "1"'), (washer[0], "washer")]


def shell():
    """Two faces that enclose nothing."""
    occ = gmsh.model.occ
    return [((2, occ.addRectangle(0, 0, 0, 10, 10)), "face"), ((2, occ.addRectangle(0, 0, 5, 10, 10)), "face")]


def write(name, parts_of):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    parts = parts_of()
    gmsh.model.occ.synchronize()
    names = {part: words for part, words in parts}
    file = HERE / f"{name}.step"
    gmsh.write(str(file))
    if name == "plate_and_pin":
        gmsh.write(str(HERE / f"{name}.brep"))
    dimension = parts[0][0][0]
    ordered = [names[entity] for entity in gmsh.model.getEntities(dimension)]
    gmsh.finalize()
    text = file.read_text()
    # Gmsh writes no names of parts: the n-th product is the n-th solid.
    text = re.sub(r"'Open CASCADE STEP translator [0-9. ]+?1\.(\d+)'", lambda match: f"'{ordered[int(match[1]) - 1]}'", text)
    text = re.sub(r"FILE_NAME\(.*?\);", f"FILE_NAME('{name}.step','',(''),(''),'','','');", text, flags=re.DOTALL)
    file.write_text(text)


write("plate_and_pin", plate_and_pin)
write("shell", shell)
