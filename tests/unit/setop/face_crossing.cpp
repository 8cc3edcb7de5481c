// SPDX-License-Identifier: Apache-2.0
#include <cleave/setop/face_crossing.hpp>
//
#include <cleave/mesh/to_region.hpp>
#include <cleave/region/region.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/simplex.hpp>

#include "support/catch.hpp"
#include "support/exact_region.hpp"

#include <array>
#include <string>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// Two boundaries in one kernel.
class Pair {
public:
    Pair(const Region<3>& a, const Region<3>& b) : regions_{a, b} {
        for (std::size_t i = 0; i < 2; ++i) loaded_[i] = load(regions_[i].boundary(), kernel_);
    }

    /// The face of an operand on the plane n . x + c = 0, facing along n.
    [[nodiscard]] LoadedFace<3> face(std::size_t i, const std::array<int, 4>& plane) {
        typename PlaneTable<3>::Coefficients c;
        for (std::size_t k = 0; k < 4; ++k) c[k] = Integer(plane[k]);
        const PlaneId h = kernel_.planes.intern(c);
        const auto& faces = regions_[i].boundary().faces.faces;
        for (std::uint32_t f = 0; f < faces.size(); ++f)
            if (loaded_[i].plane(faces[f].plane) == h) return {&regions_[i].boundary(), &loaded_[i], f};
        throw Defect("there is no such face");
    }

    FaceMeeting meet(const std::array<int, 4>& f, const std::array<int, 4>& h) {
        const LoadedFace<3> a = face(0, f);
        const LoadedFace<3> b = face(1, h);
        const FaceMeeting meeting = crossing_.meet(a, box(a), b, box(b));
        // The same pair the other way round meets in the same way, and in as many segments.
        const std::size_t ends = meeting == FaceMeeting::crossing ? crossing_.ends().size() : 0;
        CHECK(crossing_.meet(b, box(b), a, box(a)) == meeting);
        if (meeting == FaceMeeting::crossing) CHECK(crossing_.ends().size() == ends);
        return crossing_.meet(a, box(a), b, box(b));
    }

    /// The ends as text, those of the first face's edges marked with a star.
    [[nodiscard]] std::string ends() {
        std::string out;
        for (const auto& e : crossing_.ends()) {
            const auto& x = kernel_.exact(e.point);
            out += out.empty() ? "" : " ";
            for (std::size_t i = 0; i < 3; ++i) {
                const Fraction f = make_fraction(x[i], x[3]);
                out += (i == 0 ? "" : ",") + f.num.to_string() + (f.den == Integer(1) ? "" : "/" + f.den.to_string());
            }
            if (e.of_first) out += "*";
        }
        return out;
    }

private:
    static Bounds<3> box(const LoadedFace<3>& f) {
        Bounds<3> b;
        f.for_each_edge([&](std::uint32_t, PointId p, PointId) {
            const PointRecord<3>& r = f.boundary->points[p - f.loaded->first_point];
            b.include(r.approximation, r.error);
        });
        return b;
    }

    std::array<Region<3>, 2> regions_;
    std::array<LoadedBoundary<3>, 2> loaded_;
    Kernel<3> kernel_;
    FaceCrossing<3> crossing_{kernel_};
};

}  // namespace

TEST_CASE("face crossing: two squares cross in a segment; its ends come in order, each with its edge") {
    // The top z = 4 of a block and the wall x = 3 of another, whose y overlap in (1, 4) and z in (2, 4).
    Pair pair(box<3>({0, 0, 0}, {4, 4, 4}), box<3>({3, 1, 2}, {7, 6, 6}));
    REQUIRE(pair.meet({0, 0, 1, -4}, {-1, 0, 0, 3}) == FaceMeeting::crossing);
    // Facing up with the wall's inside x > 3 on the left: towards negative y.
    CHECK(pair.ends() == "3,4,4* 3,1,4");
    REQUIRE(pair.meet({1, 0, 0, -4}, {0, 0, -1, 2}) == FaceMeeting::crossing);
    CHECK(pair.meet({-1, 0, 0, 0}, {-1, 0, 0, 3}) == FaceMeeting::none);
    CHECK(pair.meet({0, 0, -1, 0}, {-1, 0, 0, 3}) == FaceMeeting::none);
}

TEST_CASE("face crossing: faces with holes and hollows cross in several segments") {
    const Region<3> frame = box<3>({0, 0, 0}, {9, 9, 2}) - box<3>({3, 3, 0}, {6, 6, 2});
    Pair pair(frame, box<3>({1, 4, 1}, {8, 5, 3}));
    // The frame's top against the bar's side y = 4: through the frame on both sides of the hole.
    REQUIRE(pair.meet({0, 0, 1, -2}, {0, -1, 0, 4}) == FaceMeeting::crossing);
    CHECK(pair.ends() == "1,4,2 3,4,2* 6,4,2* 8,4,2");
}

TEST_CASE("face crossing: whatever touches is special, unless it is elsewhere in the plane") {
    const Region<3> cube = box<3>({0, 0, 0}, {4, 4, 4});
    {
        Pair pair(cube, box<3>({4, 1, 1}, {6, 3, 3}));  // a wall on a wall
        CHECK(pair.meet({1, 0, 0, -4}, {-1, 0, 0, 4}) == FaceMeeting::special);
        CHECK(pair.meet({1, 0, 0, -4}, {0, -1, 0, 1}) == FaceMeeting::special);  // an edge on a face
        CHECK(pair.meet({0, 0, 1, -4}, {0, -1, 0, 1}) == FaceMeeting::none);
    }
    {
        Pair pair(cube, box<3>({2, 2, 2}, {4, 6, 6}));  // two edges cross where x = 4
        CHECK(pair.meet({0, 0, 1, -4}, {1, 0, 0, -4}) == FaceMeeting::special);
        CHECK(pair.meet({0, 0, 1, -4}, {0, -1, 0, 2}) == FaceMeeting::special);
        CHECK(pair.meet({0, 0, 1, -4}, {-1, 0, 0, 2}) == FaceMeeting::crossing);
        CHECK(pair.ends() == "2,4,4* 2,2,4");
    }
    {
        Pair pair(cube, simplex<3>({{{2, 2, 4}, {1, 1, 7}, {3, 1, 7}, {2, 4, 7}}}));  // a vertex on a face
        CHECK(pair.meet({0, 0, 1, -4}, {0, -3, -1, 10}) == FaceMeeting::special);
        CHECK(pair.meet({1, 0, 0, -4}, {0, -3, -1, 10}) == FaceMeeting::none);
    }
    {
        // Its vertex is in the plane of the top, far from it: boxes tell.
        Pair pair(cube, simplex<3>({{{12, 2, 4}, {11, 1, 7}, {13, 1, 7}, {12, 4, 7}}}));
        CHECK(pair.meet({0, 0, 1, -4}, {0, -3, -1, 10}) == FaceMeeting::none);
    }
}
