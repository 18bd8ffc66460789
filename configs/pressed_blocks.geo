// Two blocks on top of each other, meshed with hexahedra that do not match where the blocks touch.
SetFactory("OpenCASCADE"); // which leaves the coinciding surfaces of the two blocks apart
DefineConstant[
  side     = {10, Name "Parameters/side of the square section"},
  h_lower  = {20, Name "Parameters/height of the lower block"},
  h_upper  = {10, Name "Parameters/height of the upper block"},
  n_lower  = {3,  Name "Parameters/elements along a side, lower block"},
  n_upper  = {2,  Name "Parameters/elements along a side, upper block"}
];

Macro Brick
  // in: bottom, height, n; out: s, the face below, and out[]
  p1 = newp; Point(p1) = {0, 0, bottom};
  p2 = newp; Point(p2) = {side, 0, bottom};
  p3 = newp; Point(p3) = {side, side, bottom};
  p4 = newp; Point(p4) = {0, side, bottom};
  l1 = newl; Line(l1) = {p1, p2};
  l2 = newl; Line(l2) = {p2, p3};
  l3 = newl; Line(l3) = {p3, p4};
  l4 = newl; Line(l4) = {p4, p1};
  loop = newll; Curve Loop(loop) = {l1, l2, l3, l4};
  s = news; Plane Surface(s) = {loop};
  Transfinite Curve{l1, l2, l3, l4} = n + 1;
  Transfinite Surface{s};
  Recombine Surface{s};
  // out[]: top, volume, then the sides of l1 (y = 0), l2, l3, l4 (x = 0)
  out[] = Extrude {0, 0, height} { Surface{s}; Layers{n}; Recombine; };
Return

bottom = 0; height = h_lower; n = n_lower;
Call Brick;
Physical Volume("lower") = {out[1]};
Physical Surface("lower_foot") = {s};
Physical Surface("lower_top") = {out[0]};
y0[] = out[2]; x0[] = out[5];

bottom = h_lower; height = h_upper; n = n_upper;
Call Brick;
Physical Volume("upper") = {out[1]};
Physical Surface("upper_foot") = {s};
Physical Surface("upper_top") = {out[0]};

Physical Surface("symmetry_y") = {y0[], out[2]};
Physical Surface("symmetry_x") = {x0[], out[5]};
