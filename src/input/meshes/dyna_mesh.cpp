#include "input/meshes/dyna_mesh.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "input/meshes/dyna_cards.hpp"
#include "input/meshes/dyna_sets.hpp"
#include "input/meshes/dyna_thicknesses.hpp"
#include "input/meshes/dyna_transformations.hpp"
#include "input/meshes/numbered_mesh.hpp"

namespace corpuscle {

namespace {

std::string part_name(std::int64_t part)
{
    return fmt::format("part_{}", part);
}

bool is_whole_number(std::string_view field)
{
    return !field.empty() && field.find_first_not_of("0123456789") == std::string_view::npos;
}

class DynaReader {
public:
    explicit DynaReader(Scanner scanner) : cards_(std::move(scanner)), sets_(cards_, mesh_), transformations_(cards_), thicknesses_(cards_)
    {
    }

    Mesh read()
    {
        while (cards_.next()) {
            if (cards_.text().starts_with('*'))
                begin();
            else if (data_ != nullptr)
                (this->*data_)();
        }
        name_parts();
        const std::set<std::int64_t> missing = sets_.add_parts(parts_with_elements_);
        Mesh mesh = mesh_.mesh(cards_.lines(), [](std::int64_t number) { return number % dyna_solid_numbers; });
        move_nodes(mesh);
        add_remarks(mesh, missing);
        return mesh;
    }

private:
    using Data = void (DynaReader::*)();
    /// What a keyword does with its lines, and how its options change them.
    struct Meaning {
        Data data;
        void (DynaReader::*begin)(const std::string& options) = nullptr;
    };

    /// Takes up a keyword. What stands behind its name tells how its lines are written: + long, - standard, % ten columns for numbers.
    void begin()
    {
        const std::string text = in_capitals(trimmed_field(cards_.text()));
        const std::size_t end = std::min(text.find_first_of(" ,\t"), text.size());
        std::string word = text.substr(1, end - 1);
        const std::string_view rest = trimmed_field(std::string_view(text).substr(end));
        const char mark = rest.size() == 1 ? rest[0] : word.empty() ? ' ' : word.back();
        const bool marked = mark == '+' || mark == '-' || mark == '%';
        cards_.set_format(mark == '+'   ? DynaFormat::long_fields
                          : mark == '-' ? DynaFormat::standard
                          : mark == '%' ? DynaFormat::ten_columns
                                        : cards_.file().format);
        if (marked && rest.size() != 1) word.pop_back();
        data_ = nullptr;
        line_in_card_ = 0;
        cards_.blanks_count = false;
        if (word == "END") return cards_.leave();
        if (word == "KEYWORD") return set_format(text);
        if (!take_up(word)) pass_over(word);
    }

    /// The format of the deck, as *KEYWORD says.
    void set_format(const std::string& text)
    {
        const bool is_long = text.find("LONG=Y") != std::string::npos || text.find("LONG=K") != std::string::npos;
        const bool ten = text.find("I10=Y") != std::string::npos;
        if (is_long || ten || text.find("LONG=S") != std::string::npos || text.find("LONG=N") != std::string::npos)
            cards_.file().format = is_long ? DynaFormat::long_fields : ten ? DynaFormat::ten_columns : DynaFormat::standard;
    }

    /// Finds the longest keyword that `word` begins with; what follows are its options.
    bool take_up(const std::string& word)
    {
        static const std::map<std::string, Meaning> known{
            {"NODE", {&DynaReader::read_node}},
            {"NODE_TRANSFORM", {&DynaReader::read_node_transform}},
            {"ELEMENT_SHELL", {&DynaReader::read_shell, &DynaReader::begin_shells}},
            {"ELEMENT_SOLID", {&DynaReader::read_solid, &DynaReader::begin_solids}},
            {"ELEMENT_BEAM", {&DynaReader::read_line, &DynaReader::begin_lines}},
            {"ELEMENT_DISCRETE", {&DynaReader::read_line, &DynaReader::begin_lines}},
            {"ELEMENT_SEATBELT", {&DynaReader::read_line, &DynaReader::begin_lines}},
            {"ELEMENT_MASS", {&DynaReader::read_mass}},
            {"PART", {&DynaReader::read_part, &DynaReader::begin_parts}},
            {"SET_NODE", {&DynaReader::read_set, &DynaReader::begin_set<DynaSetKind::nodes>}},
            {"SET_PART", {&DynaReader::read_set, &DynaReader::begin_set<DynaSetKind::parts>}},
            {"SET_SHELL", {&DynaReader::read_set, &DynaReader::begin_set<DynaSetKind::shells>}},
            {"SET_SOLID", {&DynaReader::read_set, &DynaReader::begin_set<DynaSetKind::solids>}},
            {"SET_SEGMENT", {&DynaReader::read_set, &DynaReader::begin_set<DynaSetKind::segments>}},
            {"PARAMETER", {&DynaReader::read_parameters, &DynaReader::begin_parameters}},
            {"DEFINE_TRANSFORMATION", {&DynaReader::read_transformation, &DynaReader::begin_transformation}},
            {"SECTION_SHELL", {&DynaReader::read_section, &DynaReader::begin_section}},
            {"INCLUDE", {&DynaReader::read_include}},
            {"INCLUDE_PATH", {&DynaReader::read_path}},
            {"INCLUDE_PATH_RELATIVE", {&DynaReader::read_path}},
            {"INCLUDE_TRANSFORM", {&DynaReader::read_transformed}}};
        for (std::size_t length = word.size(); length > 0; length = length == 0 ? 0 : word.rfind('_', length - 1)) {
            if (length == std::string::npos) return false;
            const auto found = known.find(word.substr(0, length));
            if (found == known.end()) continue;
            const std::string options = word.substr(length);
            if (found->second.begin == nullptr && !options.empty()) return false;
            data_ = found->second.data;
            word_ = word;
            if (found->second.begin != nullptr) (this->*found->second.begin)(options);
            return true;
        }
        return false;
    }

    void pass_over(const std::string& word)
    {
        static const std::set<std::string> structural{"ELEMENT_TSHELL", "ELEMENT_SPH", "ELEMENT_GENERALIZED_SHELL",
                                                      "ELEMENT_GENERALIZED_SOLID"};
        if (word.starts_with("INCLUDE")) cards_.lines().fail(fmt::format("*{} is not read", word), "use *INCLUDE or *INCLUDE_TRANSFORM");
        if (word.starts_with("NODE_MERGE"))
            cards_.lines().fail(fmt::format("*{} is not read: it makes nodes one", word), "write the mesh out with the nodes merged");
        if (structural.contains(word))
            cards_.lines().fail(fmt::format("elements of kind *{} are not computed", word),
                                "give shells (3 or 4 nodes) or solids (hexahedra, tetrahedra)");
        passed_.insert("*" + word);
    }

    // Nodes and elements

    void read_node()
    {
        const auto& card = cards_.node_fields();
        Vector3d at;
        for (int a = 0; a < 3; ++a)
            if (a + 1u < card.size()) at[a] = real_field(cards_.lines(), card[a + 1], "a coordinate");
        const std::int64_t own = dyna_needed(cards_, card, 0, "the number of a node");
        const DynaFile& file = cards_.file();
        mesh_.add_node({dyna_shifted(cards_, own, file.node), file.placed(at), cards_.lines().place()});
    }

    /// A node of an element, 0 if there is none.
    [[nodiscard]] std::int64_t node(const std::vector<std::string_view>& card, std::size_t index) const
    {
        const std::int64_t own = dyna_number(cards_, card, index, "a node of an element");
        return own == 0 ? 0 : dyna_shifted(cards_, own, cards_.file().node);
    }

    /// Further lines of each element that its options bring.
    void begin_shells(const std::string& options)
    {
        static const std::map<std::string, int> further{{"", 0},        {"_THICKNESS", 1},        {"_BETA", 1},       {"_MCID", 1},
                                                        {"_OFFSET", 1}, {"_THICKNESS_OFFSET", 2}, {"_BETA_OFFSET", 2}};
        find_further(further, options);
    }

    void begin_solids(const std::string& options)
    {
        static const std::map<std::string, int> further{{"", 0}, {"_ORTHO", 2}};
        find_further(further, options);
    }

    void find_further(const std::map<std::string, int>& further, const std::string& options)
    {
        const auto found = further.find(options);
        if (found == further.end())
            cards_.lines().fail(fmt::format("elements of kind *{} are not computed", word_), "write the elements without these options");
        further_lines_ = found->second;
        if (found->second > 0) passed_.insert("lines of options of *" + word_);
    }

    /// The number of the element or part that stands in the first or second field of a card.
    [[nodiscard]] std::int64_t element_number(const std::vector<std::string_view>& card) const
    {
        return dyna_shifted(cards_, dyna_needed(cards_, card, 0, "the number of an element"), cards_.file().element);
    }
    [[nodiscard]] std::int64_t part_number(const std::vector<std::string_view>& card, std::size_t index) const
    {
        return dyna_shifted(cards_, dyna_needed(cards_, card, index, "the number of a part"), cards_.file().part);
    }

    void read_shell()
    {
        const auto& card = cards_.fields(10, 8);
        const std::int64_t own = element_number(card), part = part_number(card, 1);
        std::array<std::int64_t, 4> corners{};
        for (std::size_t i = 0; i < 4; ++i) {
            if (i < 3) (void)dyna_needed(cards_, card, i + 2, "a node of an element");
            corners[i] = node(card, i + 2);
        }
        for (std::size_t i = 6; i < card.size(); ++i)
            if (node(card, i) != 0)
                cards_.lines().fail(
                    fmt::format("element {} has nodes between its corners: it is of second order, which is not computed", own),
                    "mesh with linear elements");
        add(surface_element(cards_.lines(), own, corners), part, own);
    }

    /// Standard cards hold a solid on one line; those of ten nodes its numbers on a first line and its nodes on a second.
    void read_solid()
    {
        const std::vector<std::string_view>* card = &cards_.fields(10, 8);
        const std::int64_t own = element_number(*card), part = part_number(*card, 1);
        std::size_t first = 2;
        if (std::all_of(card->begin() + 2, card->end(), [](std::string_view field) { return field.empty(); })) {
            cards_.next_of_keyword("the line of an element's nodes");
            card = &cards_.fields(10, 8);
            first = 0;
        }
        std::array<std::int64_t, 8> corners{};
        for (std::size_t i = 0; i < 8; ++i) corners[i] = node(*card, first + i);
        for (std::size_t i = first + 8; i < card->size(); ++i)
            if (node(*card, i) != 0)
                cards_.lines().fail(fmt::format("element {} has ten nodes: it is of second order, which is not computed", own),
                                    "mesh with linear elements");
        NumberedMesh::Element element = solid_element(cards_.lines(), own, corners);
        if (cards_.file().placed.determinant() < 0) mirror(element);
        element.number += dyna_solid_numbers;
        add(element, part, own + dyna_solid_numbers);
    }

    /// Adds an element to the mesh and to its part, and passes over the lines that options add to it.
    void add(const NumberedMesh::Element& element, std::int64_t part, std::int64_t key)
    {
        mesh_.add_element(element);
        part_set(part).members.push_back({key, key, 1, "", false, element.place});
        for (int i = 0; i < further_lines_; ++i) cards_.next_of_keyword("a line of an element's options");
    }

    /// The set of a part's elements; that of the element before, mostly.
    NumberedMesh::Set& part_set(std::int64_t part)
    {
        if (part_set_ == nullptr || part != last_part_) {
            part_set_ = &mesh_.element_set(part_name(part), part_name(part));
            parts_with_elements_.insert(part);
            last_part_ = part;
        }
        return *part_set_;
    }

    /// Beams, springs and belts: counted, and, where no options add lines, their parts kept as sets of nodes.
    void begin_lines(const std::string& options)
    {
        if (options.empty()) return;
        data_ = nullptr;
        passed_.insert("*" + word_);
    }

    void read_line()
    {
        const auto& card = cards_.fields(4, 8);
        const std::int64_t part = part_number(card, 1);
        const std::string name = part_name(part);
        NumberedMesh::Set& nodes = mesh_.node_set(name, name);
        for (std::size_t i = 2; i < 4; ++i)
            if (const std::int64_t end = node(card, i); end != 0) nodes.members.push_back({end, end, 1, "", false, cards_.lines().place()});
        ++left_out_[word_];
    }

    void read_mass()
    {
        const auto& card = cards_.fields(2, 8);
        (void)dyna_needed(cards_, card, 1, "the node of a mass");
        const std::int64_t at = node(card, 1);
        mesh_.node_set("element_mass", "element_mass").members.push_back({at, at, 1, "", false, cards_.lines().place()});
        ++masses_;
    }

    // Parts and sets

    void begin_parts(const std::string& options)
    {
        part_lines_ = options == "_CONTACT" ? 3 : 2;
        single_part_ = !options.empty() && options != "_CONTACT";
        cards_.blanks_count = true;
        if (single_part_) passed_.insert("options of *PART" + options);
    }

    /// A part: its title, which may be blank, then its number first on the next line. A blank line before a title parts two of them.
    void read_part()
    {
        const int line = line_in_card_++ % part_lines_;
        if (single_part_ && line_in_card_ > 2) return;
        if (line == 0) title_ = trimmed_field(cards_.text());
        cards_.blanks_count = (line + 1) % part_lines_ == 0;
        if (line != 1) return;
        const auto& card = cards_.fields(8, 10);
        if (title_.empty() && !is_whole_number(card[0])) {
            title_ = trimmed_field(cards_.text());
            line_in_card_ = 1;
            return;
        }
        titles_.emplace_back(title_, part_number(card, 0));
        thicknesses_.set_section(titles_.back().second, dyna_number(cards_, card, 1, "the number of a section") + cards_.file().part);
    }

    /// Parts are found by their titles, too.
    void name_parts()
    {
        for (const auto& [title, part] : titles_) {
            const std::string name = part_name(part);
            if (title.empty() || title == name || !parts_with_elements_.contains(part)) continue;
            mesh_.element_set(title, title).members.push_back({0, 0, 1, name, false, {}});
        }
    }

    template <DynaSetKind kind>
    void begin_set(const std::string& options)
    {
        if (sets_.begin(kind, options)) return;
        data_ = nullptr;
        passed_.insert("*" + word_);
    }

    void read_set() { sets_.read(); }

    void begin_section(const std::string& options)
    {
        if (thicknesses_.begin(options)) return;
        data_ = nullptr;
        passed_.insert("*" + word_);
    }

    void read_section() { thicknesses_.read(); }

    // Parameters, transformations, included files

    void begin_parameters(const std::string& options) { cards_.begin_parameters(options); }
    void read_parameters() { cards_.read_parameters(); }
    void begin_transformation(const std::string& options) { transformations_.begin(options); }
    void read_transformation() { transformations_.read(); }

    void read_include() { cards_.include_list(folders_); }

    void read_path()
    {
        const std::string folder = cards_.file_name();
        folders_.push_back(folder.starts_with('/') ? folder : cards_.lines().folder() + "/" + folder);
    }

    /// A file whose numbers are shifted, whose lengths are multiplied and whose nodes are moved: its name, then offsets, factors, and the
    /// number of a transformation.
    void read_transformed()
    {
        const std::string name = cards_.file_name();
        const DynaFile around = cards_.file();
        DynaFile inner = around;
        const auto offset = [&](std::size_t index) {
            const auto& card = cards_.fields(7, 10);
            return index < card.size() ? integer_field(cards_.lines(), card[index], "an offset of numbers") : 0;
        };
        if (cards_.next_in_keyword()) {
            inner.node += offset(0);
            inner.element += offset(1);
            inner.part += offset(2);
            inner.set += offset(4);
            inner.definition += offset(6);
        }
        if (cards_.next_in_keyword()) title_.clear();  // the offset of all else, names to put before and behind titles
        const double factor = cards_.next_in_keyword() ? length_factor() : 1.0;
        if (cards_.next_in_keyword())
            inner.placed = transformed(around.placed, factor);
        else
            inner.placed = around.placed.after(stretched_by({factor, factor, factor}));
        data_ = nullptr;
        cards_.include(name, inner, folders_);
    }

    [[nodiscard]] double length_factor()
    {
        const auto& card = cards_.fields(5, 10);
        const double factor = card.size() > 2 ? real_field(cards_.lines(), card[2], "the factor of lengths") : 0.0;
        if (factor < 0) cards_.lines().fail(fmt::format("the factor of lengths is {}", factor), "give a factor above 0");
        return factor == 0 ? 1.0 : factor;
    }

    /// What is around, after the transformation named on the present card, after lengths are multiplied. Which of the latter two comes
    /// first must not matter.
    [[nodiscard]] AffineMap transformed(const AffineMap& around, double factor)
    {
        const std::int64_t id = dyna_number(cards_, cards_.fields(1, 10), 0, "the number of a transformation");
        const AffineMap stretched = stretched_by({factor, factor, factor});
        if (id == 0) return around.after(stretched);
        const AffineMap& map = transformations_.of(dyna_shifted(cards_, id, cards_.file().definition));
        if (factor != 1 && norm(map.shift) > 0)
            cards_.lines().fail("a factor of lengths and a transformation that moves are given together",
                                "leave FCTLEN out and begin the transformation with SCALE");
        return around.after(map.after(stretched));
    }

    /// *NODE_TRANSFORM: a transformation of the nodes of a set, carried out when all has been read.
    void read_node_transform()
    {
        const auto& card = cards_.fields(3, 10);
        const std::int64_t id =
            dyna_shifted(cards_, dyna_needed(cards_, card, 0, "the number of a transformation"), cards_.file().definition);
        const std::int64_t set = dyna_shifted(cards_, dyna_needed(cards_, card, 1, "the number of a set"), cards_.file().set);
        moves_.push_back({transformations_.of(id), DynaSets::node_set_name(set), cards_.lines().place()});
    }

    void move_nodes(Mesh& mesh) const
    {
        for (const auto& [map, name, place] : moves_) {
            const auto set = mesh.node_sets.find(name);
            if (set == mesh.node_sets.end())
                cards_.lines().fail_at(place, fmt::format("there is no set '{}' of nodes to transform", name),
                                       "define the set with *SET_NODE");
            for (const std::uint32_t node : set->second) mesh.nodes[node] = map(mesh.nodes[node]);
        }
    }

    void add_remarks(Mesh& mesh, const std::set<std::int64_t>& missing) const
    {
        for (const auto& [word, count] : left_out_)
            mesh.remarks.push_back(fmt::format(
                "{} elements of *{} are not computed: they are missing in the structure, only sets of their nodes are kept", count, word));
        if (const std::string remark = thicknesses_.remark(parts_with_elements_); !remark.empty()) mesh.remarks.push_back(remark);
        if (masses_ > 0)
            mesh.remarks.push_back(fmt::format(
                "point masses (*ELEMENT_MASS, {}) are not taken: give them with point_masses (their nodes are the set 'element_mass')",
                masses_));
        if (!missing.empty()) mesh.remarks.push_back(fmt::format("sets name parts without shells or solids: {}", fmt::join(missing, ", ")));
        if (!passed_.empty()) mesh.remarks.push_back(fmt::format("passed over: {}", fmt::join(passed_, ", ")));
    }

    /// Nodes to be moved at the end, and where the deck says so.
    struct Move {
        AffineMap map;
        std::string set;
        DeckPlace place;
    };

    DynaCards cards_;
    NumberedMesh mesh_;
    DynaSets sets_;
    DynaTransformations transformations_;
    DynaThicknesses thicknesses_;
    Data data_ = nullptr;  ///< what reads the lines of the present keyword
    std::string word_;     ///< the present keyword
    int line_in_card_ = 0;
    int further_lines_ = 0;  ///< of each element
    int part_lines_ = 2;
    bool single_part_ = false;
    std::string title_;
    std::vector<std::pair<std::string, std::int64_t>> titles_;  ///< of parts
    std::set<std::int64_t> parts_with_elements_;
    NumberedMesh::Set* part_set_ = nullptr;
    std::int64_t last_part_ = 0;
    std::vector<std::string> folders_;  ///< in which files to include are looked for
    std::vector<Move> moves_;
    std::map<std::string, int> left_out_;  ///< elements that are not computed, by keyword
    int masses_ = 0;
    std::set<std::string> passed_;
};

}  // namespace

Mesh read_dyna_mesh(Scanner scanner)
{
    return DynaReader(std::move(scanner)).read();
}

}  // namespace corpuscle
