// A hub shrunk onto a hollow shaft: a sector of a thin slice, meshed with hexahedra that do not match on the fit.
SetFactory("OpenCASCADE"); // which leaves the coinciding surfaces of the two bodies apart
DefineConstant[
  bore      = {30,  Name "Parameters/inner radius of the shaft"},
  fit       = {60,  Name "Parameters/radius of the fit"},
  rim       = {120, Name "Parameters/outer radius of the hub"},
  angle     = {30,  Name "Parameters/angle of the sector in degrees"},
  thickness = {10,  Name "Parameters/thickness of the slice"},
  n_shaft   = {6,   Name "Parameters/elements through the shaft"},
  n_hub     = {8,   Name "Parameters/elements through the hub"},
  around_shaft = {4, Name "Parameters/elements around the shaft"},
  around_hub   = {3, Name "Parameters/elements around the hub"}
];

Macro Sector
  // in: r1, r2, n_radial, n_around, growth; out: s, the face below, and out[]
  c = Cos(angle*Pi/180); d = Sin(angle*Pi/180);
  p0 = newp; Point(p0) = {0, 0, 0};
  p1 = newp; Point(p1) = {r1, 0, 0};
  p2 = newp; Point(p2) = {r2, 0, 0};
  p3 = newp; Point(p3) = {r2*c, r2*d, 0};
  p4 = newp; Point(p4) = {r1*c, r1*d, 0};
  l1 = newl; Line(l1) = {p1, p2};
  l2 = newl; Circle(l2) = {p2, p0, p3};
  l3 = newl; Line(l3) = {p4, p3};
  l4 = newl; Circle(l4) = {p1, p0, p4};
  loop = newll; Curve Loop(loop) = {l1, l2, -l3, -l4};
  s = news; Plane Surface(s) = {loop};
  Transfinite Curve{l1, l3} = n_radial + 1 Using Progression growth;
  Transfinite Curve{l2, l4} = n_around + 1;
  Transfinite Surface{s} = {p1, p2, p3, p4};
  Recombine Surface{s};
  // out[]: top, volume, then the sides of l1, l2, l3, l4
  out[] = Extrude {0, 0, thickness} { Surface{s}; Layers{1}; Recombine; };
Return

r1 = bore; r2 = fit; n_radial = n_shaft; n_around = around_shaft; growth = 1;
Call Sector;
Physical Volume("shaft") = {out[1]};
Physical Surface("shaft_outer") = {out[3]};
foot = s; cut1 = out[2]; cut2 = out[4];

r1 = fit; r2 = rim; n_radial = n_hub; n_around = around_hub; growth = 1.15;
Call Sector;
Physical Volume("hub") = {out[1]};
Physical Surface("hub_bore") = {out[5]};

Physical Surface("foot") = {foot, s};
Physical Surface("cuts") = {cut1, cut2, out[2], out[4]};
