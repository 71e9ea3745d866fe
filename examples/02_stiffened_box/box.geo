// A quarter of a V-shaped hull: bottom, sides, deck, girders and bulkheads, all joined. Lengths in mm.
// Made into box.msh by gmsh 4.8: gmsh -2 box.geo -o box.msh
size = 25;
half_width = 600; half_length = 500; keel = 300; chine = 430; deck = 550; girder = 250; bulkhead = 250; layers = 6;
For s In {0:2}
  y = (s == 0) ? 0 : ((s == 1) ? bulkhead : half_length);
  Point(10*s + 1) = {0, y, keel};
  Point(10*s + 2) = {girder, y, keel + (chine - keel)*girder/half_width};
  Point(10*s + 3) = {half_width, y, chine};
  Point(10*s + 4) = {half_width, y, deck};
  Point(10*s + 5) = {girder, y, deck};
  Point(10*s + 6) = {0, y, deck};
  // Round the section: bottom inside and outside the girder, side, deck, then the girder and the plane of symmetry.
  Line(100*s + 1) = {10*s + 1, 10*s + 2};
  Line(100*s + 2) = {10*s + 2, 10*s + 3};
  Line(100*s + 3) = {10*s + 3, 10*s + 4};
  Line(100*s + 4) = {10*s + 4, 10*s + 5};
  Line(100*s + 5) = {10*s + 5, 10*s + 6};
  Line(100*s + 6) = {10*s + 2, 10*s + 5};
  Line(100*s + 7) = {10*s + 6, 10*s + 1};
  Transfinite Curve {100*s + 1, 100*s + 5} = girder/size + 1;
  Transfinite Curve {100*s + 2, 100*s + 4} = (half_width - girder)/size + 1;
  Transfinite Curve {100*s + 3, 100*s + 6, 100*s + 7} = layers + 1;
EndFor
For s In {0:1}
  For p In {1:6}
    Line(1000 + 100*s + p) = {10*s + p, 10*s + 10 + p};
    Transfinite Curve {1000 + 100*s + p} = 250/size + 1;
  EndFor
  a = 100*s; b = a + 100; c = 1000 + 100*s;
  For f In {1:5}
    Curve Loop(10*s + f) = {a + f, c + f + 1, -(b + f), -(c + f)};
  EndFor
  Curve Loop(10*s + 6) = {a + 6, c + 5, -(b + 6), -(c + 2)};
  Curve Loop(10*s + 7) = {b + 1, b + 6, b + 5, b + 7};
  Curve Loop(10*s + 8) = {b + 2, b + 3, b + 4, -(b + 6)};
  For f In {1:8}
    Plane Surface(10*s + f) = {10*s + f};
    Transfinite Surface {10*s + f};
  EndFor
EndFor
Recombine Surface {1:8, 11:18};
Mesh.MshFileVersion = 4.1;
Physical Surface("bottom") = {1, 2, 11, 12};
Physical Surface("sides") = {3, 13};
Physical Surface("deck") = {4, 5, 14, 15};
Physical Surface("girders") = {6, 16};
Physical Surface("bulkheads") = {7, 8, 17, 18};
Physical Surface("box") = {1:8, 11:18};
Physical Curve("keel") = {1001, 1101};
