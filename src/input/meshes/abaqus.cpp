#include "input/meshes/abaqus.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "input/meshes/abaqus_makers.hpp"
#include "input/meshes/abaqus_words.hpp"
#include "input/meshes/affine_map.hpp"
#include "input/meshes/numbered_mesh.hpp"

namespace corpuscle {

namespace {

/// Coordinates of a node as *NODE, SYSTEM= says: rectangular (R), or radius, angle [degrees] and height (C).
Vector3d rectangular(const Vector3d& at, bool cylindrical)
{
    const double angle = at.y * std::numbers::pi / 180;
    return cylindrical ? Vector3d{at.x * std::cos(angle), at.x * std::sin(angle), at.z} : at;
}

/// What a side of a surface is: a face of solids from 1 on (S1, ...), 0 for a side of shells (SPOS, SNEG), the free faces if it is not
/// said, none for what is no side.
std::optional<int> face_of(const std::string& side)
{
    if (side.empty()) return SetMember::free_faces;
    if (side == "SPOS" || side == "SNEG") return 0;
    if (side.size() == 2 && side[0] == 'S' && side[1] >= '1' && side[1] <= '6') return side[1] - '0';
    return std::nullopt;
}

class AbaqusReader {
public:
    explicit AbaqusReader(Scanner scanner) : lines_(std::move(scanner)) {}

    Mesh read()
    {
        while (next_abaqus_line(lines_)) {
            if (trimmed_field(lines_.text()).starts_with('*'))
                begin(abaqus_keyword(lines_));
            else if (data_ != nullptr)
                (this->*data_)();
        }
        maker_.finish();
        if (in_part_ || in_instance_)
            lines_.fail("the file ends within a part or an instance", "the file may be cut short: export it again");
        Mesh mesh = root_.mesh(lines_, [](std::int64_t number) { return number % NumberedMesh::numbers; });
        add_remarks(mesh);
        return mesh;
    }

private:
    using Data = void (AbaqusReader::*)();

    /// The mesh that what is read belongs to: that of a part or an instance, or the file's.
    NumberedMesh& current() { return in_part_ ? parts_[part_] : in_instance_ ? own_ : root_; }

    void begin(const AbaqusKeyword& keyword)
    {
        static const std::map<std::string, void (AbaqusReader::*)(const AbaqusKeyword&)> known{
            {"NODE", &AbaqusReader::begin_nodes},
            {"ELEMENT", &AbaqusReader::begin_elements},
            {"NSET", &AbaqusReader::begin_set},
            {"ELSET", &AbaqusReader::begin_set},
            {"PART", &AbaqusReader::begin_part},
            {"END PART", &AbaqusReader::end_part},
            {"INSTANCE", &AbaqusReader::begin_instance},
            {"END INSTANCE", &AbaqusReader::end_instance},
            {"SYSTEM", &AbaqusReader::begin_system},
            {"SURFACE", &AbaqusReader::begin_surface},
            {"SHELL SECTION", &AbaqusReader::begin_section}};
        if (keyword.name == "INCLUDE") return include(keyword);  // what is read goes on in the other file
        maker_.finish();
        data_ = nullptr;
        if (AbaqusMaker::knows(keyword.name)) {
            maker_.begin(keyword, current());
            data_ = &AbaqusReader::read_made;
            return;
        }
        const auto found = known.find(keyword.name);
        if (found != known.end()) return (this->*found->second)(keyword);
        if (const char* why = abaqus_refusal(keyword.name))
            lines_.fail(fmt::format("*{} is not read: {}", keyword.name, why), "write the mesh out with all its nodes and elements");
        if (keyword.name != "HEADING" && keyword.name != "ASSEMBLY" && keyword.name != "END ASSEMBLY") passed_.insert("*" + keyword.name);
    }

    std::int64_t number(std::string_view field, const char* what)
    {
        const std::int64_t value = integer_field(lines_, field, what);
        if (value < 1 || value >= NumberedMesh::numbers)
            lines_.fail(fmt::format("{} where {} was expected", value, what), "numbers begin at 1");
        return value;
    }

    void begin_nodes(const AbaqusKeyword& keyword)
    {
        const std::string system = in_capitals(keyword.of("SYSTEM"));
        if (!system.empty() && system != "R" && system != "C")
            lines_.fail(fmt::format("nodes in a system '{}' are not read", system),
                        "write the nodes in rectangular or cylindrical coordinates");
        cylindrical_ = system == "C";
        set_ = keyword.has("NSET") ? &current().node_set(in_capitals(keyword.of("NSET")), keyword.of("NSET")) : nullptr;
        data_ = &AbaqusReader::read_node;
        read_input(keyword);
    }

    /// Goes on in the file that has the data lines, if one is named.
    void read_input(const AbaqusKeyword& keyword)
    {
        if (!keyword.of("INPUT").empty()) lines_.include(keyword.of("INPUT"));
    }

    void read_node()
    {
        const auto fields = comma_fields(lines_.text());
        const std::int64_t node = number(fields[0], "the number of a node");
        Vector3d at;
        for (std::size_t i = 1; i < std::min<std::size_t>(fields.size(), 4); ++i)
            at[static_cast<int>(i) - 1] = real_field(lines_, fields[i], "a coordinate");
        current().add_node({node, system_(rectangular(at, cylindrical_)), lines_.place()});
        if (set_ != nullptr) set_->members.push_back({node, node, 1, "", false, lines_.place()});
    }

    void begin_elements(const AbaqusKeyword& keyword)
    {
        kind_ = abaqus_element(lines_, keyword.of("TYPE"));
        type_ = in_capitals(keyword.of("TYPE"));
        set_ = keyword.has("ELSET") ? &current().element_set(in_capitals(keyword.of("ELSET")), keyword.of("ELSET")) : nullptr;
        data_ = kind_.shape ? &AbaqusReader::read_element : &AbaqusReader::read_line_or_point;
        read_input(keyword);
    }

    /// What has no shape: its nodes, as many as there are, stay in the sets.
    void read_line_or_point()
    {
        NumberedMesh::Element element;
        element.place = lines_.place();
        bool first = true;
        for (bool more = true; more;) {
            for (const std::string_view field : comma_fields(lines_.text())) {
                if (first) element.number = number(field, "the number of an element");
                if (!first && !field.empty() && element.corners < 8)
                    element.node[element.corners++] = number(field, "the number of a node");
                first = false;
            }
            more = trimmed_field(lines_.text()).ends_with(',') && next_abaqus_line(lines_);
        }
        current().add_element(element);
        if (set_ != nullptr) set_->members.push_back({element.number, element.number, 1, "", false, element.place, 0});
        ++left_out_[type_];
    }

    void read_made() { maker_.read(); }

    /// *SYSTEM: origin and a point on the x axis on a first line, one in the plane of x and y on a second; of the nodes that follow.
    void begin_system(const AbaqusKeyword&)
    {
        system_ = {};
        system_points_.clear();
        data_ = &AbaqusReader::read_system;
    }

    void read_system()
    {
        for (const std::string_view field : comma_fields(lines_.text()))
            system_points_.push_back(real_field(lines_, field, "a coordinate"));
        std::vector<double> v = system_points_;
        v.resize(9);
        const Vector3d origin{v[0], v[1], v[2]}, x = Vector3d{v[3], v[4], v[5]} - origin;
        system_ = moved_by(origin);
        if (system_points_.size() <= 3) return;
        const Vector3d in_plane = system_points_.size() > 6 ? Vector3d{v[6], v[7], v[8]} - origin : cross({0, 0, 1}, x);
        const Vector3d z = cross(x, in_plane);
        if (!(norm(z) > 0))
            lines_.fail("the points of the system lie on each other or on a line", "give an origin and two points that differ");
        system_ = {normalized(x), cross(normalized(z), normalized(x)), normalized(z), origin};
    }

    /// *SHELL SECTION: a set of elements, and their thickness first on the next line. The case says those that count: these are only told.
    void begin_section(const AbaqusKeyword& keyword)
    {
        section_ = keyword.of("ELSET");
        if (keyword.has("COMPOSITE") || section_.empty())
            passed_.insert("*SHELL SECTION, COMPOSITE");
        else
            data_ = &AbaqusReader::read_section;
    }

    void read_section()
    {
        data_ = nullptr;
        const double thickness = real_field(lines_, comma_fields(lines_.text())[0], "a thickness");
        if (thickness > 0) thicknesses_[section_] = thickness;
    }

    /// *SURFACE: sides of elements, or nodes; kept as a set of nodes.
    void begin_surface(const AbaqusKeyword& keyword)
    {
        const std::string& name = keyword.of("NAME");
        const std::string type = keyword.has("TYPE") ? in_capitals(keyword.of("TYPE")) : "ELEMENT";
        if (name.empty() || (type != "ELEMENT" && type != "NODE") || keyword.has("COMBINE")) {
            passed_.insert("*SURFACE of other types");
            return;
        }
        set_ = &current().surface(in_capitals(name), name);
        set_instance_.clear();
        data_ = type == "NODE" ? &AbaqusReader::read_node_surface : &AbaqusReader::read_side;
    }

    void read_node_surface()
    {
        if (const auto fields = comma_fields(lines_.text()); !fields[0].empty()) set_->members.push_back(member_of(fields[0]));
    }

    /// A set of elements, or an element, and its side. One of all free faces (no side of solids) is not known before the end: it is not
    /// kept.
    void read_side()
    {
        const auto fields = comma_fields(lines_.text());
        const auto face = face_of(fields.size() > 1 ? in_capitals(fields[1]) : "");
        if (!face || fields[0].empty()) {
            passed_.insert("sides of *SURFACE other than SPOS, SNEG, S1 to S6");
            return;
        }
        SetMember member = member_of(fields[0]);
        member.elements = true;
        member.face = *face;
        set_->members.push_back(member);
    }

    /// An element's numbers: its own and its nodes'; a line that ends in a comma goes on in the next.
    void read_element()
    {
        const DeckPlace place = lines_.place();
        std::vector<std::int64_t> numbers;
        bool more = true;
        while (more && numbers.size() < static_cast<std::size_t>(kind_.corners) + 1) {
            for (const std::string_view field : comma_fields(lines_.text())) numbers.push_back(number(field, "the number of a node"));
            more = numbers.size() < static_cast<std::size_t>(kind_.corners) + 1 && trimmed_field(lines_.text()).ends_with(',') &&
                   next_abaqus_line(lines_);
        }
        if (numbers.size() != static_cast<std::size_t>(kind_.corners) + 1)
            lines_.fail_at(place, fmt::format("an element of this type has {} nodes, {} are given", kind_.corners, numbers.size() - 1),
                           "correct the line, or export the mesh again");
        NumberedMesh::Element element = shaped(numbers);
        element.place = place;
        current().add_element(element);
        if (set_ != nullptr) set_->members.push_back({numbers[0], numbers[0], 1, "", false, place});
    }

    [[nodiscard]] NumberedMesh::Element shaped(const std::vector<std::int64_t>& numbers) const
    {
        std::array<std::int64_t, 8> corners{};
        std::copy(numbers.begin() + 1, numbers.end(), corners.begin());
        if (kind_.corners == 4 && kind_.shape == ElementShape::quadrilateral)
            return surface_element(lines_, numbers[0], {corners[0], corners[1], corners[2], corners[3]});
        if (kind_.corners == 8) return solid_element(lines_, numbers[0], corners);
        return {numbers[0], kind_.shape, kind_.corners, corners, {}};
    }

    /// Begins *NSET or *ELSET; one of an assembly may belong to an instance.
    void begin_set(const AbaqusKeyword& keyword)
    {
        of_nodes_ = keyword.name == "NSET";
        const std::string& name = keyword.of(keyword.name);
        if (name.empty()) lines_.fail("the set has no name", fmt::format("write *{0}, {0}=NAME", keyword.name));
        set_ = of_nodes_ ? &current().node_set(in_capitals(name), name) : &current().element_set(in_capitals(name), name);
        set_->as_listed = keyword.has("UNSORTED");
        set_instance_ = in_capitals(keyword.of("INSTANCE"));
        if (!set_instance_.empty() && !instances_.contains(set_instance_))
            lines_.fail(fmt::format("there is no instance '{}'", keyword.of("INSTANCE")), "name an instance that stands before");
        if (of_nodes_ && keyword.has("ELSET")) set_->members.push_back({0, 0, 1, in_capitals(keyword.of("ELSET")), true, lines_.place()});
        data_ = keyword.has("GENERATE") ? &AbaqusReader::read_range : &AbaqusReader::read_members;
    }

    [[nodiscard]] std::int64_t shift_of(const std::string& instance) const
    {
        return instance.empty() ? 0 : instances_.at(instance) * NumberedMesh::numbers;
    }

    void read_range()
    {
        const auto fields = comma_fields(lines_.text());
        const std::int64_t first = number(fields[0], "the first of a range");
        const std::int64_t last = fields.size() > 1 ? number(fields[1], "the last of a range") : first;
        const std::int64_t step = fields.size() > 2 ? number(fields[2], "the step of a range") : 1;
        const std::int64_t shift = shift_of(set_instance_);
        set_->members.push_back({first + shift, last + shift, step, "", false, lines_.place()});
    }

    void read_members()
    {
        for (const std::string_view field : comma_fields(lines_.text()))
            if (!field.empty()) set_->members.push_back(member_of(field));
    }

    /// What a field means: a number, or the name of a set; in an assembly "instance.number" and "instance.set", too.
    SetMember member_of(std::string_view field)
    {
        const std::string key = in_capitals(unquoted_name(field));
        const std::size_t dot = key.rfind('.');
        const std::string before = dot == std::string::npos ? "" : key.substr(0, dot);
        const bool of_instance = instances_.contains(before);
        const std::string own = of_instance ? key.substr(dot + 1) : key;
        const bool is_number = !own.empty() && own.find_first_not_of("0123456789") == std::string::npos;
        SetMember member{0, 0, 1, "", false, lines_.place(), 0};
        if (is_number)
            member.first = member.last = number(own, "the number of a member") + shift_of(of_instance ? before : set_instance_);
        else
            member.set = set_instance_.empty() ? key : set_instance_ + "." + key;
        return member;
    }

    void begin_part(const AbaqusKeyword& keyword)
    {
        part_ = in_capitals(keyword.of("NAME"));
        if (part_.empty() || parts_.contains(part_))
            lines_.fail(fmt::format("the part's name '{}' is {}", keyword.of("NAME"), part_.empty() ? "missing" : "given twice"),
                        "give each part a name of its own: *PART, NAME=...");
        in_part_ = true;
        parts_[part_];
    }

    void end_part(const AbaqusKeyword&) { in_part_ = false; }

    void begin_instance(const AbaqusKeyword& keyword)
    {
        instance_ = keyword.of("NAME");
        const std::string part = in_capitals(keyword.of("PART"));
        if (instance_.empty() || instances_.contains(in_capitals(instance_)))
            lines_.fail(fmt::format("the instance's name '{}' is {}", instance_, instance_.empty() ? "missing" : "given twice"),
                        "give each instance a name of its own: *INSTANCE, NAME=..., PART=...");
        if (!part.empty() && !parts_.contains(part))
            lines_.fail(fmt::format("instance '{}' is of part '{}', which is not there", instance_, keyword.of("PART")),
                        "define the part before its instances");
        own_ = part.empty() ? NumberedMesh{} : parts_.at(part);
        in_instance_ = true;
        placed_ = {};
        data_ = &AbaqusReader::read_placing;
    }

    /// A line of how far the instance is moved; one of two points of the line it is turned about, and the angle in degrees.
    void read_placing()
    {
        const auto fields = comma_fields(lines_.text());
        std::array<double, 7> v{};
        for (std::size_t i = 0; i < std::min(fields.size(), v.size()); ++i) v[i] = real_field(lines_, fields[i], "where an instance is");
        if (fields.size() <= 3) {
            placed_ = moved_by({v[0], v[1], v[2]}).after(placed_);
            return;
        }
        const Vector3d from{v[0], v[1], v[2]}, axis = Vector3d{v[3], v[4], v[5]} - from;
        if (v[6] == 0) return;
        if (!(norm(axis) > 0))
            lines_.fail("the line an instance is turned about has no direction", "give two points that differ, and the angle in degrees");
        placed_ = turned_about(from, axis, v[6] * std::numbers::pi / 180).after(placed_);
    }

    void end_instance(const AbaqusKeyword&)
    {
        if (!in_instance_) lines_.fail("*END INSTANCE without *INSTANCE", "the file may be damaged: export it again");
        in_instance_ = false;
        const auto index = static_cast<std::int64_t>(instances_.size()) + 1;
        if (index >= std::numeric_limits<std::int64_t>::max() / NumberedMesh::numbers)
            lines_.fail("too many instances", "join some of them");
        instances_[in_capitals(instance_)] = index;
        root_.add(own_, index * NumberedMesh::numbers, instance_, placed_);
    }

    void include(const AbaqusKeyword& keyword)
    {
        if (keyword.of("INPUT").empty()) lines_.fail("*INCLUDE names no file", "write *INCLUDE, INPUT=FILE");
        lines_.include(keyword.of("INPUT"));
    }

    void add_remarks(Mesh& mesh) const
    {
        for (const auto& [type, count] : left_out_)
            mesh.remarks.push_back(fmt::format("{} elements of type {} are not computed, only the sets of their nodes are kept{}", count,
                                               type, type == "MASS" ? ": give their mass with point_masses" : ""));
        std::vector<std::string> told;
        for (const auto& [set, thickness] : thicknesses_) told.push_back(fmt::format("{} {:.6g}", set, thickness));
        if (!told.empty())
            mesh.remarks.push_back(
                fmt::format("thicknesses in the file, in its unit, which do not count (the case says them): {}", fmt::join(told, ", ")));
        if (!passed_.empty()) mesh.remarks.push_back(fmt::format("passed over: {}", fmt::join(passed_, ", ")));
    }

    DeckLines lines_;
    NumberedMesh root_;
    std::map<std::string, NumberedMesh> parts_;
    std::map<std::string, std::int64_t> instances_;  ///< by name, from 1
    std::string part_, instance_;                    ///< that is read
    bool in_part_ = false, in_instance_ = false;
    NumberedMesh own_;  ///< of the instance that is read
    AffineMap placed_;
    AbaqusMaker maker_{lines_};
    AffineMap system_;                   ///< of nodes, as *SYSTEM says
    std::vector<double> system_points_;  ///< that say it
    bool cylindrical_ = false;
    Data data_ = nullptr;  ///< what reads the lines of the present keyword
    NumberedMesh::Set* set_ = nullptr;
    bool of_nodes_ = true;
    std::string set_instance_;
    AbaqusElement kind_;
    std::string type_;
    std::string section_;
    std::map<std::string, double> thicknesses_;  ///< of sets of elements, in the file's unit
    std::map<std::string, int> left_out_;        ///< types of elements that are not kept
    std::set<std::string> passed_;               ///< keywords that were not read
};

}  // namespace

Mesh read_abaqus(Scanner scanner)
{
    return AbaqusReader(std::move(scanner)).read();
}

}  // namespace corpuscle
