#include "input/meshes/dyna_mesh.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "input/meshes/numbered_mesh.hpp"

namespace corpuscle {

namespace {

/// Shells and solids may have the same numbers: those of solids are kept apart by this.
constexpr std::int64_t solid_numbers = NumberedMesh::numbers / 2;

/// Fields of a card whose columns are `width` wide, or between commas.
std::vector<std::string_view> card_fields(std::string_view line, const std::vector<std::size_t>& widths)
{
    if (line.find(',') != std::string_view::npos) return comma_fields(line);
    std::vector<std::string_view> fields;
    for (const std::size_t width : widths) {
        fields.push_back(trimmed_field(line.substr(0, width)));
        line.remove_prefix(std::min(width, line.size()));
    }
    return fields;
}

class DynaReader {
public:
    explicit DynaReader(Scanner scanner) : lines_(std::move(scanner)) {}

    Mesh read()
    {
        while (next_line()) {
            if (lines_.text().starts_with('*')) {
                if (!begin()) break;
            } else if (data_ != nullptr) {
                (this->*data_)();
            }
        }
        name_parts();
        Mesh mesh = mesh_.mesh(lines_, [](std::int64_t number) { return number % solid_numbers; });
        if (!passed_.empty()) mesh.remarks.push_back(fmt::format("passed over: {}", fmt::join(passed_, ", ")));
        return mesh;
    }

private:
    using Data = void (DynaReader::*)();
    /// What a keyword does with its lines, and how its options change them.
    struct Meaning {
        Data data;
        void (DynaReader::*begin)(const std::string& options) = nullptr;
    };

    /// The next line that is no comment and not blank.
    bool next_line()
    {
        while (lines_.next())
            if (!lines_.text().starts_with('$') && !trimmed_field(lines_.text()).empty()) return true;
        return false;
    }

    /// Takes up a keyword; false at the deck's end.
    bool begin()
    {
        const std::string text = in_capitals(trimmed_field(lines_.text()));
        std::string word = text.substr(1, text.find_first_of(" ,\t") - 1);
        long_ = long_deck_;
        if (word.ends_with('+')) long_ = true;
        if (word.ends_with('-')) long_ = false;
        if (word.ends_with('%'))
            lines_.fail("fields of 10 columns for numbers (%) are not read", "write the deck in standard or long format");
        if (word.ends_with('+') || word.ends_with('-')) word.pop_back();
        data_ = nullptr;
        line_in_card_ = 0;
        if (word == "END") return false;
        if (word == "KEYWORD") return set_format(text);
        if (!take_up(word)) pass_over(word);
        return true;
    }

    bool set_format(const std::string& text)
    {
        long_deck_ = text.find("LONG=Y") != std::string::npos || text.find("LONG=K") != std::string::npos;
        if (text.find("I10=Y") != std::string::npos)
            lines_.fail("fields of 10 columns for numbers (I10=Y) are not read", "write the deck in standard or long format");
        return true;
    }

    /// Finds the longest keyword that `word` begins with; what follows are its options.
    bool take_up(const std::string& word)
    {
        static const std::map<std::string, Meaning> known{{"NODE", {&DynaReader::read_node}},
                                                          {"ELEMENT_SHELL", {&DynaReader::read_shell, &DynaReader::begin_shells}},
                                                          {"ELEMENT_SOLID", {&DynaReader::read_solid, &DynaReader::begin_solids}},
                                                          {"PART", {&DynaReader::read_part, &DynaReader::begin_parts}},
                                                          {"SET_NODE", {&DynaReader::read_set, &DynaReader::begin_node_set}},
                                                          {"SET_PART", {&DynaReader::read_set, &DynaReader::begin_part_set}},
                                                          {"SET_SHELL", {&DynaReader::read_set, &DynaReader::begin_shell_set}},
                                                          {"SET_SOLID", {&DynaReader::read_set, &DynaReader::begin_solid_set}},
                                                          {"SET_SEGMENT", {&DynaReader::read_set, &DynaReader::begin_segment_set}},
                                                          {"INCLUDE", {&DynaReader::read_include}}};
        for (std::size_t length = word.size(); length > 0; length = length == 0 ? 0 : word.rfind('_', length - 1)) {
            if (length == std::string::npos) return false;
            const auto found = known.find(word.substr(0, length));
            if (found == known.end()) continue;
            const std::string options = word.substr(length);
            if (found->second.begin == nullptr && !options.empty()) return false;
            data_ = found->second.data;
            if (found->second.begin != nullptr) (this->*found->second.begin)(options);
            return true;
        }
        return false;
    }

    void pass_over(const std::string& word)
    {
        if (word.starts_with("INCLUDE") || word.starts_with("NODE_TRANSFORM"))
            lines_.fail(fmt::format("*{} is not read: it moves or renumbers what it includes", word),
                        "use *INCLUDE, and move the part in the case");
        if (word.starts_with("ELEMENT") && !word.starts_with("ELEMENT_MASS") && !word.starts_with("ELEMENT_INERTIA"))
            lines_.fail(fmt::format("elements of kind *{} are not computed", word),
                        "give shells (3 or 4 nodes) or solids (hexahedra, tetrahedra)");
        passed_.insert("*" + word);
    }

    [[nodiscard]] std::vector<std::string_view> fields(std::size_t count, std::size_t width) const
    {
        return card_fields(lines_.text(), std::vector<std::size_t>(count, long_ ? 20 : width));
    }

    /// A number from 1 on; 0 where the field is blank or missing.
    [[nodiscard]] std::int64_t number(const std::vector<std::string_view>& fields, std::size_t index, const char* what) const
    {
        if (index >= fields.size()) return 0;
        const std::int64_t value = integer_field(lines_, fields[index], what);
        if (value < 0 || value >= solid_numbers) lines_.fail(fmt::format("{} where {} was expected", value, what), "numbers begin at 1");
        return value;
    }

    [[nodiscard]] std::int64_t needed(const std::vector<std::string_view>& fields, std::size_t index, const char* what) const
    {
        const std::int64_t value = number(fields, index, what);
        if (value == 0) lines_.fail(fmt::format("{} is missing", what), "correct the line, or export the mesh again");
        return value;
    }

    void read_node()
    {
        const std::vector<std::size_t> widths = long_ ? std::vector<std::size_t>(4, 20) : std::vector<std::size_t>{8, 16, 16, 16};
        const auto card = card_fields(lines_.text(), widths);
        Vector3d at;
        for (int a = 0; a < 3; ++a)
            if (a + 1u < card.size()) at[a] = real_field(lines_, card[a + 1], "a coordinate");
        mesh_.add_node({needed(card, 0, "the number of a node"), at, lines_.place()});
    }

    /// Further lines of each element that its options bring.
    void begin_shells(const std::string& options)
    {
        static const std::map<std::string, int> further{{"", 0},        {"_THICKNESS", 1},        {"_BETA", 1},       {"_MCID", 1},
                                                        {"_OFFSET", 1}, {"_THICKNESS_OFFSET", 2}, {"_BETA_OFFSET", 2}};
        find_further(further, "ELEMENT_SHELL" + options, options);
    }

    void begin_solids(const std::string& options)
    {
        static const std::map<std::string, int> further{{"", 0}, {"_ORTHO", 2}};
        find_further(further, "ELEMENT_SOLID" + options, options);
    }

    void find_further(const std::map<std::string, int>& further, const std::string& word, const std::string& options)
    {
        const auto found = further.find(options);
        if (found == further.end())
            lines_.fail(fmt::format("elements of kind *{} are not computed", word), "write the elements without these options");
        further_lines_ = found->second;
        if (found->second > 0) passed_.insert("lines of options of *" + word);
    }

    /// Passes over the lines that options add to an element.
    void skip_further()
    {
        for (int i = 0; i < further_lines_; ++i)
            if (!next_line() || lines_.text().starts_with('*'))
                lines_.fail("a line of an element's options is missing", "export the mesh again");
    }

    void read_shell()
    {
        const auto card = fields(10, 8);
        const std::int64_t own = needed(card, 0, "the number of an element"), part = needed(card, 1, "the number of a part");
        std::array<std::int64_t, 4> corners{};
        for (std::size_t i = 0; i < 4; ++i)
            corners[i] = i < 3 ? needed(card, i + 2, "a node of an element") : number(card, i + 2, "a node");
        for (std::size_t i = 6; i < card.size(); ++i)
            if (number(card, i, "a node of an element") != 0)
                lines_.fail(fmt::format("element {} has nodes between its corners: it is of second order, which is not computed", own),
                            "mesh with linear elements");
        add(surface_element(lines_, own, corners), part, "part", own);
    }

    /// Standard cards hold a solid on one line; those of ten nodes its numbers on a first line and its nodes on a second.
    void read_solid()
    {
        auto card = fields(10, 8);
        const std::int64_t own = needed(card, 0, "the number of an element"), part = needed(card, 1, "the number of a part");
        std::size_t first = 2;
        if (std::all_of(card.begin() + 2, card.end(), [](std::string_view field) { return field.empty(); })) {
            if (!next_line() || lines_.text().starts_with('*'))
                lines_.fail(fmt::format("the nodes of element {} are missing", own), "export the mesh again");
            card = fields(10, 8);
            first = 0;
        }
        std::array<std::int64_t, 8> corners{};
        for (std::size_t i = 0; i < 8; ++i) corners[i] = number(card, first + i, "a node of an element");
        for (std::size_t i = first + 8; i < card.size(); ++i)
            if (number(card, i, "a node of an element") != 0)
                lines_.fail(fmt::format("element {} has ten nodes: it is of second order, which is not computed", own),
                            "mesh with linear elements");
        NumberedMesh::Element element = solid_element(lines_, own, corners);
        element.number += solid_numbers;
        add(element, part, "part", own + solid_numbers);
    }

    void add(const NumberedMesh::Element& element, std::int64_t part, const char* prefix, std::int64_t key)
    {
        mesh_.add_element(element);
        const std::string name = fmt::format("{}_{}", prefix, part);
        mesh_.element_set(name, name).members.push_back({key, key, 1, "", false, element.place});
        parts_with_elements_.insert(part);
        skip_further();
    }

    void begin_parts(const std::string& options)
    {
        part_lines_ = options == "_CONTACT" ? 3 : 2;
        single_part_ = !options.empty() && options != "_CONTACT";
        if (single_part_) passed_.insert("options of *PART" + options);
    }

    /// A part: its title, then its number first on the next line.
    void read_part()
    {
        const int line = line_in_card_++ % part_lines_;
        if (single_part_ && line_in_card_ > 2) return;
        if (line == 0) title_ = trimmed_field(lines_.text());
        if (line == 1) titles_.emplace_back(title_, needed(fields(8, 10), 0, "the number of a part"));
    }

    /// Parts are found by their titles, too.
    void name_parts()
    {
        for (const auto& [title, part] : titles_) {
            if (title.empty() || !parts_with_elements_.contains(part)) continue;
            const std::string name = fmt::format("part_{}", part);
            if (title != name) mesh_.element_set(title, title).members.push_back({0, 0, 1, name, false, {}});
        }
    }

    enum class SetKind { nodes, parts, shells, solids, segments };

    void begin_node_set(const std::string& options) { begin_set(SetKind::nodes, "node_set", options); }
    void begin_part_set(const std::string& options) { begin_set(SetKind::parts, "part_set", options); }
    void begin_shell_set(const std::string& options) { begin_set(SetKind::shells, "shell_set", options); }
    void begin_solid_set(const std::string& options) { begin_set(SetKind::solids, "solid_set", options); }
    void begin_segment_set(const std::string& options) { begin_set(SetKind::segments, "segment_set", options); }

    void begin_set(SetKind kind, const char* prefix, std::string options)
    {
        set_kind_ = kind;
        set_prefix_ = prefix;
        set_ = nullptr;
        titled_ = options.ends_with("_TITLE");
        if (titled_) options.resize(options.size() - 6);
        title_.clear();
        generated_ = options == "_GENERATE" || options == "_LIST_GENERATE";
        general_ = options == "_GENERAL";
        if (options.empty() || options == "_LIST" || generated_ || (general_ && (kind == SetKind::nodes || kind == SetKind::shells)))
            return;
        data_ = nullptr;
        passed_.insert(fmt::format("*SET with {}", options.substr(1)));
    }

    /// A set's title, its number, then its members.
    void read_set()
    {
        const int line = line_in_card_++;
        if (titled_ && line == 0) {
            title_ = trimmed_field(lines_.text());
            return;
        }
        if (set_ == nullptr) {
            const std::string name =
                title_.empty() ? fmt::format("{}_{}", set_prefix_, needed(fields(8, 10), 0, "the number of a set")) : title_;
            const bool of_nodes = set_kind_ == SetKind::nodes || set_kind_ == SetKind::segments;
            set_ = of_nodes ? &mesh_.node_set(name, name) : &mesh_.element_set(name, name);
            return;
        }
        if (general_) return read_general();
        const auto card = fields(8, 10);
        const std::size_t count = set_kind_ == SetKind::segments ? std::min<std::size_t>(card.size(), 4) : card.size();
        for (std::size_t i = 0; i < count; i += generated_ ? 2 : 1) {
            const std::int64_t first = number(card, i, "a member of a set");
            const std::int64_t last = generated_ ? number(card, i + 1, "the last of a range") : first;
            if (first != 0) add_members(set_kind_, first, last);
        }
    }

    /// What a line of a general set adds: its first field says what the numbers are.
    void read_general()
    {
        const auto card = fields(8, 10);
        const std::string what = in_capitals(card[0]);
        if (what == "ALL") return add_members(set_kind_, 1, solid_numbers - 1);
        static const std::map<std::string, SetKind> kinds{{"NODE", SetKind::nodes}, {"ELEM", SetKind::shells}, {"PART", SetKind::parts}};
        const auto found = kinds.find(what);
        if (found == kinds.end() || (found->second != SetKind::parts && found->second != set_kind_))
            lines_.fail(fmt::format("'{}' in a general set is not read", what), "give ALL, NODE, ELEM or PART, or list the members");
        for (std::size_t i = 1; i < card.size(); ++i)
            if (const std::int64_t member = number(card, i, "a member of a set"); member != 0) add_members(found->second, member, member);
    }

    void add_members(SetKind kind, std::int64_t first, std::int64_t last)
    {
        const std::int64_t shift = kind == SetKind::solids ? solid_numbers : 0;
        if (kind != SetKind::parts) {
            set_->members.push_back({first + shift, last + shift, 1, "", false, lines_.place()});
            return;
        }
        const bool of_nodes = set_kind_ == SetKind::nodes;
        constexpr std::int64_t most_parts = 1'000'000;
        if (last - first > most_parts) lines_.fail("the range of parts is too long", "list the parts");
        for (std::int64_t part = first; part <= last; ++part)
            if (first == last || parts_with_elements_.contains(part))
                set_->members.push_back({0, 0, 1, fmt::format("part_{}", part), of_nodes, lines_.place()});
    }

    void read_include() { lines_.include(std::string(trimmed_field(lines_.text()))); }

    DeckLines lines_;
    NumberedMesh mesh_;
    bool long_deck_ = false, long_ = false;  ///< fields are 20 columns wide: of the deck, of the present keyword
    Data data_ = nullptr;                    ///< what reads the lines of the present keyword
    int line_in_card_ = 0;
    int further_lines_ = 0;  ///< of each element
    int part_lines_ = 2;
    bool single_part_ = false;
    std::string title_;
    std::vector<std::pair<std::string, std::int64_t>> titles_;  ///< of parts
    std::set<std::int64_t> parts_with_elements_;
    SetKind set_kind_ = SetKind::nodes;
    std::string set_prefix_;
    NumberedMesh::Set* set_ = nullptr;
    bool titled_ = false, generated_ = false, general_ = false;
    std::set<std::string> passed_;
};

}  // namespace

Mesh read_dyna_mesh(Scanner scanner)
{
    return DynaReader(std::move(scanner)).read();
}

}  // namespace corpuscle
