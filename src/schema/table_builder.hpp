#pragma once

#include <string>
#include <utility>
#include <vector>

#include "schema/codec.hpp"
#include "schema/parameter.hpp"

namespace corpuscle {

/// What a row says of its parameter beside key and member; the member's type says the rest, its initialiser the default.
struct Facts {
    std::string unit;
    Range range;
    std::string meaning;
    std::string example;
};

/// Makes the table of a description: a row a parameter, bound to a member.
template <class Description>
class TableBuilder {
public:
    TableBuilder(std::string name, std::string meaning)
    {
        table_.name = std::move(name);
        table_.meaning = std::move(meaning);
        table_.make_default = [] { return static_cast<void*>(new Description{}); };
        table_.drop_default = [](void* description) { delete static_cast<Description*>(description); };
        if constexpr (requires(Description d) { d.places; })
            table_.places = [](void* description) { return &static_cast<Description*>(description)->places; };
    }

    /// A parameter that may be left out.
    template <class Member>
    TableBuilder& row(std::string key, Member Description::* member, Facts facts)
    {
        Parameter parameter{std::move(key),
                            std::move(facts.unit),
                            facts.range,
                            std::move(facts.meaning),
                            std::move(facts.example),
                            false,
                            {},
                            {},
                            nullptr,
                            false,
                            {},
                            {}};
        Codec<Member>::describe(parameter);
        const Parameter described = parameter;
        parameter.read = [member, described](void* description, const Value& value, Problems& problems) {
            Codec<Member>::read(static_cast<Description*>(description)->*member, value, described, problems);
        };
        parameter.write = [member, described](const void* description) {
            return Codec<Member>::write(static_cast<const Description*>(description)->*member, described);
        };
        table_.rows.push_back(std::move(parameter));
        return *this;
    }

    /// A parameter that must be given.
    template <class Member>
    TableBuilder& need(std::string key, Member Description::* member, Facts facts)
    {
        row(std::move(key), member, std::move(facts));
        table_.rows.back().required = true;
        return *this;
    }

    /// Exactly one of the keys must be given.
    TableBuilder& one_of(std::vector<std::string> keys)
    {
        table_.alternatives.push_back({std::move(keys), true});
        return *this;
    }

    /// At most one of the keys may be given.
    TableBuilder& at_most_one_of(std::vector<std::string> keys)
    {
        table_.alternatives.push_back({std::move(keys), false});
        return *this;
    }

    /// A plain value in place of the table stands for this key.
    TableBuilder& shorthand(std::string key)
    {
        table_.shorthand = std::move(key);
        return *this;
    }

    [[nodiscard]] Table table() const { return table_; }

private:
    Table table_;
};

}  // namespace corpuscle
