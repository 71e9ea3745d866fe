#include "input/meshes/read_mesh.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "input/meshes/gmsh.hpp"
#include "input/meshes/scanner.hpp"
#include "input/meshes/stl.hpp"
#include "mesh/transform.hpp"

namespace corpuscle {

namespace {

Mesh read_any(Scanner scanner)
{
    if (scanner.rest().starts_with("$MeshFormat")) return read_gmsh(std::move(scanner));
    if (looks_like_stl(scanner) || scanner.file().ends_with(".stl") || scanner.file().ends_with(".STL"))
        return read_stl(std::move(scanner));
    scanner.fail("this is no mesh file that is known", "give a gmsh file (.msh, version 2.2 or 4.1) or a surface (.stl)");
}

}  // namespace

Mesh read_mesh(const std::string& file, double unit_in_metre)
{
    if (!(unit_in_metre > 0.0) || !std::isfinite(unit_in_metre))
        throw InputError(fmt::format("the unit of mesh '{}' is {:.6g} m", file, unit_in_metre), "give a unit of length such as \"mm\"");
    Mesh mesh = read_any(Scanner::open(file));
    if (unit_in_metre != 1.0) scale(mesh, unit_in_metre);
    return mesh;
}

}  // namespace corpuscle
