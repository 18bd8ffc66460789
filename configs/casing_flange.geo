// The horizontal joint of a turbine casing: half of one bolt's pitch, above the joint. x points outwards, y upwards along the bolt,
// z along the machine; the joint lies at y = 0. Three bodies, all hexahedra: the casing (a quarter of its ring, with its flange),
// the bolt with its nut, and a plate whose upper face is the plane of symmetry that the flange rests on.
// Nut and plate are drawn 0.01 mm away from the flange. So an expression of x, y and z can also tell the nut from the flange.
SetFactory("Built-in"); // which makes one of coinciding surfaces: those of the flange and of the wall. So the bodies are drawn apart
DefineConstant[
  bore      = {300, Name "Parameters/inner radius of the casing"},
  wall      = {60,  Name "Parameters/thickness of its wall"},
  height    = {160, Name "Parameters/height of the flange"},
  land      = {4,   Name "Parameters/height of the two lands of its face"},
  fillet    = {25,  Name "Parameters/radius of the fillet between wall and flange"},
  bolt_at   = {395, Name "Parameters/distance of the bolt from the middle of the casing"},
  rim       = {480, Name "Parameters/distance of the flange's outer side"},
  pitch     = {140, Name "Parameters/pitch of the bolts"},
  shank     = {30,  Name "Parameters/radius of the bolt's shank"},
  hole      = {33,  Name "Parameters/radius of the bolt hole"},
  chamfer   = {35,  Name "Parameters/inner radius of the nut's bearing face, larger than the hole"},
  nut       = {50,  Name "Parameters/radius of the nut"},
  nut_height = {50, Name "Parameters/height of the nut"},
  clearance = {0.01, Name "Parameters/distance of nut and plate as drawn"},
  n_side    = {4,   Name "Parameters/elements along half the pitch"},
  n_middle  = {4,   Name "Parameters/elements around the middle half of the hole"},
  n_seat    = {4,   Name "Parameters/elements from the hole outwards"},
  n_bearing = {4,   Name "Parameters/elements across the nut's bearing face"},
  n_wall    = {4,   Name "Parameters/elements through the wall"},
  n_land    = {2,   Name "Parameters/elements through the lands"},
  n_heel    = {4,   Name "Parameters/elements across the outer land"},
  n_height  = {6,   Name "Parameters/elements through the flange"},
  n_ring    = {8,   Name "Parameters/elements along the wall beyond the fillet"},
  n_shank   = {5,   Name "Parameters/elements along the shank"},
  n_nut     = {3,   Name "Parameters/elements through the nut"}
];
depth = pitch/2;
seat = 54; // radius of the finer mesh around the hole, larger than the nut

// A macro runs after the rest of the line that calls it, so that calls end their lines.
Macro Segment
  // in: p1, p2, n; out: l
  l = newl; Line(l) = {p1, p2}; Transfinite Curve{l} = n + 1;
Return

Macro Arc
  // in: p1, p2, centre, n; out: l
  l = newl; Circle(l) = {p1, centre, p2}; Transfinite Curve{l} = n + 1;
Return

Macro Quadrilateral
  // in: loop[]; out: s
  c = newll; Curve Loop(c) = {loop[]};
  s = news; Plane Surface(s) = {c};
  Transfinite Surface{s}; Recombine Surface{s};
Return

Macro Rings
  // Half rings about the bolt's axis at height y, each of three quadrilaterals: inside, middle, outside.
  // in: y, radius[], n_radial[]; out: ring[]: three surfaces per ring; arcs[]: three per radius; ends[]: four points per radius
  centre = newp; Point(centre) = {bolt_at, y, 0};
  ring[] = {}; arcs[] = {}; ends[] = {}; rays[] = {};
  For i In {0:#radius[] - 1}
    For j In {0:3}
      t = (j == 0) ? Pi : (j == 1) ? 3*Pi/4 : (j == 2) ? Pi/4 : 0;
      p = newp; Point(p) = {bolt_at + radius[i]*Cos(t), y, radius[i]*Sin(t)}; ends[] += p;
    EndFor
    For j In {0:2}
      p1 = ends[4*i + j]; p2 = ends[4*i + j + 1]; n = (j == 1) ? n_middle : n_side; Call Arc;
      arcs[] += l;
    EndFor
    If (i > 0)
      For j In {0:3}
        p1 = ends[4*i - 4 + j]; p2 = ends[4*i + j]; n = n_radial[i - 1]; Call Segment;
        rays[] += l;
      EndFor
      For j In {0:2}
        loop[] = {rays[4*i - 4 + j], arcs[3*i + j], -rays[4*i - 3 + j], -arcs[3*i - 3 + j]};
        Call Quadrilateral;
        ring[] += s;
      EndFor
    EndIf
  EndFor
Return

Macro Prism
  // in: base[], up, n; out: volumes[], tops[], out[]: a top, a volume and four sides for each quadrilateral
  out[] = Extrude {0, up, 0} { Surface{base[]}; Layers{n}; Recombine; };
  tops[] = {}; volumes[] = {};
  For i In {0:#base[] - 1}
    tops[] += out[6*i]; volumes[] += out[6*i + 1];
  EndFor
Return

// The casing. The centre of the fillet, the angles of its end and of the line from its beginning to the bore:
fillet_y = height + fillet - land; // above the axis of the casing
inside = Sqrt((bore + wall + fillet)^2 - fillet_y^2); // where the fillet begins on the flange
outside = 2*bolt_at - inside;
end_angle = Atan2(fillet_y, inside);
line_angle = 0.62*end_angle;

// the part with the bolt hole, drawn at the height of the recess and extruded upwards
y = land;
radius[] = {hole, seat}; n_radial[] = {n_seat}; Call Rings;
plate[] = ring[];
a[] = {newp, newp + 1, newp + 2, newp + 3};
Point(a[0]) = {inside, y, 0}; Point(a[1]) = {inside, y, depth}; Point(a[2]) = {outside, y, depth}; Point(a[3]) = {outside, y, 0};
square[] = {}; spokes[] = {};
For j In {0:2}
  p1 = a[j]; p2 = a[j + 1]; n = (j == 1) ? n_middle : n_side; Call Segment;
  square[] += l;
EndFor
For j In {0:3}
  p1 = ends[4 + j]; p2 = a[j]; n = 1; Call Segment;
  spokes[] += l;
EndFor
For j In {0:2}
  loop[] = {square[j], -spokes[j + 1], -arcs[3 + j], spokes[j]}; Call Quadrilateral;
  plate[] += s;
EndFor
edge[] = {newp, newp + 1};
Point(edge[0]) = {rim, y, 0}; Point(edge[1]) = {rim, y, depth};
p1 = a[3]; p2 = edge[0]; n = n_heel; Call Segment;
l1 = l; p1 = a[2]; p2 = edge[1]; Call Segment;
l2 = l; p1 = edge[0]; p2 = edge[1]; n = n_side; Call Segment;
loop[] = {l1, l, -l2, square[2]}; Call Quadrilateral;
plate[] += s; heel = s;
base[] = plate[]; up = height - land; n = n_height; Call Prism;
casing[] = volumes[];

// the wall, drawn in the plane through the bolt's axis and extruded along the machine
origin = newp; Point(origin) = {0, land, 0};
round = newp; Point(round) = {inside, land + fillet_y, 0};
in[] = {}; on[] = {};
angle[] = {0, line_angle, end_angle, Pi/2};
For i In {0:3}
  p = newp; Point(p) = {bore*Cos(angle[i]), land + bore*Sin(angle[i]), 0}; in[] += p;
EndFor
p = newp; Point(p) = {inside, land, 0}; on[] += p;
p = newp; Point(p) = {inside, height, 0}; on[] += p;
p = newp; Point(p) = {(bore + wall)*Cos(end_angle), land + (bore + wall)*Sin(end_angle), 0}; on[] += p;
p = newp; Point(p) = {0, land + bore + wall, 0}; on[] += p;
inner[] = {}; outer[] = {}; across[] = {};
For i In {0:2}
  n = (i == 0) ? n_height : (i == 1) ? 3 : n_ring;
  p1 = in[i]; p2 = in[i + 1]; centre = origin; Call Arc;
  inner[] += l;
  p1 = on[i]; p2 = on[i + 1];
  If (i == 0)
    Call Segment;
  Else
    centre = (i == 1) ? round : origin; Call Arc;
  EndIf
  outer[] += l;
EndFor
For i In {0:3}
  p1 = in[i]; p2 = on[i]; n = n_wall; Call Segment;
  across[] += l;
EndFor
section[] = {};
For i In {0:2}
  loop[] = {across[i], outer[i], -across[i + 1], -inner[i]}; Call Quadrilateral;
  section[] += s;
EndFor
out[] = Extrude {0, 0, depth} { Surface{section[]}; Layers{n_side}; Recombine; };
casing[] += {out[1], out[7], out[13]};

// the lands, extruded down to the joint
e = 1e-3;
root[] = Surface In BoundingBox {bore - e, land - e, -e, inside + e, land + e, depth + e};
base[] = {root[0], heel}; up = -land; n = n_land; Call Prism;
casing[] += volumes[];
Physical Volume("casing") = {casing[]};
Physical Surface("seal_land") = {tops[0]};
Physical Surface("heel_land") = {tops[1]};
s[] = Surface In BoundingBox {-e, -e, -e, bore + e, land + bore + e, depth + e};
Physical Surface("bore") = {s[]};
s[] = Surface In BoundingBox {bolt_at - seat - e, height - e, -e, bolt_at + seat + e, height + e, seat + e};
Physical Surface("nut_seat") = {s[]};
top = land + bore + wall + e;
s[] = Surface In BoundingBox {-e, -e, -e, e, top, depth + e};
Physical Surface("symmetry_x") = {s[]};
s[] = Surface In BoundingBox {-e, -e, depth - e, rim + e, top, depth + e};
Physical Surface("between_bolts") = {s[]};

// The bolt, drawn where the nut begins: a square core and a ring around it go down to the joint, two more rings make the nut.
y = height + clearance;
radius[] = {shank, chamfer, nut}; n_radial[] = {1, n_bearing}; Call Rings;
collar[] = ring[];
core = 0.5*shank;
p[] = {newp, newp + 1, newp + 2, newp + 3};
Point(p[0]) = {bolt_at - core, y, 0}; Point(p[1]) = {bolt_at - core, y, core};
Point(p[2]) = {bolt_at + core, y, core}; Point(p[3]) = {bolt_at + core, y, 0};
square[] = {}; spokes[] = {};
For j In {0:3}
  p1 = p[j]; p2 = p[(j + 1) % 4]; n = (j % 2) ? n_middle : n_side; Call Segment;
  square[] += l;
  p1 = p[j]; p2 = ends[j]; n = 2; Call Segment;
  spokes[] += l;
EndFor
loop[] = {square[]}; Call Quadrilateral;
shaft[] = {s};
For j In {0:2}
  loop[] = {spokes[j], arcs[j], -spokes[j + 1], -square[j]}; Call Quadrilateral;
  shaft[] += s;
EndFor
base[] = {shaft[], collar[]}; up = nut_height; n = n_nut; Call Prism;
bolt[] = volumes[];
base[] = shaft[]; up = -y; n = n_shank; Call Prism;
bolt[] += volumes[];
Physical Volume("bolt") = {bolt[]};
Physical Surface("nut_bearing") = {collar[3], collar[4], collar[5]};
Physical Surface("bolt_middle") = {tops[]};
s[] = Point In BoundingBox {bolt_at - core - e, -e, -e, bolt_at - core + e, e, e};
Physical Point("bolt_guide") = {s[]};

// the plate of which only the upper face matters
corner[] = {newp, newp + 1, newp + 2, newp + 3};
Point(corner[0]) = {bore - 20, -clearance, 0}; Point(corner[1]) = {bore - 20, -clearance, depth};
Point(corner[2]) = {rim + 20, -clearance, depth}; Point(corner[3]) = {rim + 20, -clearance, 0};
side[] = {};
For j In {0:3}
  p1 = corner[j]; p2 = corner[(j + 1) % 4]; n = (j % 2) ? 8 : 3; Call Segment;
  side[] += l;
EndFor
loop[] = {side[]}; Call Quadrilateral;
plane = s;
base[] = {plane}; up = -20; n = 1; Call Prism;
Physical Volume("plate") = {volumes[]};
Physical Surface("plane") = {plane};

s[] = Surface In BoundingBox {-e, -e, -e, rim + e, top, e};
Physical Surface("symmetry_z") = {s[]};
