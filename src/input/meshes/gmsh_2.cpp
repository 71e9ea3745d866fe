#include <algorithm>

#include <fmt/format.h>

#include "input/meshes/gmsh_content.hpp"

namespace corpuscle {

namespace {

/// Reads integers and reals of either flavour; integers are 4 bytes in binary.
class Gmsh2Reader {
public:
    Gmsh2Reader(Scanner& scanner, bool binary) : scanner_(scanner), binary_(binary) {}

    std::int64_t integer(const char* what) { return binary_ ? scanner_.bytes<int>(what) : scanner_.integer(what); }
    Vector3d point()
    {
        const auto coordinate = [&] { return binary_ ? scanner_.bytes<double>("a coordinate") : scanner_.real("a coordinate"); };
        const double x = coordinate(), y = coordinate(), z = coordinate();
        return {x, y, z};
    }

private:
    Scanner& scanner_;
    bool binary_;
};

/// The count at the head of a section is text in both flavours.
std::size_t head_count(Scanner& scanner, std::size_t least_bytes, const char* what)
{
    const std::int64_t count = scanner.integer(what);
    scanner.line();
    return scanner.count(count, least_bytes, what);
}

void read_nodes(Scanner& scanner, bool binary, GmshContent& content)
{
    Gmsh2Reader reader(scanner, binary);
    const std::size_t count = head_count(scanner, binary ? 28 : 8, "nodes");
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t tag = reader.integer("the number of a node");
        content.add_node(scanner, tag, reader.point());
    }
}

/// The tags behind an element's type: the first is its physical group (0: none).
std::vector<std::int64_t> read_groups(Scanner& scanner, Gmsh2Reader& reader, std::int64_t tags)
{
    if (tags < 0 || tags > 1000) scanner.fail(fmt::format("an element with {} tags", tags), "the file may be damaged: save it again");
    std::vector<std::int64_t> groups;
    for (std::int64_t i = 0; i < tags; ++i) {
        const std::int64_t tag = reader.integer("a tag of an element");
        if (i == 0 && tag != 0) groups.push_back(tag);
    }
    return groups;
}

std::array<std::int64_t, 8> read_corners(Gmsh2Reader& reader, int count)
{
    std::array<std::int64_t, 8> corners{};
    for (int i = 0; i < count; ++i) corners[i] = reader.integer("a node of an element");
    return corners;
}

void read_text_elements(Scanner& scanner, GmshContent& content)
{
    Gmsh2Reader reader(scanner, false);
    const std::size_t count = head_count(scanner, 6, "elements");
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t number = scanner.integer("the number of an element");
        const GmshType type = gmsh_type(scanner, scanner.integer("the type of an element"));
        const auto groups = read_groups(scanner, reader, scanner.integer("the number of tags"));
        content.add_element(scanner, type, number, groups, read_corners(reader, type.nodes));
    }
}

/// Blocks of elements of one type, each with a head of type, number of elements and number of tags.
void read_binary_elements(Scanner& scanner, GmshContent& content)
{
    Gmsh2Reader reader(scanner, true);
    const std::size_t count = head_count(scanner, 8, "elements");
    for (std::size_t done = 0; done < count;) {
        const GmshType type = gmsh_type(scanner, reader.integer("the type of a block"));
        const std::size_t block = scanner.count(reader.integer("the size of a block"), 8, "elements of a block");
        const std::int64_t tags = reader.integer("the number of tags");
        if (block == 0 || block > count - done)
            scanner.fail(fmt::format("a block of {} elements where {} are left", block, count - done), "save the file again");
        for (std::size_t i = 0; i < block; ++i) {
            const std::int64_t number = reader.integer("the number of an element");
            const auto groups = read_groups(scanner, reader, tags);
            content.add_element(scanner, type, number, groups, read_corners(reader, type.nodes));
        }
        done += block;
    }
}

}  // namespace

void read_gmsh_2(Scanner& scanner, bool binary, GmshContent& content)
{
    for (std::string section = next_section(scanner); !section.empty(); section = next_section(scanner)) {
        if (section == "PhysicalNames") read_physical_names(scanner, content);
        if (section == "Nodes") read_nodes(scanner, binary, content);
        if (section == "Elements" && binary) read_binary_elements(scanner, content);
        if (section == "Elements" && !binary) read_text_elements(scanner, content);
        scanner.skip_past_line("$End" + section);
    }
}

}  // namespace corpuscle
