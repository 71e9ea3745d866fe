#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "schema/problems.hpp"
#include "schema/range.hpp"
#include "schema/value.hpp"

namespace corpuscle {

struct Table;

/// One named parameter: the row that reads it, checks it, converts its unit, writes it back and documents it.
struct Parameter {
    std::string key;
    std::string unit;     ///< SI unit of its numbers, empty for pure ones
    Range range;          ///< of each of its numbers
    std::string meaning;  ///< one or two sentences
    std::string example;  ///< right-hand side as in a case; empty if the kind says enough
    bool required = false;

    std::string kind;                   ///< what it takes, in words
    std::vector<std::string> choices;   ///< words it takes, if only some
    const Table& (*table)() = nullptr;  ///< rows of its inner table, if it is one (or a list of them)
    bool many = false;                  ///< a list of tables

    /// Reads a value into the member of the description at the address.
    std::function<void(void*, const Value&, Problems&)> read;
    /// The member as a value; nothing for an optional one that is not set.
    std::function<std::optional<Value>(const void*)> write;
};

/// Where a description and its keys were read: for messages about what its values mean together.
struct Places {
    Place own;
    std::map<std::string, Place> keys;

    /// The place of a key, or of the whole where the key was not given.
    [[nodiscard]] const Place& of(const std::string& key) const;
};

/// Keys of which one, and only one, must be given (or at most one).
struct Alternative {
    std::vector<std::string> keys;
    bool required = true;
};

/// The parameters of one table of a case.
struct Table {
    std::string name;     ///< as in messages: "charge"
    std::string meaning;  ///< one or two sentences
    std::vector<Parameter> rows;
    std::vector<Alternative> alternatives;
    std::string shorthand;                ///< the key a plain value stands for, where a table may be written as one word or number
    std::function<void*()> make_default;  ///< a description with its defaults (given to drop_default)
    std::function<void(void*)> drop_default;
    std::function<Places*(void*)> places;  ///< null if the description keeps none

    [[nodiscard]] const Parameter* find(const std::string& key) const;
    [[nodiscard]] std::vector<std::string> keys() const;
};

/// Reads a value into a description; everything wrong with it is added to the problems.
void read_table(void* description, const Table& table, const Value& value, Problems& problems);

/// The description as a value, every row that has something to say, in the order of the rows.
[[nodiscard]] Value write_table(const void* description, const Table& table);

/// What the row holds when nobody gives it: TOML text, empty if nothing.
[[nodiscard]] std::string default_text(const Table& table, const Parameter& parameter);

/// "a number > 0 with its unit (kg, g, t, lb)": what a row takes, for messages and the manual.
[[nodiscard]] std::string expectation(const Parameter& parameter);

}  // namespace corpuscle
