// A disc shrunk onto a hollow shaft: a quarter of a slice, meshed with hexahedra.
// The two bodies have nodes of their own on the fit; their divisions need not match.
SetFactory("OpenCASCADE"); // which leaves the coinciding surfaces of the two bodies apart
DefineConstant[
  bore      = {40,  Name "Parameters/inner radius of the shaft"},
  fit       = {60,  Name "Parameters/radius of the fit"},
  rim       = {120, Name "Parameters/outer radius of the disc"},
  thickness = {10,  Name "Parameters/thickness of the slice"},
  n_shaft   = {4,   Name "Parameters/elements through the shaft"},
  n_disc    = {8,   Name "Parameters/elements through the disc"},
  around_shaft = {12, Name "Parameters/elements around the shaft, a quarter"},
  around_disc  = {9,  Name "Parameters/elements around the disc, a quarter"},
  grading   = {1.15, Name "Parameters/growth of the disc's elements from the fit outwards"}
];

Macro Ring
  // in: r1, r2, n_radial, n_around, growth; out: volume, faces[]
  c = newp; Point(c) = {0, 0, 0};
  p1 = newp; Point(p1) = {r1, 0, 0};
  p2 = newp; Point(p2) = {r2, 0, 0};
  p3 = newp; Point(p3) = {0, r2, 0};
  p4 = newp; Point(p4) = {0, r1, 0};
  l1 = newl; Line(l1) = {p1, p2};
  l2 = newl; Circle(l2) = {p2, c, p3};
  l3 = newl; Line(l3) = {p4, p3};
  l4 = newl; Circle(l4) = {p1, c, p4};
  loop = newll; Line Loop(loop) = {l1, l2, -l3, -l4};
  s = news; Plane Surface(s) = {loop};
  Transfinite Curve{l1, l3} = n_radial + 1 Using Progression growth;
  Transfinite Curve{l2, l4} = n_around + 1;
  Transfinite Surface{s} = {p1, p2, p3, p4};
  Recombine Surface{s};
  // out[]: top, volume, then the sides of l1, l2, l3, l4
  out[] = Extrude {0, 0, thickness} { Surface{s}; Layers{1}; Recombine; };
Return

r1 = bore; r2 = fit; n_radial = n_shaft; n_around = around_shaft; growth = 1;
Call Ring;
Physical Volume("shaft") = {out[1]};
Physical Surface("shaft_outer") = {out[3]};
Physical Surface("shaft_bore") = {out[5]};
shaft_ends[] = {s, out[0]}; shaft_y0 = out[2]; shaft_x0 = out[4];

r1 = fit; r2 = rim; n_radial = n_disc; n_around = around_disc; growth = grading;
Call Ring;
Physical Volume("disc") = {out[1]};
Physical Surface("disc_bore") = {out[5]};
Physical Surface("disc_rim") = {out[3]};

Physical Surface("ends") = {shaft_ends[], s, out[0]};
Physical Surface("symmetry_y") = {shaft_y0, out[2]};
Physical Surface("symmetry_x") = {shaft_x0, out[4]};
