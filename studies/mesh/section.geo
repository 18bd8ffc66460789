// The shrink fit of fit.geo as a section: quadrilaterals or triangles. angle = 0: an axisymmetric section, x is the radius;
// else a sector of the plane. The divisions of the two bodies do not match on the fit.
SetFactory("OpenCASCADE"); // which leaves the coinciding curves of the two bodies apart
DefineConstant[
  element   = {0,   Name "Parameters/0: quadrilaterals, 1: triangles"},
  n         = {4,   Name "Parameters/elements through the shaft; through the disc: 2 n"},
  angle     = {0,   Name "Parameters/angle of the sector, degrees; 0: an axisymmetric section"},
  height    = {15,  Name "Parameters/height of the axisymmetric section"},
  bore      = {40,  Name "Parameters/inner radius of the shaft"},
  fit       = {60,  Name "Parameters/radius of the fit"},
  rim       = {120, Name "Parameters/outer radius of the disc"}
];
DefineConstant[ // elements of the shaft are as long in both directions
  along     = {Round(angle > 0 ? 1.5*n : 0.75*n), Name "Parameters/elements of the shaft along the fit; of the disc: two thirds"}
];
phi = angle*Pi/180; up = angle > 0 ? 0 : height;

Macro Ring
  // in: r1, r2, n_radial, n_along, growth; out: s, the surface, and l1 to l4: lower side, outer curve, upper side, inner curve
  p1 = newp; Point(p1) = {r1, 0, 0};
  p2 = newp; Point(p2) = {r2, 0, 0};
  p3 = newp; Point(p3) = {r2*Cos(phi), r2*Sin(phi) + up, 0};
  p4 = newp; Point(p4) = {r1*Cos(phi), r1*Sin(phi) + up, 0};
  l1 = newl; Line(l1) = {p1, p2};
  If (angle > 0)
    c = newp; Point(c) = {0, 0, 0};
    l2 = newl; Circle(l2) = {p2, c, p3};
    l4 = newl; Circle(l4) = {p1, c, p4};
  Else
    l2 = newl; Line(l2) = {p2, p3};
    l4 = newl; Line(l4) = {p1, p4};
  EndIf
  l3 = newl; Line(l3) = {p4, p3};
  loop = newll; Line Loop(loop) = {l1, l2, -l3, -l4};
  s = news; Plane Surface(s) = {loop};
  Transfinite Curve{l1, l3} = n_radial + 1 Using Progression growth;
  Transfinite Curve{l2, l4} = n_along + 1;
  Transfinite Surface{s} = {p1, p2, p3, p4};
  If (element == 0)
    Recombine Surface{s};
  EndIf
Return

r1 = bore; r2 = fit; n_radial = n; n_along = along; growth = 1;
Call Ring;
Physical Surface("shaft") = {s};
Physical Curve("shaft_outer") = {l2};
sides[] = {l1, l3};

// The outermost element of the disc is three times as long as the innermost, on every mesh.
r1 = fit; r2 = rim; n_radial = 2*n; n_along = Round(2*along/3); growth = 3^(1/(2*n));
Call Ring;
Physical Surface("disc") = {s};
Physical Curve("disc_bore") = {l4};
Physical Curve("disc_rim") = {l2};
Physical Curve("sides") = {sides[], l1, l3};
