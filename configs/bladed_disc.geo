// One of 36 sectors of a bladed disc: disc, leaning blade and shroud in one piece. z is the axis of rotation. The section z = 0
// is swept along z and turned about it at the same time, so that blade and shroud are staggered. The cuts between two sectors are
// meshed alike: each node of the second face is one of the first, turned by the angle of the sector.
DefineConstant[
  blades   = {36,   Name "Parameters/number of blades"},
  bore     = {80,   Name "Parameters/radius of the bore"},
  rim      = {200,  Name "Parameters/radius of the rim"},
  tip      = {270,  Name "Parameters/inner radius of the shroud"},
  top      = {276,  Name "Parameters/outer radius of the shroud"},
  foot     = {12,   Name "Parameters/thickness of the blade at the rim"},
  head     = {6,    Name "Parameters/thickness of the blade at the shroud"},
  lean     = {4,    Name "Parameters/tangential distance of the blade's head from the radius through its foot"},
  fillet   = {4,    Name "Parameters/radius of the fillets of the blade"},
  width    = {30,   Name "Parameters/axial width"},
  stagger  = {20,   Name "Parameters/stagger angle of the shroud in degrees"},
  n_width  = {6,    Name "Parameters/elements along the width"},
  n_shroud = {4,    Name "Parameters/elements through the shroud"},
  size     = {10,   Name "Parameters/size of elements in the disc"}
];

half = Pi/blades;
fine = size*0.16;   // in the fillets
small = size*0.3;   // in the blade

centre = newp; Point(centre) = {0, 0, 0};
// The sides of the blade: from foot to head, and a fillet at each end. A fillet touches the side and the circle of the rim or of
// the shroud; its centre lies at a distance of its radius from both.
// For j = 0 the side that looks to smaller angles, for j = 1 the other one.
For j In {0:1}
  sign = 2*j - 1;
  ax = rim; ay = sign*foot/2; bx = tip; by = lean + sign*head/2;
  l = Sqrt((bx - ax)^2 + (by - ay)^2);
  dx = (bx - ax)/l; dy = (by - ay)/l;      // along the side
  nx = -sign*dy; ny = sign*dx;             // away from the blade
  ox = ax + fillet*nx; oy = ay + fillet*ny;
  along = ox*dx + oy*dy; square = ox^2 + oy^2;
  s1 = -along + Sqrt(along^2 - square + (rim + fillet)^2);
  s2 = -along + Sqrt(along^2 - square + (tip - fillet)^2);
  c1 = newp; Point(c1) = {ox + s1*dx, oy + s1*dy, 0};
  c2 = newp; Point(c2) = {ox + s2*dx, oy + s2*dy, 0};
  on_rim~{j} = newp; Point(on_rim~{j}) = {(ox + s1*dx)*rim/(rim + fillet), (oy + s1*dy)*rim/(rim + fillet), 0, fine};
  low~{j} = newp; Point(low~{j}) = {ax + s1*dx, ay + s1*dy, 0, fine};
  high~{j} = newp; Point(high~{j}) = {ax + s2*dx, ay + s2*dy, 0, fine};
  on_tip~{j} = newp; Point(on_tip~{j}) = {(ox + s2*dx)*tip/(tip - fillet), (oy + s2*dy)*tip/(tip - fillet), 0, fine};
  arc_1~{j} = newl; Circle(arc_1~{j}) = {on_rim~{j}, c1, low~{j}};
  side~{j} = newl; Line(side~{j}) = {low~{j}, high~{j}};
  arc_2~{j} = newl; Circle(arc_2~{j}) = {high~{j}, c2, on_tip~{j}};
  // The disc's cut and the shroud's end.
  a = sign*half;
  bore~{j} = newp; Point(bore~{j}) = {bore*Cos(a), bore*Sin(a), 0, size};
  rim~{j} = newp; Point(rim~{j}) = {rim*Cos(a), rim*Sin(a), 0, 0.6*size};
  cut~{j} = newl; Line(cut~{j}) = {bore~{j}, rim~{j}};
  Transfinite Curve{cut~{j}} = Ceil((rim - bore)/size) + 1;
  a = sign*half + lean/tip;
  tip~{j} = newp; Point(tip~{j}) = {tip*Cos(a), tip*Sin(a), 0, small};
  top~{j} = newp; Point(top~{j}) = {top*Cos(a), top*Sin(a), 0, small};
  end~{j} = newl; Line(end~{j}) = {tip~{j}, top~{j}};
  Transfinite Curve{end~{j}} = n_shroud + 1;
  rim_part~{j} = newl; Circle(rim_part~{j}) = {rim~{j}, centre, on_rim~{j}};
  tip_part~{j} = newl; Circle(tip_part~{j}) = {on_tip~{j}, centre, tip~{j}};
EndFor
key = newp; Point(key) = {bore, 0, 0, size};
bore_part_0 = newl; Circle(bore_part_0) = {bore_0, centre, key};
bore_part_1 = newl; Circle(bore_part_1) = {key, centre, bore_1};
outer = newl; Circle(outer) = {top_0, centre, top_1};
loop = newll;
Curve Loop(loop) = {bore_part_0, bore_part_1, cut_1, rim_part_1, arc_1_1, side_1, arc_2_1, tip_part_1, end_1, -outer,
                    -end_0, -tip_part_0, -arc_2_0, -side_0, -arc_1_0, -rim_part_0, -cut_0};
section = news; Plane Surface(section) = {loop};
Recombine Surface{section};

twist = width*Tan(stagger*Pi/180)/top;
out[] = Extrude { {0, 0, width}, {0, 0, 1}, {0, 0, 0}, twist } { Surface{section}; Layers{n_width}; Recombine; };
// out: the face at z = width, the volume, and a side for each curve of the loop in its order.
Physical Volume("sector") = {out[1]};
Physical Surface("bore") = {out[2], out[3]};
Physical Surface("cut_high") = {out[4]};
Physical Surface("pressure_side") = {out[7]};
Physical Surface("shroud_high") = {out[10]};
Physical Surface("shroud_low") = {out[12]};
Physical Surface("cut_low") = {out[18]};
Physical Curve("bore_edge") = {bore_part_0, bore_part_1};
Physical Point("key") = {key};
