#!/usr/bin/env python3
"""Writes valve_from_step.step: the body, the bonnet and the four studs of a valve, as a CAD program would.

Needs Gmsh for Python (Debian package python3-gmsh). The file is there already: this shows where it comes from.
"""

import math
import pathlib
import re

import gmsh

OUTER, BORE, PITCH = 95.0, 40.0, 70.0  # radii of the flanges, the opening and the circle of the studs
FLANGE, LID, NECK = 34.0, 40.0, 40.0  # thickness of the flanges of body and bonnet, length of the neck
SHANK, HOLE, NUT, NUT_HEIGHT = 10.0, 11.0, 17.0, 16.0
SPIGOT, DEPTH, CLEARANCE = 39.8, 8.0, 0.2  # of the bonnet, in the opening


def cylinder(z, length, radius, x=0.0, y=0.0):
    return gmsh.model.occ.addCylinder(x, y, z, 0, 0, length, radius)


def fuse(first, *others):
    parts, _ = gmsh.model.occ.fuse([(3, first)], [(3, other) for other in others])
    return parts[0][1]


def cut(solid, *tools):
    parts, _ = gmsh.model.occ.cut([(3, solid)], [(3, tool) for tool in tools])
    return parts[0][1]


def main():
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    at = [(PITCH * math.cos(angle), PITCH * math.sin(angle)) for angle in (math.pi / 4 + k * math.pi / 2 for k in range(4))]
    body = fuse(cylinder(-FLANGE, FLANGE, OUTER), cylinder(-FLANGE - NECK, NECK, BORE + 10))
    body = cut(body, cylinder(-FLANGE - NECK, FLANGE + NECK, BORE), *(cylinder(-FLANGE, FLANGE, HOLE, x, y) for x, y in at))
    bonnet = fuse(cylinder(0, LID, OUTER), cylinder(-DEPTH, DEPTH, SPIGOT))
    bonnet = cut(bonnet, *(cylinder(0, LID, HOLE, x, y) for x, y in at))
    studs = []
    for x, y in at:
        studs.append(fuse(cylinder(-FLANGE, FLANGE + LID, SHANK, x, y), cylinder(LID, NUT_HEIGHT, NUT, x, y),
                          cylinder(-FLANGE - NUT_HEIGHT, NUT_HEIGHT, NUT, x, y)))
    gmsh.model.occ.synchronize()
    names = {body: "body", bonnet: "bonnet", **{stud: "stud" for stud in studs}}
    file = pathlib.Path(__file__).with_suffix(".step")
    gmsh.write(str(file))
    # Gmsh writes no names of parts: the n-th product is the n-th solid.
    ordered = [names[tag] for _, tag in gmsh.model.getEntities(3)]
    gmsh.finalize()
    text = file.read_text()
    text = re.sub(r"'Open CASCADE STEP translator [0-9. ]+?1\.(\d+)'", lambda match: f"'{ordered[int(match[1]) - 1]}'", text)
    text = re.sub(r"'Open CASCADE STEP translator [0-9.]+ 1'", "'valve'", text)
    text = re.sub(r"FILE_NAME\(.*?\);", "FILE_NAME('valve_from_step.step','',(''),(''),'','','');", text, flags=re.DOTALL)
    file.write_text(text)


if __name__ == "__main__":
    main()
