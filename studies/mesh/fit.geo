// A sector of a disc shrunk onto a hollow shaft, extruded: hexahedra, wedges or tetrahedra.
// The divisions of the two bodies do not match on the fit.
SetFactory("OpenCASCADE");
DefineConstant[
  element   = {0,   Name "Parameters/0: hexahedra, 1: wedges, 2: tetrahedra"},
  n         = {4,   Name "Parameters/elements through the shaft; through the disc: 2 n"},
  angle     = {30,  Name "Parameters/angle of the sector, degrees"},
  bore      = {40,  Name "Parameters/inner radius of the shaft"},
  fit       = {60,  Name "Parameters/radius of the fit"},
  rim       = {120, Name "Parameters/outer radius of the disc"},
  apart     = {1e-5, Name "Parameters/distance of the bodies, without which the mesher merges tetrahedra of both"}
];
DefineConstant[ // elements of the shaft are as long in all three directions
  around    = {Round(1.5*n), Name "Parameters/elements around the shaft; around the disc: two thirds"},
  thickness = {(fit - bore)/n, Name "Parameters/thickness of the slice"}
];
phi = angle*Pi/180;

Macro Ring
  // in: r1, r2, n_radial, n_around, growth; out: s, the face below, and out[]
  c = newp; Point(c) = {0, 0, 0};
  p1 = newp; Point(p1) = {r1, 0, 0};
  p2 = newp; Point(p2) = {r2, 0, 0};
  p3 = newp; Point(p3) = {r2*Cos(phi), r2*Sin(phi), 0};
  p4 = newp; Point(p4) = {r1*Cos(phi), r1*Sin(phi), 0};
  l1 = newl; Line(l1) = {p1, p2};
  l2 = newl; Circle(l2) = {p2, c, p3};
  l3 = newl; Line(l3) = {p4, p3};
  l4 = newl; Circle(l4) = {p1, c, p4};
  loop = newll; Line Loop(loop) = {l1, l2, -l3, -l4};
  s = news; Plane Surface(s) = {loop};
  Transfinite Curve{l1, l3} = n_radial + 1 Using Progression growth;
  Transfinite Curve{l2, l4} = n_around + 1;
  Transfinite Surface{s} = {p1, p2, p3, p4};
  If (element == 0)
    Recombine Surface{s};
  EndIf
  // out[]: top, volume, then the sides of l1, l2, l3, l4
  If (element == 2)
    out[] = Extrude {0, 0, thickness} { Surface{s}; Layers{1}; };
  Else
    out[] = Extrude {0, 0, thickness} { Surface{s}; Layers{1}; Recombine; };
  EndIf
Return

r1 = bore; r2 = fit; n_radial = n; n_around = around; growth = 1;
Call Ring;
Physical Volume("shaft") = {out[1]};
Physical Surface("shaft_outer") = {out[3]};
ends[] = {s, out[0]}; sides[] = {out[2], out[4]};

// The outermost element of the disc is three times as long as the innermost, on every mesh.
r1 = fit + apart; r2 = rim; n_radial = 2*n; n_around = Round(2*around/3); growth = 3^(1/(2*n));
Call Ring;
Physical Volume("disc") = {out[1]};
Physical Surface("disc_bore") = {out[5]};
Physical Surface("disc_rim") = {out[3]};

Physical Surface("ends") = {ends[], s, out[0]};
Physical Surface("sides") = {sides[], out[2], out[4]};
