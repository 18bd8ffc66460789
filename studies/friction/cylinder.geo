// A half cylinder on a block: quadrilaterals that grow away from the contact, alike on both sides of it.
SetFactory("OpenCASCADE"); // which leaves the two bodies apart
DefineConstant[
  n       = {32, Name "Parameters/elements along the sides"},
  grading = {80, Name "Parameters/largest element of a side over the smallest"},
  radius  = {10, Name "Parameters/radius of the cylinder, half of the width of the block"}
];
growth = grading^(1/(n - 1));

Macro Side
  // in: l1 ... l4, of which l1 and l4 begin at the contact; out: s
  loop = newll; Curve Loop(loop) = {l1, l2, -l3, -l4};
  s = news; Plane Surface(s) = {loop};
  Transfinite Curve{l1, l2, l3, l4} = n + 1 Using Progression growth;
  Transfinite Surface{s};
  Recombine Surface{s};
Return

// The cylinder: its circle is cut at 45 degrees.
p1 = newp; Point(p1) = {0, 0, 0};
p4 = newp; Point(p4) = {0, radius, 0};
l4 = newl; Line(l4) = {p1, p4};
round[] = {}; top[] = {}; half[] = {};
For side In {-1:1:2}
  p2 = newp; Point(p2) = {side*radius*Sin(Pi/4), radius*(1 - Cos(Pi/4)), 0};
  p3 = newp; Point(p3) = {side*radius, radius, 0};
  l1 = newl; Circle(l1) = {p1, p4, p2};
  l2 = newl; Circle(l2) = {p2, p4, p3};
  l3 = newl; Line(l3) = {p4, p3};
  Call Side;
  round[] += l1; top[] += l3; half[] += s;
EndFor
Physical Surface("cylinder") = {half[]};
Physical Curve("cylinder_round") = {round[]};
Physical Curve("cylinder_top") = {top[]};

p1 = newp; Point(p1) = {0, 0, 0};
p4 = newp; Point(p4) = {0, -radius, 0};
l4 = newl; Line(l4) = {p1, p4};
top[] = {}; foot[] = {}; half[] = {};
For side In {-1:1:2}
  p2 = newp; Point(p2) = {side*radius, 0, 0};
  p3 = newp; Point(p3) = {side*radius, -radius, 0};
  l1 = newl; Line(l1) = {p1, p2};
  l2 = newl; Line(l2) = {p2, p3};
  l3 = newl; Line(l3) = {p4, p3};
  Call Side;
  top[] += l1; foot[] += l3; half[] += s;
EndFor
Physical Surface("block") = {half[]};
Physical Curve("block_top") = {top[]};
Physical Curve("block_foot") = {foot[]};
