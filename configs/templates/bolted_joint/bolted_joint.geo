// One of two equal flanges of a pipe joint, and half of one bolt: half of the bolt's sector, between the plane through the bolt's
// axis (y = 0) and the plane midway to the next bolt. z is the axis of the pipe, the joint lies at z = 0. Three bodies with
// meshes of their own, all hexahedra: the flange with a raised face and a length of pipe; the bolt, its nut drawn with it; and a
// plate, whose upper face is the joint. The numbers here are defaults: [mesh.parameters] of bolted_joint.toml overrides them.
SetFactory("OpenCASCADE"); // which leaves the coinciding surfaces of the bodies apart
DefineConstant[
  bolts      = {8,   Name "Parameters/number of bolts"},
  inner      = {50,  Name "Parameters/inner radius of the pipe"},
  outer      = {57,  Name "Parameters/outer radius of the pipe"},
  pipe       = {60,  Name "Parameters/length of pipe beyond the flange"},
  raised     = {75,  Name "Parameters/outer radius of the raised face, inside the seats of the bolts"},
  raised_height = {2, Name "Parameters/height of the raised face"},
  circle     = {95,  Name "Parameters/radius of the bolt circle"},
  rim        = {120, Name "Parameters/outer radius of the flange"},
  thickness  = {36,  Name "Parameters/thickness of the flange"},
  hole       = {11,  Name "Parameters/radius of the bolt hole"},
  shank      = {10,  Name "Parameters/radius of the bolt's shank"},
  nut        = {15,  Name "Parameters/radius of the nut's bearing face"},
  nut_height = {16,  Name "Parameters/height of the nut"},
  n          = {2,   Name "Parameters/fineness of the mesh"}
];
seat = 1.1*nut;         // radius of the finer mesh around the hole
chamfer = hole + 0.3;   // inner radius of the bearing face, larger than the hole
grip = raised_height + thickness;
angle = Pi/bolts;
If (raised > circle - seat || rim < 2*circle - raised + 1 || circle*Sin(angle) < seat)
  Error("no room for the seats of the nuts, radius %g, between raised face, rim (more than %g) and the next bolt", seat,
        2*circle - raised);
EndIf
If (hole < shank || nut < chamfer || outer < inner || raised < outer)
  Error("radii in the wrong order: shank < hole < nut, inner < outer < raised");
EndIf

// A macro runs after the rest of the line that calls it, so that calls end their lines.
Macro Segment
  // in: p1, p2, k: elements; out: l
  l = newl; Line(l) = {p1, p2}; Transfinite Curve{l} = k + 1;
Return

Macro Arc
  // in: p1, p2, centre, k; out: l
  l = newl; Circle(l) = {p1, centre, p2}; Transfinite Curve{l} = k + 1;
Return

Macro Quadrilateral
  // in: loop[]; out: s
  c = newll; Curve Loop(c) = {loop[]};
  s = news; Plane Surface(s) = {c};
  Transfinite Surface{s}; Recombine Surface{s};
Return

Macro Rings
  // Half rings about the bolt's axis at height z, each of three quadrilaterals: inside, middle, outside.
  // in: z, radius[], k_radial[]; out: ring[]: three surfaces per ring; arcs[]: three per radius; ends[]: four points per radius
  centre = newp; Point(centre) = {circle, 0, z};
  ring[] = {}; arcs[] = {}; ends[] = {}; rays[] = {};
  For i In {0:#radius[] - 1}
    For j In {0:3}
      t = (j == 0) ? Pi : (j == 1) ? 3*Pi/4 : (j == 2) ? Pi/4 : 0;
      p = newp; Point(p) = {circle + radius[i]*Cos(t), radius[i]*Sin(t), z}; ends[] += p;
    EndFor
    For j In {0:2}
      p1 = ends[4*i + j]; p2 = ends[4*i + j + 1]; k = (j == 1) ? 2*n : n; Call Arc;
      arcs[] += l;
    EndFor
    If (i > 0)
      For j In {0:3}
        p1 = ends[4*i - 4 + j]; p2 = ends[4*i + j]; k = k_radial[i - 1]; Call Segment;
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
  // in: base[], up, k; out: volumes[], tops[], out[]: a top, a volume and four sides for each quadrilateral
  out[] = Extrude {0, 0, up} { Surface{base[]}; Layers{k}; Recombine; };
  tops[] = {}; volumes[] = {};
  For i In {0:#base[] - 1}
    tops[] += out[6*i]; volumes[] += out[6*i + 1];
  EndFor
Return

// The flange, drawn at the height of the raised face: quadrilaterals from the bore to the rim, the third with the hole.
z = raised_height;
radius[] = {hole, seat}; k_radial[] = {n + 1}; Call Rings;
hole_ends[] = ends[]; hole_arcs[] = arcs[];
plate[] = ring[];
axis = newp; Point(axis) = {0, 0, z};
near[] = {}; far[] = {}; across[] = {};
r[] = {inner, outer, raised, 2*circle - raised, rim};
For i In {0:4}
  p = newp; Point(p) = {r[i], 0, z}; near[] += p;
  p = newp; Point(p) = {r[i]*Cos(angle), r[i]*Sin(angle), z}; far[] += p;
  p1 = near[i]; p2 = far[i]; centre = axis; k = n; Call Arc;
  across[] += l;
EndFor
For i In {0:3}
  p1 = far[i]; p2 = far[i + 1]; k = (i == 1) ? 3*n : (i == 2) ? 2*n : 1; Call Segment;
  side = l;
  If (i != 2)
    p1 = near[i]; p2 = near[i + 1]; Call Segment;
    If (i == 1) // finer towards the outer edge of the raised face, where it bears
      Transfinite Curve{side, l} = 3*n + 1 Using Progression 0.8;
    EndIf
    loop[] = {l, across[i + 1], -side, -across[i]}; Call Quadrilateral;
    plate[] += s;
  Else // around the hole: three quadrilaterals
    a[] = {near[2], far[2], far[3], near[3]};
    b[] = {across[2], side, -across[3]};
    spokes[] = {};
    For j In {0:3}
      p1 = hole_ends[4 + j]; p2 = a[j]; k = 1; Call Segment;
      spokes[] += l;
    EndFor
    For j In {0:2}
      loop[] = {b[j], -spokes[j + 1], -hole_arcs[3 + j], spokes[j]}; Call Quadrilateral;
      plate[] += s;
    EndFor
  EndIf
EndFor
// plate[]: 0-2 around the hole, 3 the wall of the pipe, 4 the rest of the raised face, 5-7 around the seat, 8 the rim.
// Of the four sides of a prism the first is that of the first curve of its quadrilateral, and so on.
base[] = plate[]; up = thickness; k = 2*n; Call Prism;
flange[] = volumes[]; nut_seat[] = {tops[0], tops[1], tops[2]}; wall = tops[3];
bore[] = {out[6*3 + 5]}; between[] = {out[6*3 + 4], out[6*4 + 4], out[6*6 + 2], out[6*8 + 4]};
base[] = {wall}; up = pipe; k = 2*n; Call Prism;
flange[] += volumes[]; pipe_end[] = tops[]; bore[] += out[5]; between[] += out[4];
base[] = {plate[3], plate[4]}; up = -raised_height; k = 1; Call Prism;
flange[] += volumes[]; face[] = tops[]; bore[] += out[5]; between[] += {out[4], out[10]};
Physical Volume("flange") = {flange[]};
Physical Surface("flange_face") = {face[]};
Physical Surface("nut_seat") = {nut_seat[]};
Physical Surface("bore") = {bore[]};
Physical Surface("pipe_end") = {pipe_end[]};
Physical Surface("between_bolts") = {between[]};

// The bolt, drawn where the nut begins: a square core and a ring around it go down to the joint, two more rings make the nut.
z = grip;
radius[] = {shank, chamfer, nut}; k_radial[] = {1, n + 1}; Call Rings;
collar[] = ring[];
core = 0.5*shank;
p = newp; p[] = {p, p + 1, p + 2, p + 3};
Point(p[0]) = {circle - core, 0, z}; Point(p[1]) = {circle - core, core, z};
Point(p[2]) = {circle + core, core, z}; Point(p[3]) = {circle + core, 0, z};
square[] = {}; spokes[] = {};
For j In {0:3}
  p1 = p[j]; p2 = p[(j + 1) % 4]; k = (j % 2) ? 2*n : n; Call Segment;
  square[] += l;
  p1 = p[j]; p2 = ends[j]; k = 1; Call Segment;
  spokes[] += l;
EndFor
loop[] = {square[]}; Call Quadrilateral;
shaft[] = {s};
For j In {0:2}
  loop[] = {spokes[j], arcs[j], -spokes[j + 1], -square[j]}; Call Quadrilateral;
  shaft[] += s;
EndFor
base[] = {shaft[], collar[]}; up = nut_height; k = n; Call Prism;
bolt[] = volumes[];
base[] = shaft[]; up = -grip; k = 2*n; Call Prism;
bolt[] += volumes[];
Physical Volume("bolt") = {bolt[]};
Physical Surface("nut_bearing") = {collar[3], collar[4], collar[5]};
Physical Surface("bolt_middle") = {tops[]};

// the plate of which only the upper face matters
p = newp;
Point(p) = {0.9*inner*Cos(angle), -0.1*inner, 0}; Point(p + 1) = {1.1*raised, -0.1*inner, 0};
Point(p + 2) = {1.1*raised, 1.1*raised*Tan(angle), 0}; Point(p + 3) = {0.9*inner*Cos(angle), 1.1*raised*Tan(angle), 0};
q[] = {p, p + 1, p + 2, p + 3}; sides[] = {};
For j In {0:3}
  p1 = q[j]; p2 = q[(j + 1) % 4]; k = 4; Call Segment;
  sides[] += l;
EndFor
loop[] = {sides[]}; Call Quadrilateral;
joint = s;
base[] = {joint}; up = -0.1*inner; k = 1; Call Prism;
Physical Volume("plate") = {volumes[]};
Physical Surface("joint") = {joint};

e = 1e-4;
s[] = Surface In BoundingBox {inner - e, -e, -e, rim + e, e, grip + pipe + nut_height + e};
Physical Surface("symmetry_y") = {s[]};
s[] = Point In BoundingBox {circle - core - e, -e, grip - e, circle - core + e, e, grip + e};
Physical Point("bolt_guide") = {s[]};
