// Half of one blade pitch of a fir-tree root in its disc, as a section: y is radial, z the axis of rotation, x = 0 the middle of
// the root. Flanks at 45 degrees: those that face outwards bear, the others keep a clearance. Triangles, small along the root.
// The numbers here are defaults: [mesh.parameters] of blade_root.toml overrides them.
SetFactory("OpenCASCADE"); // which leaves the coinciding flanks of the two bodies apart
DefineConstant[
  blades    = {60,  Name "Parameters/number of blades"},
  bore      = {60,  Name "Parameters/radius of the bore of the disc"},
  rim       = {296, Name "Parameters/radius of the rim of the disc"},
  top       = {305, Name "Parameters/radius of the top of the root"},
  lobes     = {2,   Name "Parameters/number of lobes"},
  neck      = {7,   Name "Parameters/half of the width of the root above its lobes"},
  flank     = {3.5, Name "Parameters/width of a bearing flank, measured along x"},
  taper     = {2.5, Name "Parameters/by this a lobe is less wide, on each side, than the one above it"},
  fillet    = {1.5, Name "Parameters/radius of the fillets"},
  clearance = {0.3, Name "Parameters/clearance of the flanks that do not bear, measured radially"},
  land      = {4,   Name "Parameters/distance of the uppermost flank from the rim"},
  h         = {0.6, Name "Parameters/element size along the root"},
  h_far     = {20,  Name "Parameters/element size at the bore"}
];
k = fillet/Sqrt(2);
pitch = 2*flank + taper + 4*k - clearance;          // of the lobes
level = rim - land - flank - (lobes - 1)*pitch;     // radius where the lowest flank begins
lobe = neck + flank - (lobes - 1)*taper;            // half of the width of the lowest lobe
foot = Min(3, 0.5*lobe);                            // chamfer below it
If (rim*Tan(Pi/blades) < neck + flank + 1.5*fillet || lobe < 1.1*flank)
  Error("no room for the root: half a pitch at the rim is %g, the uppermost lobe %g, the lowest %g wide",
        rim*Tan(Pi/blades), neck + flank, lobe);
EndIf

Macro Line_
  // adds a line from the last point to x, y; out: l
  p = newp; Point(p) = {x, y, 0, size};
  l = newl; Line(l) = {last, p}; contour[] += l; last = p;
Return
Macro Arc_
  // adds an arc about xc, yc from the last point to x, y
  p = newp; Point(p) = {x, y, 0, size}; Point(p + 1) = {xc, yc, 0};
  l = newl; Circle(l) = {last, p + 1, p}; contour[] += l; last = p;
Return
Macro Close_
  // out: s, the surface within the contour; l, the line that closes it
  l = newl; Line(l) = {last, first}; contour[] += l;
  c = newll; Curve Loop(c) = {contour[]};
  s = news; Plane Surface(s) = {c};
Return

// The blade: from the middle of its foot along the lobes to the top, and down the middle.
size = h;
contour[] = {}; blade_flanks[] = {};
first = newp; last = first; Point(first) = {0, level - 2*k + clearance - foot, 0, size};
x = lobe - foot; y = level - 2*k + clearance - foot; Call Line_;
For i In {0:lobes - 1}
  w = lobe + i*taper; v = level + i*pitch;
  x = w; y = v - 2*k + clearance; Call Line_;
  y = v; Call Line_;
  x = w - flank; y = v + flank; Call Line_;
  blade_flanks[] += l;
  xc = x + k; yc = y + k;
  If (i < lobes - 1)
    y += 2*k; Call Arc_;
  Else
    x += k - fillet; y += k; Call Arc_;
  EndIf
EndFor
size = 2*h;
y = top; Call Line_;
x = 0; Call Line_;
blade_top = l;
Call Close_;
blade = s; middle[] = {l};

// The disc: from the bottom of the slot along the grooves to the rim, down between two blades to the bore, and up the middle.
size = h;
contour[] = {}; disc_flanks[] = {};
bottom = level - 2*k - foot; round = lobe - foot; // the bottom of the slot is round
first = newp; last = first; Point(first) = {0, bottom + round - Sqrt(2)*round, 0, 2*h};
x = round; y = bottom; xc = 0; yc = bottom + round; Call Arc_;
For i In {0:lobes - 1}
  w = lobe + i*taper; v = level + i*pitch;
  x = w; y = v - 2*k; Call Line_;
  y = v; xc = w - k; yc = v - k; Call Arc_;
  x = w - flank; y = v + flank; Call Line_;
  disc_flanks[] += l;
  If (i < lobes - 1)
    y += 2*k - clearance; Call Line_;
  EndIf
EndFor
size = 2*h;
y = rim; Call Line_;
x = rim*Tan(Pi/blades); Call Line_;
size = h_far;
x = bore*Sin(Pi/blades); y = bore*Cos(Pi/blades); Call Line_;
between = l;
x = 0; y = bore; xc = 0; yc = 0; Call Arc_;
Call Close_;
disc = s; middle[] += l;

Physical Surface("blade") = {blade};
Physical Surface("disc") = {disc};
Physical Curve("blade_flanks") = {blade_flanks[]};
Physical Curve("disc_flanks") = {disc_flanks[]};
For i In {0:lobes - 1} // disc_flank_1 is the lowest
  Physical Curve(Sprintf("disc_flank_%g", i + 1)) = {disc_flanks[i]};
EndFor
Physical Curve("blade_top") = {blade_top};
Physical Curve("between_blades") = {between};
Physical Curve("middle") = {middle[]};
