// A sector of a round punch with a spherical end on a block: two profiles of quadrilaterals, turned about the z axis. The elements
// on the axis become wedges.
SetFactory("OpenCASCADE"); // which leaves the touching surfaces of the two bodies apart
DefineConstant[
  radius  = {10, Name "Parameters/radius of the spherical end"},
  punch   = {3,  Name "Parameters/radius of the punch"},
  height  = {4,  Name "Parameters/height of the punch"},
  block   = {24, Name "Parameters/radius and height of the block"},
  angle   = {10, Name "Parameters/angle of the sector in degrees"},
  n_punch = {12, Name "Parameters/elements over the radius of the punch"},
  n_block = {29, Name "Parameters/elements over the radius of the block"},
  n_depth = {16, Name "Parameters/elements over the height of the block"},
  n_around = {1, Name "Parameters/elements around the sector"}
];

Macro Turn
  // in: curves l1 from the axis outwards, l2, l3 from the axis outwards, l4 on the axis; n1, g1 along l1, n2, g2 along l2
  loop = newll; Curve Loop(loop) = {l1, l2, -l3, -l4};
  s = news; Plane Surface(s) = {loop};
  Transfinite Curve{l1, l3} = n1 + 1 Using Progression g1;
  Transfinite Curve{l2, l4} = n2 + 1 Using Progression g2;
  Transfinite Surface{s};
  Recombine Surface{s};
  // out[]: the other cut, volume, then the sides of l1, l2, l3
  out[] = Extrude {{0, 0, 1}, {0, 0, 0}, angle*Pi/180} { Surface{s}; Layers{n_around}; Recombine; };
Return

p1 = newp; Point(p1) = {0, 0, 0};
p2 = newp; Point(p2) = {punch, 0, radius - Sqrt(radius^2 - punch^2)};
p3 = newp; Point(p3) = {punch, 0, height};
p4 = newp; Point(p4) = {0, 0, height};
p5 = newp; Point(p5) = {0, 0, radius};
l1 = newl; Circle(l1) = {p1, p5, p2};
l2 = newl; Line(l2) = {p2, p3};
l3 = newl; Line(l3) = {p4, p3};
l4 = newl; Line(l4) = {p1, p4};
n1 = n_punch; g1 = 1.1; n2 = 6; g2 = 1.3;
Call Turn;
Physical Volume("punch") = {out[1]};
Physical Surface("punch_end") = {out[2]};
Physical Surface("punch_top") = {out[4]};
cuts[] = {s, out[0]};

p1 = newp; Point(p1) = {0, 0, 0};
p2 = newp; Point(p2) = {block, 0, 0};
p3 = newp; Point(p3) = {block, 0, -block};
p4 = newp; Point(p4) = {0, 0, -block};
l1 = newl; Line(l1) = {p1, p2};
l2 = newl; Line(l2) = {p2, p3};
l3 = newl; Line(l3) = {p4, p3};
l4 = newl; Line(l4) = {p1, p4};
n1 = n_block; g1 = 1.15; n2 = n_depth; g2 = 1.3;
Call Turn;
Physical Volume("block") = {out[1]};
Physical Surface("block_top") = {out[2]};
Physical Surface("block_foot") = {out[4]};

Physical Surface("cuts") = {cuts[], s, out[0]};
