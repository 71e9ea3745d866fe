#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace corpuscle {

/// What a value read from a file can be. `other` is what no parameter takes (a date).
enum class ValueKind { boolean, integer, number, text, array, table, other };

/// A key of a table, and where it was written.
struct Key {
    std::string name;
    Place place;
};

/// A value as read, whatever the file's language: a scalar, an array or a table; each with the place it was read at.
struct Value {
    ValueKind kind = ValueKind::table;
    bool boolean = false;
    std::int64_t integer = 0;
    double number = 0;
    std::string text;
    std::vector<Value> items;  ///< of an array; the values of a table
    std::vector<Key> keys;     ///< of a table, one for each item
    Place place;

    static Value of_boolean(bool value);
    static Value of_integer(std::int64_t value);
    static Value of_number(double value);
    static Value of_text(std::string value);
    static Value of_array(std::vector<Value> values = {});

    [[nodiscard]] const Value* find(const std::string& key) const;
    [[nodiscard]] Value* find(const std::string& key);
    /// Adds a key to a table, or replaces its value.
    Value& put(const std::string& key, Value value, Place key_place = {});
    /// "a text", "a table", ...: for messages.
    [[nodiscard]] std::string kind_name() const;
};

/// The value as TOML on one line.
[[nodiscard]] std::string inline_toml(const Value& value);

/// A table as a TOML document: its scalars, then [tables] and [[arrays of tables]], each entry's inner tables on one line.
[[nodiscard]] std::string toml_document(const Value& table);

}  // namespace corpuscle
