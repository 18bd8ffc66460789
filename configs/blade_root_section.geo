// The section of blade_root.geo, with the same mesh in the plane: half of one blade pitch of a fir-tree root with two lobes in
// its disc. y is radial, z is the axis of rotation. Bearing flanks at 45 degrees; the other flanks keep a clearance. Blade and
// disc are stacks of quadrilaterals left and right of the profile; their divisions need not match.
SetFactory("OpenCASCADE"); // which leaves the coinciding flanks of the two bodies apart
DefineConstant[
  blades    = {60,   Name "Parameters/number of blades"},
  bore      = {60,   Name "Parameters/radius of the bore of the disc"},
  rim       = {296,  Name "Parameters/radius of the rim of the disc"},
  top       = {305,  Name "Parameters/radius of the top of the root"},
  level     = {275,  Name "Parameters/radius where the lower flank begins"},
  lobe_1    = {8,    Name "Parameters/half of the width of the lower lobe"},
  neck_1    = {4.5,  Name "Parameters/half of the width of the neck between the lobes"},
  lobe_2    = {10.5, Name "Parameters/half of the width of the upper lobe"},
  neck_2    = {7,    Name "Parameters/half of the width of the neck above the lobes"},
  fillet    = {1.5,  Name "Parameters/radius of the fillets in the necks and grooves"},
  clearance = {0.3,  Name "Parameters/clearance between the flanks that do not bear, measured radially"},
  n_blade   = {5,    Name "Parameters/elements across the blade root"},
  n_disc    = {5,    Name "Parameters/elements across the disc"},
  n_blade_flank = {5, Name "Parameters/elements along a flank of the blade"},
  n_disc_flank  = {4, Name "Parameters/elements along a flank of the disc"},
  n_fillet  = {4,    Name "Parameters/elements along a fillet"}
];

slope = Tan(Pi/blades);  // of the plane between two blades
k = fillet/Sqrt(2);
flank_1 = lobe_1 - neck_1; flank_2 = lobe_2 - neck_2;
level_2 = level + flank_1 + 4*k - clearance + lobe_2 - neck_1;

Macro Profile
  // in: px[], py[]: corners; cx[], cy[]: centres of the arcs from a corner to the next, cx = 0: straight; pn[]: divisions
  // out: profile[]: the curves; corner[]: their ends
  corner[] = {}; profile[] = {};
  For i In {0:#px[] - 1}
    p = newp; Point(p) = {px[i], py[i], 0}; corner[] += p;
  EndFor
  For i In {0:#px[] - 2}
    l = newl;
    If (cx[i] > 0)
      p = newp; Point(p) = {cx[i], cy[i], 0};
      Circle(l) = {corner[i], p, corner[i + 1]};
    Else
      Line(l) = {corner[i], corner[i + 1]};
    EndIf
    Transfinite Curve{l} = pn[i] + 1;
    profile[] += l;
  EndFor
Return

Macro Strips
  // in: corner[], profile[], pn[]; edge[]: the points beside the corners; n_across, growth; out: faces[]; across[], sides[]
  across[] = {}; sides[] = {}; faces[] = {};
  For i In {0:#corner[] - 1}
    l = newl; Line(l) = {corner[i], edge[i]}; across[] += l;
    Transfinite Curve{l} = n_across + 1 Using Progression growth;
  EndFor
  For i In {0:#corner[] - 2}
    l = newl; Line(l) = {edge[i], edge[i + 1]}; sides[] += l;
    Transfinite Curve{l} = pn[i] + 1;
    c = newll; Curve Loop(c) = {across[i], l, -across[i + 1], -profile[i]};
    s = news; Plane Surface(s) = {c}; faces[] += s;
  EndFor
Return

e = 1e-4;

// The blade, from the bottom of the root to its top.
px[] = {lobe_1 - 3, lobe_1, lobe_1, neck_1, neck_1, lobe_2, lobe_2, neck_2, neck_2 + k - fillet, neck_2 + k - fillet};
py[] = {level - 2*k + clearance - 3, level - 2*k + clearance, level, level + flank_1, level + flank_1 + 2*k,
        level_2 - 2*k + clearance, level_2, level_2 + flank_2, level_2 + flank_2 + k, top};
cx[] = {0, 0, 0, neck_1 + k, 0, 0, 0, neck_2 + k, 0};
cy[] = {0, 0, 0, level + flank_1 + k, 0, 0, 0, level_2 + flank_2 + k, 0};
pn[] = {2, 2, n_blade_flank, n_fillet, 4, 2, n_blade_flank, Ceil(n_fillet/2), 3};
Call Profile;
edge[] = {};
For i In {0:#py[] - 1}
  p = newp; Point(p) = {0, py[i], 0}; edge[] += p;
EndFor
n_across = n_blade; growth = 1.2;
Call Strips;
Transfinite Surface{faces[]};
Recombine Surface{faces[]};
Physical Surface("blade") = {faces[]};
blade_flanks[] = {};
For j In {0:1}
  y = j ? level_2 : level; x = j ? neck_2 : neck_1; f = j ? flank_2 : flank_1;
  s[] = Curve In BoundingBox {x - e, y - e, -e, x + f + e, y + f + e, e};
  blade_flanks[] += s[];
EndFor
Physical Curve("blade_flank_1") = {blade_flanks[0]};
Physical Curve("blade_flank_2") = {blade_flanks[1]};
s[] = Curve In BoundingBox {-e, top - e, -e, lobe_2 + e, top + e, e};
Physical Curve("blade_top") = {s[]};

// The disc, from the bottom of the slot to the rim, the post beside it, and what is below down to the bore.
floor = lobe_1 - 3; // where the round bottom of the slot begins
px[] = {floor, lobe_1, lobe_1, neck_1, neck_1, lobe_2, lobe_2, neck_2, neck_2};
py[] = {level - 2*k - 3, level - 2*k, level, level + flank_1, level + flank_1 + 2*k - clearance,
        level_2 - 2*k, level_2, level_2 + flank_2, rim};
cx[] = {0, lobe_1 - k, 0, 0, 0, lobe_2 - k, 0, 0};
cy[] = {0, level - k, 0, 0, 0, level_2 - k, 0, 0};
pn[] = {3, n_fillet, n_disc_flank, 2, 4, n_fillet, n_disc_flank, 2};
Call Profile;
below = py[0] - 15;
edge[] = {};
For i In {0:#py[] - 1}
  y = i ? py[i] : below;
  p = newp; Point(p) = {slope*y, y, 0}; edge[] += p;
EndFor
n_across = n_disc; growth = 1.2;
Call Strips;
p = newp; Point(p) = {0, py[0] + floor, 0};                       // centre of the round bottom
bottom = newp; Point(bottom) = {0, py[0] + floor - Sqrt(2)*floor, 0};
inner = newp; Point(inner) = {0, below, 0};
l[] = {newl, newl + 1, newl + 2};
Circle(l[0]) = {bottom, p, corner[0]};
Line(l[1]) = {inner, edge[0]};
Line(l[2]) = {bottom, inner};
c = newll; Curve Loop(c) = {l[0], across[0], -l[1], -l[2]};
s = news; Plane Surface(s) = {c}; faces[] += s;
p = newp; Point(p) = {0, 0, 0};
q[] = {newp, newp + 1};
Point(q[0]) = {0, bore, 0};
Point(q[1]) = {bore*Sin(Pi/blades), bore*Cos(Pi/blades), 0};
m[] = {newl, newl + 1, newl + 2};
Line(m[0]) = {inner, q[0]};
Circle(m[1]) = {q[0], p, q[1]};
Line(m[2]) = {edge[0], q[1]};
c = newll; Curve Loop(c) = {l[1], m[2], -m[1], -m[0]};
s = news; Plane Surface(s) = {c}; faces[] += s;
Transfinite Curve{l[0], l[1], m[1]} = 4 + 1;
Transfinite Curve{l[2]} = n_across + 1 Using Progression growth;
Transfinite Curve{m[0], m[2]} = 8 + 1 Using Progression 1.3;
Transfinite Surface{faces[]};
Recombine Surface{faces[]};
Physical Surface("disc") = {faces[]};
For j In {0:1}
  y = j ? level_2 : level; x = j ? neck_2 : neck_1; f = j ? flank_2 : flank_1;
  s[] = Curve In BoundingBox {x - e, y - e, -e, x + f + e, y + f + e, e};
  s[] -= {blade_flanks[j]};
  Physical Curve(Sprintf("disc_flank_%g", j + 1)) = {s[]};
EndFor

// Curves of the disc on the plane between two blades: beyond the strips, and below them.
Physical Curve("between_blades") = {sides[], m[2]};
s[] = Curve In BoundingBox {-e, 0, -e, e, top + e, e};
Physical Curve("symmetry_x") = {s[]};
