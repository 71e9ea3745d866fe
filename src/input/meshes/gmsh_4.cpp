#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "input/meshes/gmsh_content.hpp"

namespace corpuscle {

namespace {

using Entity = std::pair<int, std::int64_t>;  // dimension and number
using Groups = std::map<Entity, std::vector<std::int64_t>>;

/// Reads the numbers of either flavour: in binary, tags of entities are 4 bytes, counts and other tags 8.
class Gmsh4Reader {
public:
    Gmsh4Reader(Scanner& scanner, bool binary) : scanner_(scanner), binary_(binary) {}

    std::int64_t small(const char* what) { return binary_ ? scanner_.bytes<int>(what) : scanner_.integer(what); }
    std::int64_t large(const char* what)
    {
        return binary_ ? static_cast<std::int64_t>(scanner_.bytes<std::uint64_t>(what)) : scanner_.integer(what);
    }
    double real(const char* what) { return binary_ ? scanner_.bytes<double>(what) : scanner_.real(what); }
    std::size_t count(std::size_t least_bytes, const char* what) { return scanner_.count(large(what), least_bytes, what); }
    Vector3d point()
    {
        const double x = real("a coordinate"), y = real("a coordinate"), z = real("a coordinate");
        return {x, y, z};
    }

private:
    Scanner& scanner_;
    bool binary_;
};

/// The box, physical groups (negative: turned) and, but for points, what bounds an entity.
void read_rest_of_entity(Gmsh4Reader& reader, const Entity& entity, Groups& groups)
{
    reader.point();
    if (entity.first > 0) reader.point();
    const std::size_t physical = reader.count(2, "physical groups");
    for (std::size_t i = 0; i < physical; ++i) {
        const std::int64_t group = reader.small("a physical group");
        groups[entity].push_back(group < 0 ? -group : group);
    }
    if (entity.first == 0) return;
    const std::size_t bounding = reader.count(2, "bounding entities");
    for (std::size_t i = 0; i < bounding; ++i) reader.small("a bounding entity");
}

Groups read_entities(Gmsh4Reader& reader)
{
    std::array<std::size_t, 4> counts{};
    for (std::size_t& count : counts) count = reader.count(8, "entities");
    Groups groups;
    for (int dimension = 0; dimension < 4; ++dimension)
        for (std::size_t i = 0; i < counts[dimension]; ++i)
            read_rest_of_entity(reader, {dimension, reader.small("the number of an entity")}, groups);
    return groups;
}

/// Entities of a mesh cut into partitions, which have its elements. They belong to the groups of the entities they were cut from, too.
void read_partitioned_entities(Gmsh4Reader& reader, Groups& groups)
{
    reader.large("the number of partitions");
    const std::size_t ghosts = reader.count(4, "ghost entities");
    for (std::size_t i = 0; i < 2 * ghosts; ++i) reader.small("a ghost entity and its partition");
    std::array<std::size_t, 4> counts{};
    for (std::size_t& count : counts) count = reader.count(8, "entities");
    for (int dimension = 0; dimension < 4; ++dimension)
        for (std::size_t i = 0; i < counts[dimension]; ++i) {
            const Entity entity{dimension, reader.small("the number of an entity")};
            const std::int64_t parent_dimension = reader.small("the dimension of the entity cut");
            const Entity parent{static_cast<int>(parent_dimension), reader.small("the number of the entity cut")};
            const std::size_t partitions = reader.count(2, "partitions of an entity");
            for (std::size_t k = 0; k < partitions; ++k) reader.small("a partition");
            groups[entity].clear();
            if (const auto whole = groups.find(parent); parent.first == dimension && parent != entity && whole != groups.end())
                groups[entity] = whole->second;
            read_rest_of_entity(reader, entity, groups);
        }
}

/// The head of a block of nodes or elements, as the file has it.
struct Head {
    std::size_t blocks;
    std::size_t entries;
};

Head read_head(Gmsh4Reader& reader, const char* what)
{
    const Head head{reader.count(8, "blocks"), reader.count(2, what)};
    reader.large("the smallest tag");
    reader.large("the largest tag");
    return head;
}

void read_nodes(Scanner& scanner, Gmsh4Reader& reader, GmshContent& content)
{
    const Head head = read_head(reader, "nodes");
    std::size_t read = 0;
    std::vector<std::int64_t> tags;
    for (std::size_t block = 0; block < head.blocks; ++block) {
        const std::int64_t dimension = reader.small("the dimension of an entity");
        reader.small("the number of an entity");
        const bool parametric = reader.small("whether nodes have parameters") != 0;
        tags.resize(reader.count(2, "nodes of a block"));
        for (std::int64_t& tag : tags) tag = reader.large("the number of a node");
        for (const std::int64_t tag : tags) {
            content.add_node(scanner, tag, reader.point());
            for (std::int64_t i = 0; parametric && i < dimension; ++i) reader.real("a parameter of a node");
        }
        read += tags.size();
    }
    if (read != head.entries) scanner.fail(fmt::format("{} nodes were announced, {} came", head.entries, read), "save the file again");
}

void read_elements(Scanner& scanner, Gmsh4Reader& reader, const Groups& groups, GmshContent& content)
{
    const Head head = read_head(reader, "elements");
    std::size_t read = 0;
    for (std::size_t block = 0; block < head.blocks; ++block) {
        const std::int64_t dimension = reader.small("the dimension of an entity");
        const Entity entity{static_cast<int>(dimension), reader.small("the number of an entity")};
        const GmshType type = gmsh_type(scanner, reader.small("the type of a block"));
        const auto found = groups.find(entity);
        const std::vector<std::int64_t> none, &own = found == groups.end() ? none : found->second;
        const std::size_t count = reader.count(4, "elements of a block");
        for (std::size_t i = 0; i < count; ++i) {
            const std::int64_t number = reader.large("the number of an element");
            std::array<std::int64_t, 8> corners{};
            for (int k = 0; k < type.nodes; ++k) corners[k] = reader.large("a node of an element");
            content.add_element(scanner, type, number, own, corners);
        }
        read += count;
    }
    if (read != head.entries) scanner.fail(fmt::format("{} elements were announced, {} came", head.entries, read), "save the file again");
}

}  // namespace

void read_gmsh_4(Scanner& scanner, bool binary, GmshContent& content)
{
    Gmsh4Reader reader(scanner, binary);
    Groups groups;
    for (std::string section = next_section(scanner); !section.empty(); section = next_section(scanner)) {
        if (section == "PhysicalNames") read_physical_names(scanner, content);
        if (section == "Entities") groups = read_entities(reader);
        if (section == "PartitionedEntities") read_partitioned_entities(reader, groups);
        if (section == "Nodes") read_nodes(scanner, reader, content);
        if (section == "Elements") read_elements(scanner, reader, groups, content);
        scanner.skip_past_line("$End" + section);
    }
}

}  // namespace corpuscle
