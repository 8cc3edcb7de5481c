// SPDX-License-Identifier: Apache-2.0
/// What the library asks of a number: `ExactRing` for predicates and constructions, `ExactField` where a ratio is
/// shown.
///
/// A number opts in by specialising `number_traits<N>` (number/traits.hpp, which also has the optional members). The
/// operators alone are not enough: `double` has them all, and is not exact.
///
/// `ExactRing<N>`, with `a`, `b` of type `const N`, `x` of type `N`, `k` an `int`, `T` = `number_traits<N>`:
///
/// | expression                        | result           | meaning                                  | cost          |
/// |-----------------------------------|------------------|------------------------------------------|---------------|
/// | `N()`                             | `N`              | any value; it may be assigned to         | no allocation |
/// | `N(k)`                            | `N`              | the integer k                            | no allocation |
/// | `a + b`, `a - b`, `-a`            | converts to `N`  | exact                                    | linear        |
/// | `a * b`                           | converts to `N`  | exact                                    | a product     |
/// | `x += a`, `x -= a`                | not used         | exact                                    | linear        |
/// | `a == b`, `a < b`                 | converts to bool | equality and order of the values         | linear        |
/// | `T::is_field`                     | constant bool    | whether `a / b` is exact for all b != 0  |               |
/// | `T::field_type`                   | an `ExactField`  | the fractions of N; N itself for a field |               |
/// | `T::sign(a)`                      | `Sign`           | the sign of the value                    | constant      |
/// | `T::exact_divide(a, b)`           | converts to `N`  | q with q * b == a; the caller knows that | a quotient    |
/// |                                   |                  | b != 0 and that such a q exists          |               |
/// | `T::to_fraction(a)`               | `Fraction`       | lowest terms, positive denominator       | a copy        |
/// | `T::from_integer(i)`              | converts to `N`  | the value of an `Integer`                | a copy        |
///
/// `ExactField<N>` adds:
///
/// | expression                        | result           | meaning                                  | cost          |
/// |-----------------------------------|------------------|------------------------------------------|---------------|
/// | `a / b`                           | converts to `N`  | exact quotient, b != 0                   | a quotient    |
///
/// Semantic demands, which no compiler checks:
/// - Every operation is exact. One that cannot be (a fixed width that would overflow) throws `NumberError` and never
///   returns a wrong value. Built-in integers wrap around or are undefined there, so they are not rings.
/// - Operators obey the laws of a commutative ring without zero divisors; `<` is a total order compatible with them;
///   `T::sign(a)` is minus, zero or plus exactly if `a < N(0)`, `a == N(0)` or `N(0) < a`.
/// - Equal values compare equal however they were made. Where a type allows several forms of one value (an
///   `mpq_class` made from 2 and 4), the caller makes it canonical before the library sees it.
/// - Copies are independent: different objects may be used from several threads at once, and so may one const object.
///
/// Why "converts to `N`" and not `same_as<N>`: in libraries with expression templates `a + b` is a description of a sum
/// that refers to `a` and `b`, not a number, and a demand for `N` itself would reject `mpz_class`, `mpq_class` and
/// Boost's rationals; where products are widened, `a * b` is a wider integer. Why not `common_with`: its sum type would
/// have to be reachable from both sides, which those descriptions are not. It follows that generic code writes
/// `N x = a + b;` and never `auto` for a numeric result, which could refer to operands that are gone.
#ifndef CLEAVE_NUMBER_CONCEPTS_HPP
#define CLEAVE_NUMBER_CONCEPTS_HPP

#include <cleave/number/sign.hpp>

#include <concepts>

CLEAVE_BEGIN_NAMESPACE

/// How the library reaches what numbers have no common syntax for. Not defined for types that have not opted in.
template <class N>
struct number_traits;

template <unsigned InlineLimbs>
class BasicInteger;
using Integer = BasicInteger<6>;

struct Fraction;

// clang-format off
/// A commutative ring of exact, ordered numbers: enough for every predicate. See the first table above.
template <class N>
concept ExactRing =
    std::copyable<N> && std::default_initializable<N> && std::constructible_from<N, int> &&
    requires(const N& a, const N& b, N& x, const Integer& i) {
        { a + b } -> std::convertible_to<N>;
        { a - b } -> std::convertible_to<N>;
        { a * b } -> std::convertible_to<N>;
        { -a } -> std::convertible_to<N>;
        x += a;
        x -= a;
        { a == b } -> std::convertible_to<bool>;
        { a < b } -> std::convertible_to<bool>;
        { number_traits<N>::is_field } -> std::convertible_to<bool>;
        typename number_traits<N>::field_type;
        { number_traits<N>::sign(a) } -> std::same_as<Sign>;
        { number_traits<N>::exact_divide(a, b) } -> std::convertible_to<N>;
        { number_traits<N>::to_fraction(a) } -> std::same_as<Fraction>;
        { number_traits<N>::from_integer(i) } -> std::convertible_to<N>;
    };

/// An exact ring with exact division: coordinates, measures and centroids leave the library as one.
template <class N>
concept ExactField =
    ExactRing<N> && bool(number_traits<N>::is_field) && std::same_as<typename number_traits<N>::field_type, N> &&
    requires(const N& a, const N& b) {
        { a / b } -> std::convertible_to<N>;
    };

/// Integers of the type N can be multiplied and summed in R, so that a polynomial of entries N may be evaluated in a
/// wider R. Every ring is wide enough for itself.
template <class R, class N>
concept AccumulatesInto = ExactRing<R> && requires(R& r, const R& s, const N& a) {
    R(a);
    { a * a } -> std::convertible_to<R>;
    { s * a } -> std::convertible_to<R>;
    r += s;
    r -= s;
};
// clang-format on

CLEAVE_END_NAMESPACE

#endif
