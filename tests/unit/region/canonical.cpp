// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/canonical.hpp>
//
#include <cleave/region/convex.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>

#include "support/catch.hpp"

#include <string>

using namespace cleave;

TEST_CASE("canonical: it is a text that says planes, and ends on lines") {
    CHECK(canonical(Region<1>::empty()) == "dimension 1 far 0\n");
    CHECK(canonical(Region<3>::full()) == "dimension 3 far 1\n");
    CHECK(canonical(intervals({{Rational(1, 2), Rational(3)}})) == "dimension 1 far 0\n(-2|1*1)\n(1|-3*1)\n");
    CHECK(canonical(box<2>({0, 0}, {2, 1})) ==
          "dimension 2 far 0\n"
          "(-1 0|0:0-,1+)\n"
          "(0 -1|0:0-,2+)\n"
          "(0 1|-1:0-,2+)\n"
          "(1 0|-2:0-,1+)\n");
    CHECK(canonical(half_space(make_plane<Integer>(1, 0, -1))) == "dimension 2 far 0\n(1 0|-1:-inf-,inf+)\n");
    CHECK(canonical(box<3>({0, 0, 0}, {1, 1, 1}))
              .find("(0 0 1|-1(0 1|-1:0-,1+)(0 1|0:0+,1-)(1 0|-1:0-,1+)(1 0|0:0+,1-))") != std::string::npos);
}

TEST_CASE("canonical: faces in any number of pieces give the same bytes") {
    const Region<3> left = box<3>({0, 0, 0}, {1, 2, 2});
    const Region<3> right = box<3>({1, 0, 0}, {2, 2, 2});
    const Region<3> whole = box<3>({0, 0, 0}, {2, 2, 2});
    const Region<3> joined = left | right;
    CHECK(joined.face_count() > whole.face_count());  // four faces come from both halves
    CHECK(canonical(joined) == canonical(whole));
    const Region<3> hole = whole - box<3>({Rational(1, 2), Rational(1, 2), 0}, {1, 1, 2});
    const Region<3> filled = hole | box<3>({0, 0, 0}, {Rational(3, 2), Rational(3, 2), 2});
    CHECK(canonical(hole) != canonical(whole));
    CHECK(canonical(filled) == canonical(whole));
    CHECK(canonical(~~hole) == canonical(hole));
}

TEST_CASE("canonical: sets that differ only in where they lie have different bytes") {
    CHECK(canonical(box<2>({0, 0}, {1, 1})) != canonical(box<2>({0, 0}, {1, 2})));
    CHECK(canonical(box<2>({0, 0}, {1, 1})) != canonical(~box<2>({0, 0}, {1, 1})));
    CHECK(canonical(Region<2>::empty()) != canonical(Region<2>::full()));
    // Two squares that touch in a corner against the two others of the four.
    const Region<2> a = box<2>({0, 0}, {1, 1}) | box<2>({1, 1}, {2, 2});
    const Region<2> b = box<2>({0, 1}, {1, 2}) | box<2>({1, 0}, {2, 1});
    CHECK(canonical(a) != canonical(b));
    CHECK(canonical(a ^ b) == canonical(box<2>({0, 0}, {2, 2})));
}
