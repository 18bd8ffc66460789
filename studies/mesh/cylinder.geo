// A half cylinder on a block, one half of a slice: hexahedra, wedges or tetrahedra that grow away from the contact.
// All meshes have the same grading, so that a larger n makes every element smaller by the same factor.
SetFactory("OpenCASCADE");
DefineConstant[
  element   = {0,   Name "Parameters/0: hexahedra, 1: wedges, 2: tetrahedra"},
  n         = {16,  Name "Parameters/elements along the sides"},
  grading   = {80,  Name "Parameters/largest element of a side over the smallest"},
  radius    = {10,  Name "Parameters/radius of the cylinder, extent of the block"},
  thickness = {0.2, Name "Parameters/thickness of the slice"},
  apart     = {1e-5, Name "Parameters/distance of the bodies, without which the mesher merges tetrahedra of both"}
];
growth = grading^(1/(n - 1));

Macro Slice
  // in: l1 ... l4, of which l1 and l4 begin at the contact; out: s, and out[]
  loop = newll; Curve Loop(loop) = {l1, l2, -l3, -l4};
  s = news; Plane Surface(s) = {loop};
  Transfinite Curve{l1, l2, l3, l4} = n + 1 Using Progression growth;
  Transfinite Surface{s};
  If (element == 0)
    Recombine Surface{s};
  EndIf
  // out[]: back, volume, then the sides of l1, l2, l3, l4
  If (element == 2)
    out[] = Extrude {0, 0, thickness} { Surface{s}; Layers{1}; };
  Else
    out[] = Extrude {0, 0, thickness} { Surface{s}; Layers{1}; Recombine; };
  EndIf
Return

// The cylinder: its circle is cut at 45 degrees.
p1 = newp; Point(p1) = {0, 0, 0};
p2 = newp; Point(p2) = {radius*Sin(Pi/4), radius*(1 - Cos(Pi/4)), 0};
p3 = newp; Point(p3) = {radius, radius, 0};
p4 = newp; Point(p4) = {0, radius, 0};
l1 = newl; Circle(l1) = {p1, p4, p2};
l2 = newl; Circle(l2) = {p2, p4, p3};
l3 = newl; Line(l3) = {p4, p3};
l4 = newl; Line(l4) = {p1, p4};
Call Slice;
Physical Volume("cylinder") = {out[1]};
Physical Surface("cylinder_round") = {out[2]};
Physical Surface("cylinder_top") = {out[4]};
ends[] = {s, out[0]}; symmetry[] = {out[5]};

p1 = newp; Point(p1) = {0, -apart, 0};
p2 = newp; Point(p2) = {radius, -apart, 0};
p3 = newp; Point(p3) = {radius, -apart - radius, 0};
p4 = newp; Point(p4) = {0, -apart - radius, 0};
l1 = newl; Line(l1) = {p1, p2};
l2 = newl; Line(l2) = {p2, p3};
l3 = newl; Line(l3) = {p4, p3};
l4 = newl; Line(l4) = {p1, p4};
Call Slice;
Physical Volume("block") = {out[1]};
Physical Surface("block_top") = {out[2]};
Physical Surface("block_foot") = {out[4]};

Physical Surface("ends") = {ends[], s, out[0]};
Physical Surface("symmetry") = {symmetry[], out[5]};
