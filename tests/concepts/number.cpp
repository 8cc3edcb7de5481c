// SPDX-License-Identifier: Apache-2.0
// What is an exact number, and what only looks like one.
#include <cleave/number/concepts.hpp>

#include "support/archetype.hpp"
#include "support/backends.hpp"
#include "support/counting.hpp"

#include <cleave/number.hpp>

#include <complex>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>

#if defined(CLEAVE_HAS_BOOST)
#include <boost/multiprecision/cpp_dec_float.hpp>
#endif

using namespace cleave;

namespace {

template <class N>
constexpr bool is_plain_ring = ExactRing<N> && !ExactField<N> && ExactField<typename number_traits<N>::field_type>;

template <class Tuple>
struct All;
template <class... N>
struct All<std::tuple<N...>> {
    static constexpr bool rings = (is_plain_ring<N> && ...);
    static constexpr bool fields = (ExactField<N> && ...);
    static constexpr bool accumulate = (AccumulatesInto<N, N> && ...);
};

static_assert(All<backends::Rings>::rings);
static_assert(All<backends::Fields>::fields);
static_assert(All<backends::Numbers>::accumulate);
static_assert(is_plain_ring<WideInteger> && is_plain_ring<BasicInteger<2>> && is_plain_ring<FixedInt<64>>);
static_assert(is_plain_ring<counting::Number>);
static_assert(ExactField<Rational>);
static_assert(ExactRing<archetype::Ring> && ExactField<archetype::Field>);

// Wider numbers accumulate narrower ones, and not the other way round: nothing is narrowed unseen.
static_assert(AccumulatesInto<WideInteger, Integer>);
static_assert(AccumulatesInto<FixedInt<512>, FixedInt<128>>);
static_assert(!AccumulatesInto<FixedInt<128>, FixedInt<512>>);

// Approximate numbers have every operator and are not exact.
static_assert(!ExactRing<float> && !ExactRing<double> && !ExactRing<long double>);
static_assert(!ExactRing<std::complex<double>>);
static_assert(!ExactRing<Interval>);

// Built-in integers overflow: undefined behaviour or a wrong value instead of an error.
static_assert(!ExactRing<int> && !ExactRing<unsigned> && !ExactRing<std::int64_t> && !ExactRing<long long>);
static_assert(!ExactRing<bool> && !ExactRing<char> && !ExactRing<Int128>);

// Residues are exact but have no order: 3 - 5 is neither below nor above zero.
static_assert(!ExactRing<Mod61>);

// Not numbers at all.
static_assert(!ExactRing<std::string> && !ExactRing<void*> && !ExactRing<Sign> && !ExactRing<Fraction>);

// Not values: references, constants, and the descriptions of sums that expression templates give.
static_assert(!ExactRing<Integer&> && !ExactRing<const Integer>);
static_assert(!ExactRing<archetype::Description<Integer>>);

#if defined(CLEAVE_HAS_GMP)
static_assert(ExactRing<mpz_class> && !ExactField<mpz_class>);
static_assert(ExactField<mpq_class>);
static_assert(!ExactRing<mpf_class>, "mpf_class has any precision, but not every value");
using Sum = decltype(std::declval<mpz_class>() + std::declval<mpz_class>());
static_assert(!std::is_same_v<Sum, mpz_class> && std::is_convertible_v<Sum, mpz_class>, "why convertibility is asked");
static_assert(!ExactRing<Sum>);
#endif

#if defined(CLEAVE_HAS_BOOST)
static_assert(!ExactRing<boost::multiprecision::cpp_dec_float_50>);
static_assert(!ExactRing<boost::multiprecision::checked_int128_t>, "opted in by nobody");
#endif

/// Everything but the opt-in.
struct NotOptedIn {
    NotOptedIn() = default;
    explicit NotOptedIn(int) {}
    NotOptedIn operator+(const NotOptedIn&) const { return *this; }
    NotOptedIn operator-(const NotOptedIn&) const { return *this; }
    NotOptedIn operator*(const NotOptedIn&) const { return *this; }
    NotOptedIn operator-() const { return *this; }
    NotOptedIn& operator+=(const NotOptedIn&) { return *this; }
    NotOptedIn& operator-=(const NotOptedIn&) { return *this; }
    bool operator==(const NotOptedIn&) const { return true; }
    bool operator<(const NotOptedIn&) const { return false; }
};
static_assert(!ExactRing<NotOptedIn>);

/// Opted in, without an order.
struct Unordered : NotOptedIn {
    using NotOptedIn::NotOptedIn;
    Unordered operator+(const Unordered&) const { return *this; }
    Unordered operator-(const Unordered&) const { return *this; }
    Unordered operator*(const Unordered&) const { return *this; }
    Unordered operator-() const { return *this; }
    bool operator<(const Unordered&) const = delete;
};

/// Opted in, and says to be a field without division.
struct Undivided : NotOptedIn {
    using NotOptedIn::NotOptedIn;
    Undivided operator+(const Undivided&) const { return *this; }
    Undivided operator-(const Undivided&) const { return *this; }
    Undivided operator*(const Undivided&) const { return *this; }
    Undivided operator-() const { return *this; }
};

template <class N, bool IsField>
struct EmptyTraits {
    static constexpr bool is_field = IsField;
    using field_type = std::conditional_t<IsField, N, Rational>;
    static Sign sign(const N&) { return Sign::zero; }
    static N exact_divide(const N& a, const N&) { return a; }
    static Fraction to_fraction(const N&) { return {}; }
    static N from_integer(const Integer&) { return {}; }
};

}  // namespace

CLEAVE_BEGIN_NAMESPACE
template <>
struct number_traits<Unordered> : EmptyTraits<Unordered, false> {};
template <>
struct number_traits<Undivided> : EmptyTraits<Undivided, true> {};
CLEAVE_END_NAMESPACE

static_assert(!ExactRing<Unordered>);
static_assert(ExactRing<Undivided> && !ExactField<Undivided>);
