#include "input/meshes/abaqus_makers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

namespace corpuscle {

namespace {

constexpr const char* write_out = "write the mesh out with all its nodes and elements";
constexpr std::int64_t most_copies = 100'000'000;  // of one line: above is a slip

/// The option that names the set for what a keyword makes.
const char* set_option(const std::string& keyword)
{
    static const std::map<std::string, const char*> names{
        {"NGEN", "NSET"}, {"NFILL", "NSET"}, {"NCOPY", "NEW SET"}, {"ELGEN", "ELSET"}, {"ELCOPY", "NEW SET"}};
    return names.at(keyword);
}

Vector3d point_of(const std::vector<double>& values, std::size_t first)
{
    return {values[first], values[first + 1], values[first + 2]};
}

}  // namespace

bool AbaqusMaker::knows(const std::string& keyword)
{
    return keyword == "NGEN" || keyword == "NFILL" || keyword == "NCOPY" || keyword == "ELGEN" || keyword == "ELCOPY";
}

void AbaqusMaker::begin(const AbaqusKeyword& keyword, NumberedMesh& mesh)
{
    keyword_ = keyword;
    mesh_ = &mesh;
    place_ = lines_.place();
    data_.clear();
    for (const char* other : {"LINE", "BIAS", "SINGULAR", "TWO STEP", "POLE", "MULTIPLE", "SYSTEM", "ALL NODES"})
        if (keyword.has(other)) lines_.fail(fmt::format("*{} with {} is not read", keyword.name, other), write_out);
    const std::string& name = keyword.of(set_option(keyword.name));
    const bool of_nodes = keyword.name.starts_with('N');
    const std::string key = in_capitals(name);
    set_ = name.empty() ? nullptr : of_nodes ? &mesh.node_set(key, name) : &mesh.element_set(key, name);
}

void AbaqusMaker::read()
{
    if (keyword_.name == "NGEN") return generate_nodes();
    if (keyword_.name == "NFILL") return fill_nodes();
    if (keyword_.name == "ELGEN") return generate_elements();
    if (keyword_.name == "ELCOPY") lines_.fail("*ELCOPY has no data", "take the line out");
    std::vector<double> values;
    for (const std::string_view field : comma_fields(lines_.text()))
        values.push_back(real_field(lines_, field, "where nodes are copied to"));
    data_.push_back(values);
}

void AbaqusMaker::finish()
{
    if (mesh_ == nullptr) return;
    if (keyword_.name == "NCOPY") copy_nodes();
    if (keyword_.name == "ELCOPY") copy_elements();
    mesh_ = nullptr;
}

std::int64_t AbaqusMaker::option(const char* name) const
{
    if (!keyword_.has(name)) lines_.fail_at(place_, fmt::format("*{} needs {}", keyword_.name, name), "add the option");
    return integer_field(lines_, keyword_.of(name), name);
}

AbaqusMaker::Numbers AbaqusMaker::whole_fields(std::size_t least) const
{
    Numbers numbers;
    for (const std::string_view field : comma_fields(lines_.text())) {
        numbers.push_back(integer_field(lines_, field, "a whole number"));
        if (std::abs(numbers.back()) >= NumberedMesh::numbers) lines_.fail(fmt::format("{} is too large a number", field), write_out);
    }
    if (numbers.size() < least) lines_.fail(fmt::format("*{} needs {} numbers on each line", keyword_.name, least), "complete the line");
    return numbers;
}

const Vector3d& AbaqusMaker::place_of(std::int64_t node)
{
    const NumberedMesh::Node* found = mesh_->find_node(node);
    if (found == nullptr) lines_.fail(fmt::format("there is no node {} to make others of", node), "define it before this line");
    return found->position;
}

void AbaqusMaker::add_node(std::int64_t number, const Vector3d& place)
{
    if (number < 1 || number >= NumberedMesh::numbers)
        lines_.fail(fmt::format("a node with the number {} is made", number), "numbers begin at 1: correct the increments");
    if (mesh_->find_node(number) == nullptr) mesh_->add_node({number, place, lines_.place()});
    if (set_ != nullptr) set_->members.push_back({number, number, 1, "", false, lines_.place()});
}

/// Nodes evenly on the line between two, their numbers from that of the first on.
void AbaqusMaker::add_between(std::int64_t first, std::int64_t last, std::int64_t intervals, std::int64_t increment, const char* what)
{
    if (increment == 0 || intervals < 1 || intervals > most_copies)
        lines_.fail(fmt::format("{} from node {} to node {} has {} steps of {}", what, first, last, intervals, increment),
                    "correct the numbers or the increment");
    const Vector3d from = place_of(first), to = place_of(last);
    for (std::int64_t i = 1; i < intervals; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(intervals);
        add_node(first + i * increment, from + share * (to - from));
    }
}

/// *NGEN: first node, last node, increment of numbers.
void AbaqusMaker::generate_nodes()
{
    const Numbers line = whole_fields(2);
    const std::int64_t size = line.size() > 2 && line[2] != 0 ? std::abs(line[2]) : 1, span = line[1] - line[0];
    if (span % size != 0)
        lines_.fail(fmt::format("nodes {} and {} are no multiple of {} apart", line[0], line[1], size), "correct the increment");
    add_between(line[0], line[1], std::abs(span) / size, span < 0 ? -size : size, "a line");
    if (set_ != nullptr)
        for (const std::int64_t end : {line[0], line[1]}) set_->members.push_back({end, end, 1, "", false, lines_.place()});
}

/// *NFILL: two sets of nodes, how many intervals between them, increment of numbers from the nodes of the first.
void AbaqusMaker::fill_nodes()
{
    const auto fields = comma_fields(lines_.text());
    if (fields.size() < 3) lines_.fail("*NFILL needs two sets, the number of intervals and the increment", "complete the line");
    const std::int64_t intervals = integer_field(lines_, fields[2], "a number of intervals");
    const std::int64_t increment = fields.size() > 3 ? integer_field(lines_, fields[3], "an increment") : 1;
    const Numbers from = mesh_->nodes_in_set(lines_, in_capitals(fields[0])), to = mesh_->nodes_in_set(lines_, in_capitals(fields[1]));
    for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i) add_between(from[i], to[i], intervals, increment, "the filling");
    if (set_ == nullptr) return;
    for (const Numbers* ends : {&from, &to})
        for (const std::int64_t end : *ends) set_->members.push_back({end, end, 1, "", false, lines_.place()});
}

/// *ELGEN: a master element, then up to three directions: how many, increments of the numbers of nodes and elements.
void AbaqusMaker::generate_elements()
{
    const Numbers line = whole_fields(2);
    std::array<Row, 3> rows;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const auto field = [&](std::size_t index, std::int64_t missing) {
            return index < line.size() && line[index] != 0 ? line[index] : missing;
        };
        rows[r] = {field(1 + 3 * r, 1), field(2 + 3 * r, r == 0 ? 1 : 0), field(3 + 3 * r, r == 0 ? 1 : 0)};
        if (rows[r].count < 1 || rows[r].count > most_copies)
            lines_.fail(fmt::format("{} elements are to be made", rows[r].count), write_out);
    }
    if (static_cast<double>(rows[0].count) * static_cast<double>(rows[1].count) * static_cast<double>(rows[2].count) > most_copies)
        lines_.fail("too many elements are to be made", "correct the numbers of elements, rows and layers");
    const NumberedMesh::Element* found = mesh_->find_element(line[0]);
    if (found == nullptr) lines_.fail(fmt::format("there is no element {} to make others of", line[0]), "define it before this line");
    const NumberedMesh::Element master = *found;
    for (std::int64_t layer = 0; layer < rows[2].count; ++layer)
        for (std::int64_t row = 0; row < rows[1].count; ++row)
            for (std::int64_t i = 0; i < rows[0].count; ++i)
                add_copy(master, i * rows[0].nodes + row * rows[1].nodes + layer * rows[2].nodes,
                         i * rows[0].elements + row * rows[1].elements + layer * rows[2].elements);
}

void AbaqusMaker::add_copy(const NumberedMesh::Element& master, std::int64_t nodes, std::int64_t elements, bool mirrored)
{
    NumberedMesh::Element copy = master;
    copy.number += elements;
    copy.place = place_;
    if (copy.number < 1 || copy.number >= NumberedMesh::numbers)
        lines_.fail_at(place_, fmt::format("an element with the number {} is made", copy.number),
                       "numbers begin at 1: correct the increments");
    for (int i = 0; i < copy.corners; ++i) copy.node[i] += nodes;
    if (mirrored) mirror(copy);
    if (elements != 0 || nodes != 0) mesh_->add_element(copy);
    if (set_ != nullptr) set_->members.push_back({copy.number, copy.number, 1, "", false, place_});
}

/// *ELCOPY: the elements of a set with numbers, and numbers of nodes, that are greater.
void AbaqusMaker::copy_elements()
{
    const std::int64_t elements = option("ELEMENT SHIFT"), nodes = option("SHIFT NODES");
    if (elements == 0) lines_.fail_at(place_, "ELEMENT SHIFT is 0", "give the copies numbers of their own");
    for (const std::int64_t number : mesh_->elements_in_set(lines_, in_capitals(keyword_.of("OLD SET")))) {
        const NumberedMesh::Element master = *mesh_->find_element(number);
        add_copy(master, nodes, elements, keyword_.has("REFLECT"));
    }
}

/// *NCOPY: the nodes of a set, with greater numbers, moved and turned, or mirrored.
void AbaqusMaker::copy_nodes()
{
    const std::int64_t numbers = option("CHANGE NUMBER");
    const AffineMap map = copy_map();
    if (numbers == 0) lines_.fail_at(place_, "CHANGE NUMBER is 0", "give the copies numbers of their own");
    for (const std::int64_t number : mesh_->nodes_in_set(lines_, in_capitals(keyword_.of("OLD SET"))))
        add_node(number + numbers, map(place_of(number)));
}

AffineMap AbaqusMaker::copy_map() const
{
    if (keyword_.has("SHIFT")) return shift_map();
    std::vector<double> values;
    for (const auto& line : data_) values.insert(values.end(), line.begin(), line.end());
    const std::string kind = in_capitals(keyword_.of("REFLECT"));
    const std::size_t needed = kind == "POINT" ? 3 : kind == "LINE" ? 6 : kind == "MIRROR" ? 9 : 0;
    if (needed == 0) lines_.fail_at(place_, "*NCOPY has neither SHIFT nor REFLECT=POINT, LINE or MIRROR", write_out);
    if (values.size() < needed) lines_.fail_at(place_, fmt::format("{} coordinates are needed", needed), "complete the data lines");
    const Vector3d a = point_of(values, 0);
    if (kind == "POINT") return moved_by(a).after(stretched_by({-1, -1, -1})).after(moved_by(-a));
    const Vector3d along = point_of(values, 3) - a, normal = kind == "LINE" ? along : cross(along, point_of(values, 6) - a);
    if (!(norm(normal) > 0)) lines_.fail_at(place_, "the points of a reflection lie on each other or on a line", "give points that differ");
    return kind == "LINE" ? turned_about(a, along, std::numbers::pi) : mirrored_in(a, normal);
}

/// A first line of how far, a second of two points and the angle [degrees] about the line through them.
AffineMap AbaqusMaker::shift_map() const
{
    AffineMap map;
    for (std::vector<double> line : data_) {
        const bool turns = line.size() > 3;
        line.resize(7);
        if (!turns) map = moved_by(point_of(line, 0)).after(map);
        if (!turns || line[6] == 0) continue;
        const Vector3d a = point_of(line, 0), along = point_of(line, 3) - a;
        if (!(norm(along) > 0)) lines_.fail_at(place_, "the line nodes are turned about has no direction", "give two points that differ");
        map = turned_about(a, along, line[6] * std::numbers::pi / 180).after(map);
    }
    return map;
}

}  // namespace corpuscle
