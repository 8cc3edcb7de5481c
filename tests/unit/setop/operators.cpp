// SPDX-License-Identifier: Apache-2.0
#include <cleave/setop/operators.hpp>
//
#include "support/catch.hpp"
#include "support/region_checker.hpp"

#include <cleave/shape/box.hpp>

#include <string>

using namespace cleave;
using namespace support;

namespace {

template <int D>
std::string text(const Region<D>& region) {
    return dump(region.boundary());
}

/// Each spelling of an operation gives the same boundary, bit by bit.
template <int D>
void check_spellings(const Region<D>& a, const Region<D>& b) {
    CHECK(text(a | b) == text(checked(Operation::union_, a, b)));
    CHECK(text(a & b) == text(checked(Operation::intersection, a, b)));
    CHECK(text(a - b) == text(checked(Operation::difference, a, b)));
    CHECK(text(a ^ b) == text(checked(Operation::symmetric_difference, a, b)));
    CHECK(text(~a) == text(complement(a)));
    CHECK(text(union_(a, b)) == text(a | b));
    CHECK(text(intersection(a, b)) == text(a & b));
    CHECK(text(difference(a, b)) == text(a - b));
    CHECK(text(symmetric_difference(a, b)) == text(a ^ b));
    const auto assigned = [&](auto&& assign) {
        Region<D> r = a;
        Region<D>& self = assign(r);
        CHECK(&self == &r);
        return text(r);
    };
    const std::string before = text(a);
    CHECK(assigned([&](Region<D>& r) -> Region<D>& { return r |= b; }) == text(a | b));
    CHECK(assigned([&](Region<D>& r) -> Region<D>& { return r &= b; }) == text(a & b));
    CHECK(assigned([&](Region<D>& r) -> Region<D>& { return r -= b; }) == text(a - b));
    CHECK(assigned([&](Region<D>& r) -> Region<D>& { return r ^= b; }) == text(a ^ b));
    CHECK(text(a) == before);  // what was copied from
}

}  // namespace

TEST_CASE("operators: names, signs and assignments are one operation") {
    check_spellings<1>(intervals({{0, 2}, {5, 6}}), intervals({{1, 5}}));
    check_spellings<2>(box<2>({0, 0}, {2, 2}), box<2>({1, 0}, {3, 2}));
    check_spellings<3>(box<3>({0, 0, 0}, {2, 2, 2}), ~box<3>({1, 1, 1}, {3, 3, 3}));
    check_spellings<3>(Region<3>::empty(), Region<3>::full());
}

TEST_CASE("operators: what the results are") {
    const Region<1> a = intervals({{0, 2}});
    const Region<1> b = intervals({{1, 3}});
    CHECK(equal_sets(a | b, intervals({{0, 3}})));
    CHECK(equal_sets(a & b, intervals({{1, 2}})));
    CHECK(equal_sets(a - b, intervals({{0, 1}})));
    CHECK(equal_sets(b - a, intervals({{2, 3}})));
    CHECK(equal_sets(a ^ b, intervals({{0, 1}, {2, 3}})));
    CHECK(equal_sets(~(a | b), ~a & ~b));
    CHECK((a & intervals({{2, 3}})).is_empty());  // a common end is no common interior
    CHECK(equal_sets(a | intervals({{2, 3}}), intervals({{0, 3}})));
}

TEST_CASE("operators: a region with itself") {
    Region<2> a = box<2>({0, 0}, {2, 2}) - box<2>({1, 1}, {3, 3});
    const Region<2> before = a;
    const Region<2>& self = a;
    a |= self;
    CHECK(equal_sets(a, before));
    a &= self;
    CHECK(equal_sets(a, before));
    a ^= self;
    CHECK(a.is_empty());
    a = before;
    a -= self;
    CHECK(a.is_empty());
    CHECK((before | ~before).is_full());
    CHECK(before.face_count() == 6);
}

TEST_CASE("operators: the names take options") {
    const Region<2> a = box<2>({0, 0}, {2, 2});
    const Region<2> b = box<2>({1, 1}, {3, 3});
    OperationCounts counts;
    OperationOptions options;
    options.counts = &counts;
    for (const auto operation : {&union_<2, Rational>, &intersection<2, Rational>, &difference<2, Rational>,
                                 &symmetric_difference<2, Rational>}) {
        counts = {};
        const Region<2> r = operation(a, b, options);
        CHECK(counts.facets == 8);
        CHECK(counts.faces_whole + counts.faces_merged == r.face_count());
    }
}
