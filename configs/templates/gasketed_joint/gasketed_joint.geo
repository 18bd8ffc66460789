// A flange pair with a gasket: half of one bolt's sector, between the plane through the bolt's axis (y = 0) and the plane midway to
// the next bolt. z is the axis of the pipe, the middle of the gasket lies at z = 0. Four bodies with meshes of their own, all
// hexahedra: two flanges with a hub and a raised face each, a bolt with its head, and a nut on the bolt's end. The gasket is not
// drawn; its faces are rings of the raised faces. The numbers here are defaults: [mesh.parameters] of gasketed_joint.toml overrides
// them.
SetFactory("OpenCASCADE"); // which leaves the coinciding surfaces of the bodies apart
// Gmsh may give coinciding curves each other's divisions. So the faces under head and nut end at radii that the flanges' meshes
// do not have, and nut and thread are divided alike.
DefineConstant[
  bolts      = {8,    Name "Parameters/number of bolts"},
  bore       = {50,   Name "Parameters/inner radius of the pipe"},
  hub        = {58,   Name "Parameters/outer radius of the hub"},
  pipe       = {60,   Name "Parameters/length of hub and pipe beyond a flange"},
  gasket_inner = {61, Name "Parameters/inner radius of the gasket, outside the hub"},
  gasket_outer = {73, Name "Parameters/outer radius of the gasket"},
  distance   = {0,    Name "Parameters/distance of the gasket's faces as drawn: 0 or its thickness"},
  raised_height = {2, Name "Parameters/height of the raised face, which ends with the gasket"},
  circle     = {95,   Name "Parameters/radius of the bolt circle"},
  rim        = {118,  Name "Parameters/outer radius of the flange"},
  thickness  = {30,   Name "Parameters/thickness of a flange"},
  hole       = {11,   Name "Parameters/radius of the bolt hole"},
  shank      = {9,    Name "Parameters/radius of the bolt's shank"},
  head       = {15,   Name "Parameters/radius of the bearing faces of head and nut"},
  head_height = {12,  Name "Parameters/height of the head"},
  nut_height  = {16,  Name "Parameters/height of the nut"},
  end        = {4,    Name "Parameters/length of the bolt's end beyond the nut"},
  n          = {2,    Name "Parameters/fineness of the mesh"}
];
seat = 1.1*head;        // radius of the finer mesh around the hole
chamfer = hole + 0.3;   // inner radius of the bearing faces, larger than the hole
inside = circle - 1.25*seat; // where the mesh around the hole begins
If (inside < gasket_outer)
  inside = (gasket_outer + circle - seat)/2;
EndIf
If (gasket_outer > circle - 1.02*seat || rim < 2*circle - inside + 1 || circle*Sin(Pi/bolts) < 1.02*seat)
  Error("no room for the seats of head and nut, radius %g, between gasket, rim (more than %g) and the next bolt", seat,
        2*circle - inside);
EndIf
If (hole < shank || head < chamfer || hub < bore || gasket_inner < hub || gasket_outer < gasket_inner)
  Error("radii in the wrong order: shank < hole < head, bore < hub < gasket_inner < gasket_outer");
EndIf
n_around = n; n_wall = n; n_gasket = 2*n; n_hole = 2*n; n_seat = n + 1; n_bearing = n + 1; n_thickness = 2*n; n_shank = 3*n;

// A macro runs after the rest of the line that calls it, so that calls end their lines.
Macro Arc
  // in: p1, p2, centre, k; out: l
  l = newl; Circle(l) = {p1, centre, p2}; Transfinite Curve{l} = k + 1;
Return

Macro Segment
  // in: p1, p2, k; out: l
  l = newl; Line(l) = {p1, p2}; Transfinite Curve{l} = k + 1;
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
      p1 = ends[4*i + j]; p2 = ends[4*i + j + 1]; k = (j == 1) ? n_middle : n_side; Call Arc;
      arcs[] += l;
    EndFor
    If (i > 0)
      For j In {0:3}
        p1 = ends[4*i - 4 + j]; p2 = ends[4*i + j]; k = n_radial[i - 1]; Call Segment;
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
  // in: base[], height, k; out: volumes[], tops[], out[]: a top, a volume and four sides for each quadrilateral
  out[] = Extrude {0, 0, height} { Surface{base[]}; Layers{k}; Recombine; };
  tops[] = {}; volumes[] = {};
  For i In {0:#base[] - 1}
    tops[] += out[6*i]; volumes[] += out[6*i + 1];
  EndFor
Return

Macro Flange
  // in: side: 1 above the joint, -1 below; out: solid[], face[], inner_face[], bearing[], bores[], pipe_end[], middle[]
  z = side*(distance/2 + raised_height);
  radius[] = {hole, seat}; n_radial[] = {n_seat}; n_side = n_around; n_middle = n_hole; Call Rings;
  axis = newp; Point(axis) = {0, 0, z};
  inner[] = {}; outer[] = {}; across[] = {};
  r[] = {bore, hub, gasket_inner, gasket_outer, inside, 2*circle - inside, rim};
  n_r[] = {n_wall, 1, n_gasket, 1, n_hole, 1};
  For i In {0:6}
    p = newp; Point(p) = {r[i], 0, z}; inner[] += p;
    p = newp; Point(p) = {r[i]*Cos(Pi/bolts), r[i]*Sin(Pi/bolts), z}; outer[] += p;
    p1 = inner[i]; p2 = outer[i]; centre = axis; k = n_around; Call Arc;
    across[] += l;
  EndFor
  plate[] = ring[];
  For i In {0:5}
    p1 = outer[i]; p2 = outer[i + 1]; k = n_r[i]; Call Segment;
    far = l;
    If (i != 4)
      p1 = inner[i]; p2 = inner[i + 1]; Call Segment;
      loop[] = {l, across[i + 1], -far, -across[i]}; Call Quadrilateral;
      plate[] += s;
    Else // the hole: three quadrilaterals round its outermost ring
      a[] = {inner[4], outer[4], outer[5], inner[5]};
      b[] = {across[4], far, -across[5]};
      spokes[] = {};
      For j In {0:3}
        p1 = ends[4 + j]; p2 = a[j]; k = 1; Call Segment;
        spokes[] += l;
      EndFor
      For j In {0:2}
        loop[] = {b[j], -spokes[j + 1], -arcs[3 + j], spokes[j]}; Call Quadrilateral;
        plate[] += s;
      EndFor
    EndIf
  EndFor
  // plate[]: 0-2 around the hole, 3 the hub, 4 between hub and gasket, 5 the gasket, 6 beyond it, 7-9 around the seat, 10 the rim
  base[] = plate[]; height = side*thickness; k = n_thickness; Call Prism;
  solid[] = volumes[]; bearing[] = {tops[0], tops[1], tops[2]}; hub_base = tops[3];
  middle[] = {out[6*3 + 4], out[6*4 + 4], out[6*5 + 4], out[6*6 + 4], out[6*8 + 2], out[6*10 + 4]}; bores[] = {out[6*3 + 5]};
  base[] = {hub_base}; height = side*pipe; k = 4; Call Prism;
  solid[] += volumes[]; pipe_end[] = tops[]; middle[] += out[4]; bores[] += out[5];
  base[] = {plate[3], plate[4], plate[5]}; height = -side*raised_height; k = 1; Call Prism;
  solid[] += volumes[]; inner_face[] = {tops[0], tops[1]}; face[] = {tops[2]};
  middle[] += {out[4], out[10], out[16]}; bores[] += out[5];
Return

side = 1; Call Flange;
Physical Volume("upper_flange") = {solid[]};
Physical Surface("upper_gasket_face") = {face[]};
Physical Surface("upper_wet") = {bores[], inner_face[]}; // what the pressure acts on: up to the gasket
Physical Surface("upper_bearing") = {bearing[]};
Physical Surface("upper_end") = {pipe_end[]};
between_bolts[] = middle[];

side = -1; Call Flange;
Physical Volume("lower_flange") = {solid[]};
Physical Surface("lower_gasket_face") = {face[]};
Physical Surface("lower_wet") = {bores[], inner_face[]}; // what the pressure acts on: up to the gasket
Physical Surface("lower_bearing") = {bearing[]};
Physical Surface("lower_end") = {pipe_end[]};
between_bolts[] += middle[];

Physical Surface("between_bolts") = {between_bolts[]};

// The bolt: a square core and a ring around it run through, two more rings make the head.
grip = distance/2 + raised_height + thickness;
core = 0.5*shank;
z = grip;
radius[] = {shank, chamfer, head}; n_radial[] = {1, n_bearing}; n_side = 2; n_middle = 4; Call Rings;
collar[] = ring[];
p[] = {newp, newp + 1, newp + 2, newp + 3};
Point(p[0]) = {circle - core, 0, z}; Point(p[1]) = {circle - core, core, z};
Point(p[2]) = {circle + core, core, z}; Point(p[3]) = {circle + core, 0, z};
square[] = {}; spokes[] = {};
For j In {0:3}
  p1 = p[j]; p2 = p[(j + 1) % 4]; k = (j % 2) ? n_middle : n_side; Call Segment;
  square[] += l;
  p1 = p[j]; p2 = ends[j]; k = 2; Call Segment;
  spokes[] += l;
EndFor
loop[] = {square[]}; Call Quadrilateral;
section[] = {s};
For j In {0:2}
  loop[] = {spokes[j], arcs[j], -spokes[j + 1], -square[j]}; Call Quadrilateral;
  section[] += s;
EndFor
base[] = {section[], collar[]}; height = head_height; k = 2; Call Prism;
bolt[] = volumes[];
base[] = section[]; height = -2*grip; k = n_shank; Call Prism;
bolt[] += volumes[];
base[] = tops[]; height = -nut_height - end; k = 4; Call Prism;
bolt[] += volumes[];
Physical Volume("bolt") = {bolt[]};
Physical Surface("head_bearing") = {collar[3], collar[4], collar[5]};
Physical Surface("bolt_thread") = {out[6*1 + 3], out[6*2 + 3], out[6*3 + 3]};
Physical Point("bolt_middle") = {p[0]};

z = -grip;
Call Rings;
base[] = ring[]; height = -nut_height; k = 3; Call Prism;
Physical Volume("nut") = {volumes[]};
Physical Surface("nut_bearing") = {ring[3], ring[4], ring[5]};
Physical Surface("nut_thread") = {out[5], out[11], out[17]};

e = 1e-4;
s[] = Surface In BoundingBox {0, -e, -pipe - 2*grip, rim + e, e, pipe + 2*grip};
Physical Surface("symmetry_y") = {s[]};
