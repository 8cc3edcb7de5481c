// SPDX-License-Identifier: Apache-2.0
/// Properties that hold for random arguments:
///
///     support::property("a flip changes the side", [](const Plane<3, Integer>& h, const Point<3, Integer>& p) {
///         RC_ASSERT(side(flip(h), p) == -side(h, p));
///     });
///
/// Each argument is drawn by `Drawn` of its type; a body may draw more by `draw` and the functions below. What is drawn
/// shrinks when the body fails. rapidcheck does the work behind functions that are compiled once (property.cpp): its
/// own `rc::prop` and `rc::gen` would add thousands of functions to every file with properties.
#ifndef CLEAVE_TESTS_SUPPORT_PROPERTY_HPP
#define CLEAVE_TESTS_SUPPORT_PROPERTY_HPP

#include "support/catch.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace support {

// --- how often --------------------------------------------------------------------------------------------------

/// Checks that `body` holds in `cases` random cases, as a section of the running test case.
void check_property(const std::string& description, std::size_t cases, const std::function<void()>& body);

/// 100, or what RC_PARAMS' max_success says.
[[nodiscard]] std::size_t cases_of_property();

/// As many per cent of `cases` as RC_PARAMS' max_success says or, where it says nothing, CLEAVE_TEST_SCALE.
[[nodiscard]] std::size_t cases_of_law(std::size_t cases);

// --- draws, in the body of a property ---------------------------------------------------------------------------

/// One of first, ..., past - 1, all equally likely. Shrinks towards 0 if that is one of them, otherwise towards first.
[[nodiscard]] int draw_int(int first, int past);

/// `count` of them, each shrinking by itself.
[[nodiscard]] std::vector<int> draw_ints(std::size_t count, int first, int past);

/// The same, but early cases have fewer different ones: each is also drawn from a part of the range that grows.
[[nodiscard]] std::vector<int> draw_crowded_ints(std::size_t count, int first, int past);

/// An index of `count` things, all equally likely. Shrinks towards 0.
[[nodiscard]] std::size_t draw_index(std::size_t count);

/// The index of a weight, as likely as the weight says. Shrinks towards 0.
[[nodiscard]] std::size_t draw_choice(std::initializer_list<int> weights);

/// Either, equally likely. Shrinks towards false.
[[nodiscard]] bool draw_bool();
[[nodiscard]] std::vector<bool> draw_bools(std::size_t count);

/// A word of at most `bits` bits, fewer in early cases.
[[nodiscard]] std::uint64_t draw_word(int bits = 64);

/// A two's complement number of at most `bits` bits with its sign, fewer in early cases.
[[nodiscard]] std::int64_t draw_signed(int bits = 64);

/// For each of up to 100 things, fewer in early cases, whether it belongs to a list. At first they all do; shrinking
/// leaves out any of them. Draw those that do not belong too, so that the others stay what they are.
[[nodiscard]] std::vector<bool> draw_membership();

// --- draws by type ----------------------------------------------------------------------------------------------

/// How a T is drawn: `static T draw()`. Optionally how it is shown in a counterexample: `static void
/// show(std::ostream&, const T&)`; without it by `<<`, or element by element, or not at all. To be specialised beside
/// the other generators.
template <class T>
struct Drawn;

/// A random T.
template <class T>
[[nodiscard]] T draw() {
    return Drawn<T>::draw();
}

/// `count` of them.
template <class T>
[[nodiscard]] std::vector<T> draw_vector(std::size_t count) {
    std::vector<T> list;
    list.reserve(count);
    for (std::size_t i = 0; i < count; ++i) list.push_back(Drawn<T>::draw());
    return list;
}

/// A list of what `draw_one` returns. Its length is random, short in early cases.
template <class Draw>
[[nodiscard]] auto draw_list(const Draw& draw_one) {
    std::vector<decltype(draw_one())> list;
    for (const bool belongs : draw_membership()) {
        auto drawn = draw_one();
        if (belongs) list.push_back(std::move(drawn));
    }
    return list;
}

template <>
struct Drawn<bool> {
    static bool draw() { return draw_bool(); }
};

template <std::integral T>
struct Drawn<T> {
    static T draw() {
        constexpr int digits = std::numeric_limits<T>::digits;
        if constexpr (std::signed_integral<T>) {
            return static_cast<T>(draw_signed(digits + 1));
        } else {
            return static_cast<T>(draw_word(digits));
        }
    }
};

template <class T, std::size_t N>
struct Drawn<std::array<T, N>> {
    static std::array<T, N> draw() {
        std::array<T, N> all;
        for (T& x : all) x = Drawn<T>::draw();
        return all;
    }
};

template <class T>
struct Drawn<std::vector<T>> {
    static std::vector<T> draw() { return draw_list(&Drawn<T>::draw); }
};

// --- properties -------------------------------------------------------------------------------------------------

namespace property_detail {

/// Whether the exception being handled says that the property is false, and not that the case does not count.
[[nodiscard]] bool is_counterexample();

/// Where a counterexample's arguments are written.
[[nodiscard]] std::ostream& counterexample_log();

template <class T>
void show(std::ostream& out, const T& value) {
    if constexpr (requires { Drawn<T>::show(out, value); }) {
        Drawn<T>::show(out, value);
    } else if constexpr (std::integral<T> && sizeof(T) == 1) {
        out << int(value);
    } else if constexpr (requires { out << value; }) {
        out << value;
    } else if constexpr (requires { value.begin() != value.end(); }) {
        out << "[";
        const char* between = "";
        for (const auto& x : value) {
            out << between;
            show(out, x);
            between = ", ";
        }
        out << "]";
    }
}

/// Calls the body of a property, and shows the arguments if it fails. A class so that `Call{body, draw()...}` draws
/// them from left to right.
struct Call {
    template <class Body, class... Arguments>
    explicit Call(const Body& body, const Arguments&... arguments) {
        try {
            body(arguments...);
        } catch (...) {
            if (is_counterexample()) {
                std::ostream& out = counterexample_log();
                (static_cast<void>((show(out, arguments), out << "\n")), ...);
            }
            throw;
        }
    }
};

template <class Body, class Class, class... Arguments>
void call_with_drawn(const Body& body, void (Class::*)(Arguments...) const) {
    Call{body, Drawn<std::remove_cvref_t<Arguments>>::draw()...};
}

}  // namespace property_detail

/// A property with its own number of cases, for bodies that take long and for those that need many.
template <class Body>
void law(const std::string& description, std::size_t cases, const Body& body) {
    check_property(description, cases_of_law(cases),
                   [&body] { property_detail::call_with_drawn(body, &Body::operator()); });
}

/// A property that is checked in rapidcheck's usual number of cases.
template <class Body>
void property(const std::string& description, const Body& body) {
    check_property(description, cases_of_property(),
                   [&body] { property_detail::call_with_drawn(body, &Body::operator()); });
}

}  // namespace support

#endif
