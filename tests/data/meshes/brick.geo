// A unit cube: 8 hexahedra. Made into brick_*.msh by gmsh 4.8.
Point(1) = {0, 0, 0, 1};
line[] = Extrude {1, 0, 0} { Point{1}; Layers{2}; Recombine; };
face[] = Extrude {0, 1, 0} { Line{line[1]}; Layers{2}; Recombine; };
body[] = Extrude {0, 0, 1} { Surface{face[1]}; Layers{2}; Recombine; };
Physical Volume("brick") = {body[1]};
Physical Surface("floor") = {face[1]};
