#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "input/meshes/dyna_cards.hpp"

namespace corpuscle {

/// The thicknesses that an LS-DYNA deck gives its parts by *SECTION_SHELL. The case says those that count: these are only told.
class DynaThicknesses {
public:
    explicit DynaThicknesses(DynaCards& cards) : cards_(cards) {}

    /// Begins *SECTION_SHELL; false with options that change its cards. `read` takes each card that follows.
    [[nodiscard]] bool begin(const std::string& options);
    void read();
    /// Numbers of sections are taken as shifted by what parts are, so that those of different files stay apart.
    void set_section(std::int64_t part, std::int64_t section) { section_of_[part] = section; }

    /// What people should know of them, of the parts that have elements; empty if there is nothing.
    [[nodiscard]] std::string remark(const std::set<std::int64_t>& parts) const;

private:
    void read_first_card();

    DynaCards& cards_;
    bool has_titles_ = false;
    bool own_cards_ = false;  ///< the section is of elements whose further cards are not known
    int line_ = 0;            ///< of the present section
    int angle_lines_ = 0;     ///< that follow the thicknesses, of laminates
    std::int64_t section_ = 0;
    std::map<std::int64_t, double> thickness_;         ///< by section, in the deck's unit
    std::map<std::int64_t, std::int64_t> section_of_;  ///< by part
};

}  // namespace corpuscle
