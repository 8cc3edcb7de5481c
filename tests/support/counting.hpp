// SPDX-License-Identifier: Apache-2.0
/// A number that counts what is done with it, so that tests can hold documented costs as equalities.
#ifndef CLEAVE_TESTS_SUPPORT_COUNTING_HPP
#define CLEAVE_TESTS_SUPPORT_COUNTING_HPP

#include <cleave/number/builtin.hpp>
#include <cleave/number/traits.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace counting {

struct Counts {
    std::size_t copies = 0;
    std::size_t sums = 0;
    std::size_t products = 0;
    std::size_t divisions = 0;
    std::size_t comparisons = 0;
    std::size_t signs = 0;
    std::size_t largest_bits = 0;  // of any sum, product or quotient
};

/// This thread's counts since the last `counts() = {}`.
[[nodiscard]] inline Counts& counts() {
    static thread_local Counts counts;
    return counts;
}

/// A ring like the library's own integer.
class Number {
public:
    Number() = default;
    explicit Number(int value) : value_(value) {}
    explicit Number(cleave::Integer value) : value_(std::move(value)) {}
    Number(const Number& other) : value_(other.value_) { ++counts().copies; }
    Number(Number&&) noexcept = default;
    Number& operator=(const Number& other) {
        ++counts().copies;
        value_ = other.value_;
        return *this;
    }
    Number& operator=(Number&&) noexcept = default;
    ~Number() = default;

    friend Number operator+(const Number& a, const Number& b) { return result(counts().sums, a.value_ + b.value_); }
    friend Number operator-(const Number& a, const Number& b) { return result(counts().sums, a.value_ - b.value_); }
    friend Number operator*(const Number& a, const Number& b) { return result(counts().products, a.value_ * b.value_); }
    friend Number operator-(const Number& a) { return Number(-a.value_); }
    Number& operator+=(const Number& b) { return *this = *this + b; }
    Number& operator-=(const Number& b) { return *this = *this - b; }
    friend bool operator==(const Number& a, const Number& b) {
        ++counts().comparisons;
        return a.value_ == b.value_;
    }
    friend bool operator<(const Number& a, const Number& b) {
        ++counts().comparisons;
        return a.value_ < b.value_;
    }

    [[nodiscard]] const cleave::Integer& value() const { return value_; }

    /// Counts one operation that gave `value`.
    [[nodiscard]] static Number result(std::size_t& counter, cleave::Integer value) {
        ++counter;
        counts().largest_bits = std::max(counts().largest_bits, value.bit_length());
        return Number(std::move(value));
    }

private:
    cleave::Integer value_;
};

}  // namespace counting

CLEAVE_BEGIN_NAMESPACE

template <>
struct number_traits<counting::Number> : number_traits_defaults<counting::Number> {
    using Number = counting::Number;

    static constexpr bool is_field = false;
    using field_type = Rational;

    static Sign sign(const Number& x) {
        ++counting::counts().signs;
        return x.value().sign();
    }
    static Number exact_divide(const Number& a, const Number& b) {
        return Number::result(counting::counts().divisions, cleave::exact_divide(a.value(), b.value()));
    }
    static Fraction to_fraction(const Number& x) { return {x.value(), 1}; }
    static Number from_integer(const Integer& x) { return Number(x); }
};

CLEAVE_END_NAMESPACE

#endif
