// A bolted pipe joint: half of one bolt's sector, between the plane through the bolt's axis (y = 0) and the plane midway to the
// next bolt. Two flanges with a raised face and a length of pipe each, a bolt with its head, and a nut on the bolt's end:
// four bodies with meshes of their own, all hexahedra. z is the pipe's axis, the joint lies at z = 0, the head above.
SetFactory("OpenCASCADE"); // which leaves the coinciding surfaces of the bodies apart
// Gmsh may give coinciding curves each other's divisions. So the faces under head and nut end at radii that the flanges' meshes
// do not have, and nut and thread are divided alike.
DefineConstant[
  bolts      = {12,   Name "Parameters/number of bolts"},
  pipe_inner = {100,  Name "Parameters/inner radius of the pipe"},
  pipe_outer = {112,  Name "Parameters/outer radius of the pipe"},
  pipe       = {80,   Name "Parameters/length of pipe beyond a flange"},
  raised     = {135,  Name "Parameters/outer radius of the raised face"},
  raised_height = {2, Name "Parameters/height of the raised face"},
  circle     = {160,  Name "Parameters/radius of the bolt circle"},
  rim        = {195,  Name "Parameters/outer radius of the flange"},
  thickness  = {60,   Name "Parameters/thickness of a flange"},
  hole       = {13.5, Name "Parameters/radius of the bolt hole"},
  seat       = {21,   Name "Parameters/radius of the finer mesh around it, larger than the head"},
  shank      = {12,   Name "Parameters/radius of the bolt's shank"},
  head       = {18,   Name "Parameters/radius of the head and of the nut"},
  chamfer    = {14,   Name "Parameters/inner radius of their bearing faces, larger than the hole"},
  head_height = {15,  Name "Parameters/height of the head"},
  nut_height  = {20,  Name "Parameters/height of the nut"},
  end         = {5,   Name "Parameters/length of the bolt's end beyond the nut"},
  n_around    = {3,   Name "Parameters/elements across the sector"},
  n_face      = {5,   Name "Parameters/elements across the raised face beyond the pipe's wall"},
  n_hole      = {5,   Name "Parameters/elements around the middle half of the hole"},
  n_seat      = {4,   Name "Parameters/elements from the hole outwards, under head and nut"},
  n_bearing   = {3,   Name "Parameters/elements across the bearing faces of head and nut"},
  n_thickness = {4,   Name "Parameters/elements through a flange"},
  n_shank     = {8,   Name "Parameters/elements along the shank between head and nut"}
];

// A macro runs after the rest of the line that calls it, so that calls end their lines.
Macro Arc
  // in: p1, p2, centre, n; out: l
  l = newl; Circle(l) = {p1, centre, p2}; Transfinite Curve{l} = n + 1;
Return

growth = 1;
Macro Segment
  // in: p1, p2, n, growth; out: l
  l = newl; Line(l) = {p1, p2}; Transfinite Curve{l} = n + 1 Using Progression growth;
Return

Macro Quadrilateral
  // in: loop[]; out: s
  c = newll; Curve Loop(c) = {loop[]};
  s = news; Plane Surface(s) = {c};
  Transfinite Surface{s}; Recombine Surface{s};
Return

Macro Rings
  // Half rings about the bolt's axis at height z, each of three quadrilaterals left, behind and right.
  // in: z, radius[], n_radial[], n_side, n_middle; out: ring[]: three surfaces a ring; arcs[]: three a radius; ends[]: points
  centre = newp; Point(centre) = {circle, 0, z};
  ring[] = {}; arcs[] = {}; ends[] = {}; rays[] = {};
  For i In {0:#radius[] - 1}
    For j In {0:3}
      t = (j == 0) ? Pi : (j == 1) ? 3*Pi/4 : (j == 2) ? Pi/4 : 0;
      p = newp; Point(p) = {circle + radius[i]*Cos(t), radius[i]*Sin(t), z}; ends[] += p;
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
  // in: base[], height, n; out: volumes[], tops[], out[]: a top, a volume and four sides for each quadrilateral
  out[] = Extrude {0, 0, height} { Surface{base[]}; Layers{n}; Recombine; };
  tops[] = {}; volumes[] = {};
  For i In {0:#base[] - 1}
    tops[] += out[6*i]; volumes[] += out[6*i + 1];
  EndFor
Return

Macro Flange
  // in: side: 1 above the joint, -1 below; out: solid[], face[], bearing[], bore[], pipe_end[], middle[]
  z = side*raised_height;
  radius[] = {hole, seat}; n_radial[] = {n_seat}; n_side = n_around; n_middle = n_hole; Call Rings;
  axis = newp; Point(axis) = {0, 0, z};
  inner[] = {}; outer[] = {}; across[] = {};
  r[] = {pipe_inner, pipe_outer, raised, 2*circle - raised, rim};
  For i In {0:4}
    p = newp; Point(p) = {r[i], 0, z}; inner[] += p;
    p = newp; Point(p) = {r[i]*Cos(Pi/bolts), r[i]*Sin(Pi/bolts), z}; outer[] += p;
    p1 = inner[i]; p2 = outer[i]; centre = axis; n = n_around; Call Arc;
    across[] += l;
  EndFor
  plate[] = ring[];
  For i In {0:3}
    growth = (i == 1) ? 0.7 : 1; // the faces bear at the outer edge of the raised face
    p1 = outer[i]; p2 = outer[i + 1]; n = (i == 2) ? n_hole : (i == 1) ? n_face : 2; Call Segment;
    far = l;
    If (i != 2)
      p1 = inner[i]; p2 = inner[i + 1]; Call Segment;
      loop[] = {l, across[i + 1], -far, -across[i]}; Call Quadrilateral;
      plate[] += s;
    Else // the hole: three quadrilaterals round its outermost ring
      a[] = {inner[2], outer[2], outer[3], inner[3]};
      b[] = {across[2], far, -across[3]};
      spokes[] = {};
      For j In {0:3}
        p1 = ends[4 + j]; p2 = a[j]; n = 2; Call Segment;
        spokes[] += l;
      EndFor
      For j In {0:2}
        loop[] = {b[j], -spokes[j + 1], -arcs[3 + j], spokes[j]}; Call Quadrilateral;
        plate[] += s;
      EndFor
    EndIf
  EndFor
  // plate[]: 0-2 around the hole, 3 the pipe's wall, 4 the rest of the raised face, 5-7 around the seat, 8 the rim
  base[] = plate[]; height = side*thickness; n = n_thickness; Call Prism;
  solid[] = volumes[]; bearing[] = {tops[0], tops[1], tops[2]};
  middle[] = {out[6*3 + 4], out[6*4 + 4], out[6*6 + 2], out[6*8 + 4]}; bore[] = {out[6*3 + 5]};
  base[] = {tops[3]}; height = side*pipe; n = 4; Call Prism;
  solid[] += volumes[]; pipe_end[] = tops[]; middle[] += out[4]; bore[] += out[5];
  base[] = {plate[3], plate[4]}; height = -side*raised_height; n = 1; Call Prism;
  solid[] += volumes[]; face[] = tops[]; middle[] += {out[4], out[10]}; bore[] += out[5];
Return

side = 1; Call Flange;
Physical Volume("upper_flange") = {solid[]};
Physical Surface("upper_face") = {face[]};
Physical Surface("upper_bearing") = {bearing[]};
Physical Surface("upper_bore") = {bore[]};
Physical Surface("upper_end") = {pipe_end[]};
between_bolts[] = middle[];

side = -1; Call Flange;
Physical Volume("lower_flange") = {solid[]};
Physical Surface("lower_face") = {face[]};
Physical Surface("lower_bearing") = {bearing[]};
Physical Surface("lower_bore") = {bore[]};
Physical Surface("lower_end") = {pipe_end[]};
between_bolts[] += middle[];
Physical Surface("between_bolts") = {between_bolts[]};

// The bolt: a square core and a ring around it run through, two more rings make the head.
grip = raised_height + thickness;
core = 0.5*shank;
z = grip;
radius[] = {shank, chamfer, head}; n_radial[] = {1, n_bearing}; n_side = 2; n_middle = 4; Call Rings;
collar[] = ring[];
p[] = {newp, newp + 1, newp + 2, newp + 3};
Point(p[0]) = {circle - core, 0, z}; Point(p[1]) = {circle - core, core, z};
Point(p[2]) = {circle + core, core, z}; Point(p[3]) = {circle + core, 0, z};
square[] = {}; spokes[] = {};
For j In {0:3}
  p1 = p[j]; p2 = p[(j + 1) % 4]; n = (j % 2) ? n_middle : n_side; Call Segment;
  square[] += l;
  p1 = p[j]; p2 = ends[j]; n = 2; Call Segment;
  spokes[] += l;
EndFor
loop[] = {square[]}; Call Quadrilateral;
section[] = {s};
For j In {0:2}
  loop[] = {spokes[j], arcs[j], -spokes[j + 1], -square[j]}; Call Quadrilateral;
  section[] += s;
EndFor
base[] = {section[], collar[]}; height = head_height; n = 2; Call Prism;
bolt[] = volumes[];
base[] = section[]; height = -2*grip; n = n_shank; Call Prism;
bolt[] += volumes[];
base[] = tops[]; height = -nut_height - end; n = 4; Call Prism;
bolt[] += volumes[];
Physical Volume("bolt") = {bolt[]};
Physical Surface("head_bearing") = {collar[3], collar[4], collar[5]};
Physical Surface("bolt_thread") = {out[6*1 + 3], out[6*2 + 3], out[6*3 + 3]};
Physical Point("bolt_middle") = {p[0]};

z = -grip;
Call Rings;
base[] = ring[]; height = -nut_height; n = 3; Call Prism;
Physical Volume("nut") = {volumes[]};
Physical Surface("nut_bearing") = {ring[3], ring[4], ring[5]};
Physical Surface("nut_thread") = {out[5], out[11], out[17]};

e = 1e-4;
s[] = Surface In BoundingBox {0, -e, -pipe - 2*grip, rim + e, e, pipe + 2*grip};
Physical Surface("symmetry_y") = {s[]};
