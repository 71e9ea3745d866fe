#include "input/meshes/gmsh.hpp"

#include <fmt/format.h>

#include "input/meshes/gmsh_content.hpp"

namespace corpuscle {

namespace {

/// What $MeshFormat says.
struct Format {
    std::string version;
    bool binary = false;
};

Format read_format(Scanner& scanner)
{
    scanner.line();
    Format format;
    format.version = scanner.word("the version of the format");
    const std::int64_t kind = scanner.integer("0 for text or 1 for binary");
    const std::int64_t size = scanner.integer("the size of a number");
    scanner.line();
    if (format.version != "2.2" && format.version != "4.1")
        scanner.fail(fmt::format("gmsh format {} is not supported", format.version),
                     "save as version 4.1 or 2.2 (in gmsh: gmsh -0 FILE -format msh41 -o NEW, or Mesh.MshFileVersion = 4.1)");
    if (kind != 0 && kind != 1) scanner.fail("the format is neither text (0) nor binary (1)", "save the file again");
    if (size != 8) scanner.fail(fmt::format("numbers of {} bytes are not supported", size), "save on a 64-bit machine, or as text");
    format.binary = kind == 1;
    scanner.set_binary(format.binary);
    if (format.binary && scanner.bytes<int>("the byte-order mark") != 1)
        scanner.fail("the file was written on a machine of the other byte order", "save as text (in gmsh: Mesh.Binary = 0)");
    scanner.skip_past_line("$EndMeshFormat");
    return format;
}

}  // namespace

Mesh read_gmsh(Scanner scanner)
{
    const Format format = read_format(scanner);
    GmshContent content;
    if (format.version == "2.2")
        read_gmsh_2(scanner, format.binary, content);
    else
        read_gmsh_4(scanner, format.binary, content);
    return content.mesh(scanner);
}

}  // namespace corpuscle
