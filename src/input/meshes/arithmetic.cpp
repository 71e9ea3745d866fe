#include "input/meshes/arithmetic.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

namespace corpuscle {

namespace {

constexpr int deepest_parentheses = 50;

using Arguments = std::vector<DeckNumber>;

/// A function: how many arguments it needs at least and takes at most, and its value.
struct DeckFunction {
    std::size_t least, most;
    DeckNumber (*value)(const Arguments&);
};

template <double (*function)(double)>
DeckNumber real_of(const Arguments& x)
{
    return {function(x[0].value), false};
}

template <double (*function)(double)>
DeckNumber whole_of(const Arguments& x)
{
    return {function(x[0].value), true};
}

/// The same, of the kind of its argument.
template <double (*function)(double)>
DeckNumber like(const Arguments& x)
{
    return {function(x[0].value), x[0].whole};
}

bool all_whole(const Arguments& x)
{
    return std::all_of(x.begin(), x.end(), [](const DeckNumber& number) { return number.whole; });
}

bool less(const DeckNumber& a, const DeckNumber& b)
{
    return a.value < b.value;
}

const std::map<std::string, DeckFunction>& functions()
{
    constexpr std::size_t many = 20;
    static const std::map<std::string, DeckFunction> known{
        {"ABS", {1, 1, like<std::fabs>}},
        {"AINT", {1, 1, real_of<std::trunc>}},
        {"ANINT", {1, 1, real_of<std::round>}},
        {"INT", {1, 1, whole_of<std::trunc>}},
        {"NINT", {1, 1, whole_of<std::round>}},
        {"CEIL", {1, 1, whole_of<std::ceil>}},
        {"FLOOR", {1, 1, whole_of<std::floor>}},
        {"SQRT", {1, 1, real_of<std::sqrt>}},
        {"EXP", {1, 1, real_of<std::exp>}},
        {"LOG", {1, 1, real_of<std::log>}},
        {"LOG10", {1, 1, real_of<std::log10>}},
        {"SIN", {1, 1, real_of<std::sin>}},
        {"COS", {1, 1, real_of<std::cos>}},
        {"TAN", {1, 1, real_of<std::tan>}},
        {"ASIN", {1, 1, real_of<std::asin>}},
        {"ACOS", {1, 1, real_of<std::acos>}},
        {"ATAN", {1, 1, real_of<std::atan>}},
        {"SINH", {1, 1, real_of<std::sinh>}},
        {"COSH", {1, 1, real_of<std::cosh>}},
        {"TANH", {1, 1, real_of<std::tanh>}},
        {"FLOAT", {1, 1, [](const Arguments& x) { return DeckNumber{x[0].value, false}; }}},
        {"ATAN2", {2, 2, [](const Arguments& x) { return DeckNumber{std::atan2(x[0].value, x[1].value), false}; }}},
        {"MOD", {2, 2, [](const Arguments& x) { return DeckNumber{std::fmod(x[0].value, x[1].value), all_whole(x)}; }}},
        {"SIGN", {2, 2, [](const Arguments& x) { return DeckNumber{std::copysign(x[0].value, x[1].value), x[0].whole}; }}},
        {"MIN", {1, many, [](const Arguments& x) { return DeckNumber{std::min_element(x.begin(), x.end(), less)->value, all_whole(x)}; }}},
        {"MAX", {1, many, [](const Arguments& x) { return DeckNumber{std::max_element(x.begin(), x.end(), less)->value, all_whole(x)}; }}}};
    return known;
}

/// Reads an expression from left to right, each rule by a function of its own.
class ExpressionReader {
public:
    ExpressionReader(const DeckLines& lines, std::string_view text, const DeckNames& names) : lines_(lines), names_(names), text_(text) {}

    DeckNumber read()
    {
        const DeckNumber number = sum();
        if (!at_end()) fail(fmt::format("'{}' follows where an operator was expected", text_.substr(at_, 10)));
        return number;
    }

private:
    [[noreturn]] void fail(const std::string& why) const
    {
        lines_.fail(fmt::format("'{}' is no expression that can be computed: {}", text_.substr(0, 60), why),
                    "use numbers, names, + - * / **, parentheses and functions such as sqrt(x), or write the value");
    }

    bool at_end()
    {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
        return at_ == text_.size();
    }

    bool take(std::string_view mark)
    {
        if (at_end() || !text_.substr(at_).starts_with(mark)) return false;
        at_ += mark.size();
        return true;
    }

    DeckNumber finite(const DeckNumber& number, const char* what) const
    {
        if (!std::isfinite(number.value)) fail(fmt::format("{} has no finite value", what));
        return number;
    }

    DeckNumber sum()
    {
        DeckNumber left = product();
        while (true) {
            const bool plus = take("+");
            if (!plus && !take("-")) return left;
            const DeckNumber right = product();
            left = finite({plus ? left.value + right.value : left.value - right.value, left.whole && right.whole}, "a sum");
        }
    }

    DeckNumber product()
    {
        DeckNumber left = power();
        while (true) {
            const bool times = take("*");
            if (!times && !take("/")) return left;
            const DeckNumber right = power();
            const bool whole = left.whole && right.whole;
            const double value = times ? left.value * right.value : left.value / right.value;
            left = finite({whole ? std::trunc(value) : value, whole}, times ? "a product" : "a quotient");
        }
    }

    DeckNumber power()
    {
        const DeckNumber base = signed_number();
        if (!take("**")) return base;
        if (++depth_ > deepest_parentheses) fail("it is too deep");
        const DeckNumber exponent = power();
        --depth_;
        const bool whole = base.whole && exponent.whole;
        const double value = std::pow(base.value, exponent.value);
        return finite({whole ? std::trunc(value) : value, whole}, "a power");
    }

    DeckNumber signed_number()
    {
        bool minus = false;
        for (bool any = true; any;) {
            const bool negative = take("-");
            minus = minus != negative;
            any = negative || take("+");
        }
        DeckNumber number = operand();
        if (minus) number.value = -number.value;
        return number;
    }

    DeckNumber operand()
    {
        if (at_end()) fail("it ends where a number was expected");
        if (take("(")) {
            if (++depth_ > deepest_parentheses) fail("it is too deep");
            const DeckNumber inner = sum();
            --depth_;
            if (!take(")")) fail("')' is missing");
            return inner;
        }
        take("&");
        const char first = at_ < text_.size() ? text_[at_] : ' ';
        if (std::isdigit(static_cast<unsigned char>(first)) || first == '.') return number();
        if (std::isalpha(static_cast<unsigned char>(first)) || first == '_') return name_or_function();
        fail(fmt::format("'{}' stands where a number was expected", text_.substr(at_, 10)));
    }

    /// Digits, a point, and an exponent with E or D.
    DeckNumber number()
    {
        std::string digits;
        bool whole = true;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            const bool exponent = std::string_view("eEdD").find(c) != std::string_view::npos;
            const bool sign = (c == '+' || c == '-') && !digits.empty() && digits.back() == 'e';
            if (!exponent && !sign && c != '.' && !std::isdigit(static_cast<unsigned char>(c))) break;
            whole = whole && std::isdigit(static_cast<unsigned char>(c));
            if (c != '+') digits += exponent ? 'e' : c;
            ++at_;
        }
        double value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc{} || end != digits.data() + digits.size()) fail(fmt::format("'{}' is not a number", digits));
        return finite({value, whole}, "a number");
    }

    DeckNumber name_or_function()
    {
        const std::size_t begin = at_;
        while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_')) ++at_;
        const std::string name = in_capitals(text_.substr(begin, at_ - begin));
        const auto function = functions().find(name);
        if (function == functions().end() || !take("(")) return names_(name);
        if (++depth_ > deepest_parentheses) fail("it is too deep");
        Arguments arguments{sum()};
        while (take(",")) arguments.push_back(sum());
        --depth_;
        if (!take(")")) fail("')' is missing");
        if (arguments.size() < function->second.least || arguments.size() > function->second.most)
            fail(fmt::format("{} does not take {} numbers", name, arguments.size()));
        return finite(function->second.value(arguments), name.c_str());
    }

    const DeckLines& lines_;
    const DeckNames& names_;
    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

DeckNumber evaluate_expression(const DeckLines& lines, std::string_view expression, const DeckNames& names)
{
    return ExpressionReader(lines, expression, names).read();
}

}  // namespace corpuscle
