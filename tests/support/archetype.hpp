// SPDX-License-Identifier: Apache-2.0
/// The least that a number may offer. Code that compiles with an archetype asks for no more than the concept says.
///
/// Sums and products are not numbers but descriptions that convert to one (as with expression templates), comparisons
/// give something that converts to bool and nothing more, in-place operations return nothing, there is no stream, no
/// implicit construction, no mixed arithmetic with built-in numbers, and `number_traits` has its compulsory members
/// only.
#ifndef CLEAVE_TESTS_SUPPORT_ARCHETYPE_HPP
#define CLEAVE_TESTS_SUPPORT_ARCHETYPE_HPP

#include <cleave/number/builtin.hpp>
#include <cleave/number/rational.hpp>
#include <cleave/number/traits.hpp>

#include <concepts>
#include <type_traits>
#include <utility>

namespace archetype {

/// A ring where `Value` is cleave::Integer, a field where it is cleave::Rational.
template <class Value>
class Number;

/// What `a + b` gives: not a number, but convertible to one, and only from an rvalue.
template <class Value>
class Description {
public:
    explicit Description(Value value) : value_(std::move(value)) {}
    Description(const Description&) = delete;
    Description& operator=(const Description&) = delete;
    operator Number<Value>() && { return Number<Value>(std::move(value_)); }

private:
    Value value_;
};

/// Something that is true or false and has no other use.
class Truth {
public:
    explicit Truth(bool value) : value_(value) {}
    operator bool() const { return value_; }
    void operator&() const = delete;
    void operator,(Truth) const = delete;

private:
    bool value_;
};

template <class Value>
class Number {
    static constexpr bool is_field = !std::same_as<Value, cleave::Integer>;

public:
    Number() : value_(0xbad) {}  // "any value": nothing may rely on a default-constructed number being zero
    explicit Number(int value) : value_(value) {}
    explicit Number(Value value) : value_(std::move(value)) {}

    friend Description<Value> operator+(const Number& a, const Number& b) { return make(a.value_ + b.value_); }
    friend Description<Value> operator-(const Number& a, const Number& b) { return make(a.value_ - b.value_); }
    friend Description<Value> operator*(const Number& a, const Number& b) { return make(a.value_ * b.value_); }
    friend Description<Value> operator-(const Number& a) { return make(-a.value_); }
    friend Description<Value> operator/(const Number& a, const Number& b) requires is_field {
        return make(a.value_ / b.value_);
    }
    void operator+=(const Number& b) { value_ += b.value_; }
    void operator-=(const Number& b) { value_ -= b.value_; }
    friend Truth operator==(const Number& a, const Number& b) { return Truth(a.value_ == b.value_); }
    friend Truth operator<(const Number& a, const Number& b) { return Truth(a.value_ < b.value_); }

    [[nodiscard]] const Value& value() const { return value_; }

private:
    [[nodiscard]] static Description<Value> make(Value value) { return Description<Value>(std::move(value)); }

    Value value_;
};

using Ring = Number<cleave::Integer>;
using Field = Number<cleave::Rational>;

}  // namespace archetype

CLEAVE_BEGIN_NAMESPACE

template <class Value>
struct number_traits<archetype::Number<Value>> : number_traits_defaults<archetype::Number<Value>> {
    using Number = archetype::Number<Value>;
    using Base = number_traits<Value>;

    static constexpr bool is_field = Base::is_field;
    using field_type = archetype::Field;

    static Sign sign(const Number& x) { return Base::sign(x.value()); }
    static Number exact_divide(const Number& a, const Number& b) {
        return Number(Value(Base::exact_divide(a.value(), b.value())));
    }
    static Fraction to_fraction(const Number& x) { return Base::to_fraction(x.value()); }
    static Number from_integer(const Integer& x) { return Number(Value(Base::from_integer(x))); }
    static field_type from_fraction(const Integer& num, const Integer& den) {
        return field_type(number_traits<Rational>::from_fraction(num, den));
    }
};

CLEAVE_END_NAMESPACE

#endif
