// SPDX-License-Identifier: Apache-2.0
/// Boolean expressions from text.
#ifndef CLEAVE_SETOP_EXPRESSION_TEXT_HPP
#define CLEAVE_SETOP_EXPRESSION_TEXT_HPP

#include <cleave/base/error.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// A text that is no expression.
class ExpressionError : public Error {
public:
    ExpressionError(std::size_t position, const std::string& message)
        : Error("at character " + std::to_string(position + 1) + " of the expression: " + message),
          position_(position) {}

    /// The number of characters before the place that is wrong.
    [[nodiscard]] std::size_t position() const noexcept { return position_; }

private:
    std::size_t position_;
};

namespace detail {

[[nodiscard]] constexpr bool starts_name(char c) noexcept {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
[[nodiscard]] constexpr bool continues_name(char c) noexcept {
    return starts_name(c) || (c >= '0' && c <= '9');
}

/// A parser by recursive descent, one level for each precedence.
template <class Find>
class ExpressionParser {
public:
    using Value = std::remove_cvref_t<std::invoke_result_t<Find&, std::string_view>>;

    ExpressionParser(std::string_view text, Find& find) : text_(text), find_(&find) {}

    Value run() {
        Value v = parse(0);
        if (at_ < text_.size())
            throw ExpressionError(at_, text_[at_] == ')' ? "there is no '(' to this ')'"
                                                         : "an operator | & - ^ is missing before '" + rest() + "'");
        return v;
    }

private:
    static constexpr std::string_view operators = "|^&-";  // from the loosest to the tightest
    static constexpr int deepest = 200;

    Value parse(std::size_t level) {
        if (level == operators.size()) return parse_one();
        Value v = parse(level + 1);
        while (skip_spaces() && text_[at_] == operators[level]) {
            ++at_;
            Value w = parse(level + 1);
            switch (operators[level]) {
                case '|':
                    v = v | w;
                    break;
                case '^':
                    v = v ^ w;
                    break;
                case '&':
                    v = v & w;
                    break;
                default:
                    v = v - w;
                    break;
            }
        }
        return v;
    }

    Value parse_one() {
        if (!skip_spaces()) throw ExpressionError(at_, "it ends where a name is expected");
        const char c = text_[at_];
        if (c == '~' || c == '(') {
            if (++depth_ > deepest) throw ExpressionError(at_, "it is nested too deeply");
            const std::size_t opened = at_++;
            if (c == '~') {
                Value v = ~parse_one();
                --depth_;
                return v;
            }
            Value v = parse(0);
            if (!skip_spaces() || text_[at_] != ')') throw ExpressionError(opened, "this '(' is never closed");
            ++at_;
            --depth_;
            return v;
        }
        if (!starts_name(c)) throw ExpressionError(at_, "a name is expected, not '" + rest() + "'");
        const std::size_t first = at_;
        while (at_ < text_.size() && continues_name(text_[at_])) ++at_;
        return (*find_)(text_.substr(first, at_ - first));
    }

    /// Returns: whether there is anything left.
    bool skip_spaces() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n')) ++at_;
        return at_ < text_.size();
    }

    [[nodiscard]] std::string rest() const {
        return std::string(text_.substr(at_, 12)) + (text_.size() > at_ + 12 ? "..." : "");
    }

    std::string_view text_;
    Find* find_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace detail

/// Whether a word may be a name in an expression: letters, digits and underscores, no digit first.
[[nodiscard]] inline bool is_expression_name(std::string_view word) noexcept {
    return !word.empty() && detail::starts_name(word.front()) &&
           std::all_of(word.begin(), word.end(), detail::continues_name);
}

/// Reads an expression of names, `| & - ^ ~` and parentheses, with the precedences that the operators have in C++: `~`
/// first, then `-`, `&`, `^`, `|`, each from the left. `find(name)` gives the value of a name; values of any type with
/// these operators will do: `Expression`s, `Region`s, `BooleanFunction`s.
/// Throws: ExpressionError for anything else, and what `find` throws.
template <class Find>
[[nodiscard]] auto parse_expression(std::string_view text, Find&& find) {
    return detail::ExpressionParser<std::remove_reference_t<Find>>(text, find).run();
}

CLEAVE_END_NAMESPACE

#endif
