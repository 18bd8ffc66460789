// A hub pressed onto a hollow shaft: the full rings, meshed with hexahedra. The shaft continues beyond the hub on the side
// z < 0, where it is held. The two bodies have nodes of their own on the fit; their divisions need not match.
SetFactory("OpenCASCADE"); // which leaves the coinciding surfaces of the two bodies apart
DefineConstant[
  bore     = {30,  Name "Parameters/inner radius of the shaft"},
  fit      = {50,  Name "Parameters/radius of the fit"},
  rim      = {90,  Name "Parameters/outer radius of the hub"},
  length   = {40,  Name "Parameters/length of the hub"},
  overhang = {40,  Name "Parameters/length of the shaft beyond the hub"},
  n_shaft  = {2,   Name "Parameters/elements through the shaft"},
  n_hub    = {3,   Name "Parameters/elements through the hub"},
  around_shaft = {20, Name "Parameters/elements around the shaft, a multiple of 4"},
  around_hub   = {16, Name "Parameters/elements around the hub, a multiple of 4"},
  n_length = {4,   Name "Parameters/elements along the hub"},
  grading  = {1.3, Name "Parameters/growth of the hub's elements from the fit outwards"}
];

Macro Annulus
  // in: r1, r2, z, n_radial, n_around, growth; out: faces[]: four quadrants
  inner[] = {}; outer[] = {}; across[] = {}; inside[] = {}; outside[] = {}; faces[] = {};
  c = newp; Point(c) = {0, 0, z};
  For i In {0:3}
    p = newp; Point(p) = {r1*Cos(i*Pi/2), r1*Sin(i*Pi/2), z}; inner[] += p;
    p = newp; Point(p) = {r2*Cos(i*Pi/2), r2*Sin(i*Pi/2), z}; outer[] += p;
    l = newl; Line(l) = {inner[i], outer[i]}; across[] += l;
    Transfinite Curve{l} = n_radial + 1 Using Progression growth;
  EndFor
  For i In {0:3}
    next = (i + 1) % 4;
    l = newl; Circle(l) = {inner[i], c, inner[next]}; inside[] += l;
    l = newl; Circle(l) = {outer[i], c, outer[next]}; outside[] += l;
    Transfinite Curve{inside[i], outside[i]} = n_around/4 + 1;
    k = newll; Curve Loop(k) = {across[i], outside[i], -across[next], -inside[i]};
    s = news; Plane Surface(s) = {k}; faces[] += s;
  EndFor
  Transfinite Surface{faces[]};
  Recombine Surface{faces[]};
Return

Macro Ring
  // in: faces[], height, layers; out: tops[], volumes[], inner_sides[], outer_sides[]
  tops[] = {}; volumes[] = {}; inner_sides[] = {}; outer_sides[] = {};
  out[] = Extrude {0, 0, height} { Surface{faces[]}; Layers{layers}; Recombine; };
  For i In {0:3} // each quadrant gives its top, its volume and four sides, in the order of its curves
    tops[] += out[6*i]; volumes[] += out[6*i + 1]; outer_sides[] += out[6*i + 3]; inner_sides[] += out[6*i + 5];
  EndFor
Return

// Both rings start from z = 0, where the curves of shaft and hub coincide.
r1 = bore; r2 = fit; z = 0; n_radial = n_shaft; n_around = around_shaft; growth = 1;
Call Annulus;
height = -overhang; layers = Ceil(n_length*overhang/length);
Call Ring;
shaft[] = volumes[];
Physical Surface("shaft_end") = {tops[]};
height = length; layers = n_length;
Call Ring;
shaft[] += volumes[];
Physical Volume("shaft") = {shaft[]};
Physical Surface("shaft_seat") = {outer_sides[]};

r1 = fit; r2 = rim; n_radial = n_hub; n_around = around_hub; growth = grading;
Call Annulus;
height = length; layers = n_length;
Call Ring;
Physical Volume("hub") = {volumes[]};
Physical Surface("hub_bore") = {inner_sides[]};
Physical Surface("hub_rim") = {outer_sides[]};
