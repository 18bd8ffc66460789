// Two columns of one square section on top of each other, of matching cubes; the joint is at z = 0.
SetFactory("OpenCASCADE"); // which leaves the coinciding faces of the two columns apart
DefineConstant[
  side    = {10, Name "Parameters/side of the section"},
  n       = {2,  Name "Parameters/elements along a side"},
  h_lower = {10, Name "Parameters/height of the lower column, a multiple of side/n"},
  h_upper = {10, Name "Parameters/height of the upper column, a multiple of side/n"}
];

Macro Column
  // in: direction, height; out: s, the face at the joint, and out[]
  p1 = newp; Point(p1) = {0, 0, 0};
  p2 = newp; Point(p2) = {side, 0, 0};
  p3 = newp; Point(p3) = {side, side, 0};
  p4 = newp; Point(p4) = {0, side, 0};
  l1 = newl; Line(l1) = {p1, p2};
  l2 = newl; Line(l2) = {p2, p3};
  l3 = newl; Line(l3) = {p3, p4};
  l4 = newl; Line(l4) = {p4, p1};
  loop = newll; Curve Loop(loop) = {l1, l2, l3, l4};
  s = news; Plane Surface(s) = {loop};
  Transfinite Curve{l1, l2, l3, l4} = n + 1;
  Transfinite Surface{s};
  Recombine Surface{s};
  // out[]: far end, volume, then the sides of l1 (y = 0), l2, l3, l4 (x = 0)
  out[] = Extrude {0, 0, direction*height} { Surface{s}; Layers{Round(n*height/side)}; Recombine; };
Return

direction = -1; height = h_lower;
Call Column;
Physical Volume("lower") = {out[1]};
Physical Surface("lower_top") = {s};
Physical Surface("lower_foot") = {out[0]};
y0[] = out[2]; x0[] = out[5];

direction = 1; height = h_upper;
Call Column;
Physical Volume("upper") = {out[1]};
Physical Surface("upper_foot") = {s};
Physical Surface("upper_top") = {out[0]};

Physical Surface("symmetry_y") = {y0[], out[2]};
Physical Surface("symmetry_x") = {x0[], out[5]};
