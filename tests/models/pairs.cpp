// SPDX-License-Identifier: Apache-2.0
/// The four operations on pairs of real meshes: measure identities hold exactly, results are closed and conforming, and
/// a result is an operand again.
#include <cleave/io/mesh_file.hpp>
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/setop/operators.hpp>

#include "support/catch.hpp"
#include "support/model_pairs.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// Volumes that are compared: modulo two primes, and as fractions where the operands are small.
struct Volume {
    Mod61 first;
    Modular<second_prime> second;
    Rational exact;

    friend Volume operator+(const Volume& a, const Volume& b) {
        return {a.first + b.first, a.second + b.second, a.exact + b.exact};
    }
    friend Volume operator-(const Volume& a, const Volume& b) {
        return {a.first - b.first, a.second - b.second, a.exact - b.exact};
    }
    friend bool operator==(const Volume& a, const Volume& b) {
        return a.first == b.first && a.second == b.second && a.exact == b.exact;
    }
};

Volume volume(const Region<3>& region, bool exactly) {
    const auto first = measure_modulo<first_prime>(region);
    const auto second = measure_modulo<second_prime>(region);
    REQUIRE(first.has_value());
    REQUIRE(second.has_value());
    return {*first, *second, exactly ? *measure(region) : Rational(0)};
}

/// Checks the exported mesh of a result. The rounded form is compared as a closed surface only: rounding may make faces
/// cross, which the exact form cannot.
void check_export(const Region<3>& region, bool exactly) {
    const MeshReport rounded = validate(to_mesh(region));
    CHECK(rounded.is_closed());
    CHECK(rounded.t_junctions.empty());
    if (!exactly) return;
    const RationalMesh exact = to_rational_mesh(region);
    const MeshReport report = validate(exact);
    CHECK(report.is_valid(Strictness::strict));
    CHECK(report.t_junctions.empty());
    const Region<3> back = exact.face_count() == 0 ? Region<3>() : to_region(exact);
    CHECK(*measure_modulo(back) == *measure_modulo(region));
}

void check_pair(const Model& one, const Model& two) {
    INFO(one.name << " and " << two.name);
    const bool exactly = std::max(one.mesh.face_count(), two.mesh.face_count()) <= 1300;
    const Region<3> a = to_region(one.mesh);
    const Region<3> b = to_region(placed(one.mesh, two.mesh));
    const Region<3> both = a & b;
    const Region<3> any = a | b;
    const Region<3> only_a = a - b;
    const Region<3> only_b = b - a;
    const Region<3> odd = a ^ b;
    const Volume va = volume(a, exactly);
    const Volume vb = volume(b, exactly);
    const Volume v_both = volume(both, exactly);
    CHECK(va + vb == volume(any, exactly) + v_both);
    CHECK(volume(only_a, exactly) == va - v_both);
    CHECK(volume(only_b, exactly) == vb - v_both);
    CHECK(volume(odd, exactly) == va + vb - v_both - v_both);
    // Results are operands: what the difference took away, put back.
    CHECK(volume(only_a | both, exactly) == va);
    CHECK((only_a & b).is_empty());
    CHECK(((only_a | only_b) ^ odd).is_empty());
    for (const Region<3>* r : {&both, &any, &only_a, &odd}) check_export(*r, exactly);
}

}  // namespace

TEST_CASE("pairs of real meshes: exact identities and closed results") {
    if (!models_dir()) CLEAVE_SKIP("CLEAVE_MODELS_DIR is not set");
    // CLEAVE_ALL_PAIRS=1: every pair; otherwise each model with the next two in size.
    const std::vector<Model> models = models_up_to(*models_dir(), all_pairs() ? 6000 : scaled(6000));
    REQUIRE(models.size() > 3);
    for_each_pair(models, check_pair);
}

TEST_CASE("real meshes: the known pairs of other libraries' tests") {
    if (!models_dir()) CLEAVE_SKIP("CLEAVE_MODELS_DIR is not set");
    const auto model = [](const char* name) {
        return to_region(read_mesh(*models_dir() / (std::string(name) + ".off")));
    };
    // A cube rounded by a sphere and drilled along the axes.
    const Region<3> rounded = model("cube_12") & model("sphere_760");
    const Region<3> drilled = rounded - model("xcylinder_80") - model("ycylinder_80") - model("zcylinder_80");
    const Region<3> drills = model("xcylinder_80") | model("ycylinder_80") | model("zcylinder_80");
    CHECK(*measure(drilled) == *measure(rounded - drills));
    CHECK((drilled ^ (rounded - drills)).is_empty());
    const std::array<std::pair<const char*, const char*>, 2> pairs{
        {{"offset3_56", "offset4_76"}, {"havocglass8_left_164", "havocglass8_right_12"}}};
    for (const auto& pair : pairs) {
        const Region<3> a = model(pair.first);
        const Region<3> b = model(pair.second);
        CHECK(*measure(a) + *measure(b) == *measure(a | b) + *measure(a & b));
        CHECK(validate(to_mesh(a | b)).is_closed());
    }
}
