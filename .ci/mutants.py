#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Named defects that some test must find.

Each mutant changes one place of one header in a copy of include/, compiles one test file against the copy, and runs it.
The mutant is killed if the test fails; it survives, and this script fails, if the test passes. A mutant whose text is no
longer there, or whose test does not compile, is an error too: mutants follow the code.

    .ci/mutants.py [--jobs N] [NAME...]

Needs what tests/run.sh needs, and its build of the test framework (made if it is missing). About half a minute each.
"""
import argparse
import concurrent.futures
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "dev"
FLAGS = ["-std=c++20", "-O1", "-w", "-DCLEAVE_WITH_GMP", "-DCLEAVE_WITH_BOOST", "-DCLEAVE_PARTS_CHOSEN",
         "-DCLEAVE_INSTANTIATE", "-DCLEAVE_INSTANTIATE_CHECKERS"]

# name: (header, text, replacement, test)
MUTANTS = {
    "polytope: a new vertex does not know the cut": (
        "clip/polytope.hpp", "if (at == with_.end() || *at != k) with_.insert(at, k);", "(void)at;",
        "unit/clip/polytope.cpp"),
    "polytope: any two vertices with enough planes span an edge": (
        "clip/polytope.hpp",
        "if (std::includes(own.begin(), own.end(), shared.begin(), shared.end())) return false;", "",
        "unit/clip/polytope.cpp"),
    "polytope: touching counts as crossing": (
        "clip/polytope.hpp", "above = above || signs_[i] == Sign::plus;", "above = above || signs_[i] != Sign::minus;",
        "unit/clip/polytope.cpp"),
    "polytope: a line is the first planes through it, independent or not": (
        "clip/polytope.hpp", "if (D <= 3 || through.size() + 1 == std::size_t(D)) {", "if (true) {",
        "unit/clip/polytope.cpp"),
    "polytope: an edge in the cut is forgotten": (
        "clip/polytope.hpp", "add_edge(s.lid, lid_[i], lid_[j]);", "", "unit/clip/polytope.cpp"),
    "kernel: the factor of R decides nothing": (
        "geometry/kernel.hpp", "if (const Sign s = side_at_infinity(k, p); s != Sign::zero) return s;", "",
        "unit/clip/polytope.cpp"),
    "kernel: points at infinity are compared by their finite parts": (
        "geometry/kernel.hpp", "if (const Sign s = compare_reach(i, p, q); s != Sign::zero) return s;", "",
        "unit/region/convex.cpp"),
    "kernel: the filter's bound forgets rounding": (
        "geometry/kernel.hpp", "bound = magnitude * (double(D + 6) * unit)", "bound = magnitude * (0 * unit)",
        "unit/geometry/kernel.cpp"),
    "merge: a reduced cell passes for a whole one": (
        "bsp/merge.hpp", "t.whole_a && by_a, t.whole_b && !by_a", "t.whole_a, t.whole_b", "unit/bsp/merge.cpp"),
    "merge: a cut that misses the cell is left on the wrong side": (
        "bsp/merge.hpp", "t.b = b_.child(t.b, s == FacetSide::minus ? ChildSide::minus : ChildSide::plus);",
        "t.b = b_.child(t.b, s == FacetSide::minus ? ChildSide::plus : ChildSide::minus);", "unit/bsp/merge.cpp"),
    "trim: a cut goes without a comparison": (
        "bsp/trim.hpp", "if (agree(plus, minus, v.minus)) {", "if (plus.is_node()) {", "unit/bsp/trim.cpp"),
    "boundary: facets face as their cut does": (
        "bsp/tree_boundary.hpp", "facets.push_back(below ? f : model.flip(f));", "facets.push_back(f);",
        "unit/bsp/cells.cpp"),
    "boundary: only one subtree is asked": (
        "bsp/tree_boundary.hpp", "const bool low = pieces_[i].below.is_node();",
        "const bool low = pieces_[i].below.is_node(); if (!low) { while (pieces_[i].above.is_node()) "
        "pieces_[i].above = tree_.minus(pieces_[i].above); }", "unit/region/convex.cpp"),
    "complement: the far point keeps its value": (
        "region/region.hpp", "b.value_at_infinity = !b.value_at_infinity;", "", "unit/region/convex.cpp"),
    "convex: a repeated plane gives a repeated face": (
        "region/convex.hpp", "!= cuts.begin() + std::ptrdiff_t(i))\n            continue;",
        "!= cuts.begin() + std::ptrdiff_t(i)) {}",
        "unit/region/convex.cpp"),
    "canonical: pieces are counted without their signs": (
        "region/canonical.hpp", "ends.emplace_back(p, -sign);", "ends.emplace_back(p, sign);",
        "unit/region/canonical.cpp"),
    "filter: facing the same way counts as facing the opposite way": (
        "setop/boundary_filter.hpp", "case Coverage::same:\n                    l.below |= bit;",
        "case Coverage::same:\n                    l.above |= bit;", "unit/region/canonical.cpp"),
    "filter: coincident pieces come from both operands": (
        "setop/boundary_filter.hpp", "spread(leaf, j, j < i);", "spread(leaf, j, false);", "property/engines.cpp"),
    "separated operands: the second is below the first, and nobody says so": (
        "setop/tree_evaluation.hpp", "return a_first ? h : flipped(h);", "return h;", "unit/setop/separated.cpp"),
    "separated operands: boxes that touch count as apart": (
        "setop/tree_evaluation.hpp", "if (!(lo < middle && middle < hi)) continue;", "if (!(lo <= hi)) continue;",
        "unit/setop/separated.cpp"),
    "transform: a reflection leaves loops as they are": (
        "region/transform.hpp", "if (mirrored) reverse_loop<D>(loop);", "", "property/transforms.cpp"),
    "transform: a reflected half-line keeps its infinity": (
        "region/transform.hpp", "if (D == 1 && mirrored && list.faces.size() % 2 != 0) far = !far;", "",
        "property/transforms.cpp"),
    "label forest: what was known of a joined set is lost": (
        "setop/label_forest.hpp", "known_[root] = Bits(known_[root] | known_[child]);", "",
        "unit/setop/label_forest.cpp"),
    "patch labels: a link carries all bits": (
        "setop/patch_labels.hpp", "l.which & patches_[p].known", "patches_[p].known", "unit/setop/patch_labels.cpp"),
    "noding: segments of two operands that cross are not cut": (
        "setop/segment_noding.hpp", "return a.operand[1 - a_slot] != b.operand[1 - b_slot] ||", "return",
        "unit/setop/several_operands.cpp"),
    "pieces: a ridge tells about what runs in the plane of its face": (
        "setop/surface_cutter.hpp", "(!in_plane && !is_in_coplanar(j, x))", "!is_in_coplanar(j, x)",
        "unit/setop/several_operands.cpp"),
    "pieces: a ridge tells about what runs in a face that it stands on": (
        "setop/surface_cutter.hpp", "(!in_plane && !is_in_coplanar(j, x))", "!in_plane",
        "unit/setop/several_operands.cpp"),
    "pieces: a label spreads through the cuts of its operand": (
        "setop/surface_cutter.hpp", "known &= ~on_[at];", "", "unit/setop/several_operands.cpp"),
    "labels: a piece in a coplanar face is located like any other": (
        "setop/surface_labels.hpp", "if (!cover_(r.operand, r.other, middle)) continue;", "continue;",
        "unit/setop/several_operands.cpp"),
    "conforming: vertices on edges stay out": (
        "region/conforming.hpp", "conformer.for_each_edge(l, [&](PointId from, PointId, std::uint32_t corner) {",
        "conformer.for_each_edge(l, [&](PointId from, PointId, std::uint32_t corner) {\n"
        "                if (from != boundary.faces.corners[corner].point) return;",
        "unit/region/conforming.cpp"),
    "surface: a face in several pieces has one label": (
        "setop/surface_evaluation.hpp", "if (has_one_label(i, f, inside)) {", "if (true) {", "unit/setop/surface_evaluation.cpp"),
    "surface: what both operands have comes from both": (
        "setop/surface_evaluation.hpp", "if (((s.above ^ s.below) & (own - 1)) != 0) return Action::drop;", "",
        "unit/setop/surface_evaluation.cpp"),
    "surface: segments that overlap are not cut": (
        "setop/segment_noding.hpp", "return (c.corner[0] == no_id) != (c.corner[1] == no_id);",
        "return c.operand[0] == no_id;",
        "unit/setop/surface_evaluation.cpp"),
    "surface: a point where the other boundary touches itself tells by one face": (
        "setop/contact_sides.hpp",
        "return std::nullopt;  // where the other boundary touches itself, one face does not tell all", "continue;",
        "unit/setop/surface_evaluation.cpp"),
    "surface: a reflex ridge passes for a convex one": (
        "setop/contact_sides.hpp", "return bend == Sign::minus ? both : either;", "return both;",
        "unit/setop/surface_evaluation.cpp"),
    "planar: a common stretch ends where the other operand touches itself": (
        "setop/planar_labels.hpp", "if (b.coincides != no_id) {", "if (false) {", "unit/setop/planar_evaluation.cpp"),
    "planar: a ray has its operand on the other side": (
        "setop/planar_labels.hpp", "found.inside = !first.along;", "found.inside = first.along;",
        "unit/setop/planar_evaluation.cpp"),
    "planar: not the first ray tells but the last": (
        "setop/planar_labels.hpp", "side(a.line, b.far) == (a.along ? Sign::minus : Sign::plus)",
        "side(a.line, b.far) == (a.along ? Sign::plus : Sign::minus)", "unit/setop/planar_evaluation.cpp"),
    "planar: coincident pieces come from every operand": (
        "setop/planar_evaluation.hpp", "if (((p.same | p.opposite) & (own - 1)) != 0) return Action::drop;", "",
        "unit/setop/planar_evaluation.cpp"),
    "planar: a ray through a vertex passes both segments there": (
        "setop/planar_location.hpp", "kernel.compare(0, s.to, p) != Sign::plus", "kernel.compare(0, s.to, p) == Sign::minus",
        "property/planar.cpp"),
    "planar: an end on another segment keeps its own name": (
        "setop/planar_contacts.hpp", "return place_[p] = points_(p);", "return points_(p);",
        "unit/setop/planar_evaluation.cpp"),
    "segment pairs: errors of the ends are forgotten": (
        "geometry/segment_pairs.hpp", "4 * s.error + ", "", "unit/geometry/segment_pairs.cpp"),
    "double predicates: the bound of an orientation forgets rounding": (
        "geometry/double_predicates.hpp", "const double bound = 16 * 0x1p-53 * size", "const double bound = 0 * size",
        "unit/geometry/double_predicates.cpp"),
    "facet meeting: triangles at a common corner run the same way": (
        "region/facet_meeting.hpp", "return p * u == Sign::plus ? MeetingKind::shared : MeetingKind::crossing;",
        "return MeetingKind::crossing;", "unit/mesh/self_intersections.cpp"),
    "facet meeting: the lone corner's side does not order a triangle's ends": (
        "region/facet_meeting.hpp", "const bool b_rises = u == Sign::plus;", "const bool b_rises = u == Sign::minus;",
        "unit/mesh/self_intersections.cpp"),
    "facet meeting: edges inside a face are edges like others": (
        "region/facet_meeting.hpp", "if (own == 2 && is_inner_to_one(f, e, g)) return std::nullopt;", "",
        "unit/mesh/self_intersections.cpp"),
    "facet pieces: a cut leaves segments on the side where they start": (
        "region/facet_pieces.hpp", "(a == Sign::minus ? plus : minus).push_back({x, s.to, s.plane});", "(void)x;",
        "unit/region/facet_pieces.cpp"),
    "facet winding: a ray starts where another facet touches": (
        "region/facet_winding.hpp", "if (!above) continue;", "if (!above && attempt > 0) continue;",
        "unit/region/facet_winding.cpp"),
    "facet winding: ties are not broken along the second axis": (
        "region/facet_winding.hpp", "const bool b_below = compare(view.v, b) != Sign::plus;",
        "const bool b_below = compare(view.v, b) == Sign::minus;", "unit/region/facet_winding.cpp"),
    "edge buckets: an edge is not told from its opposite": (
        "mesh/edge_buckets.hpp",
        "difference[b] += Four(x[b] == (bucket[j] ^ 1U)) - Four(x[b] == bucket[j]);", "",
        "unit/mesh/edge_buckets.cpp"),
    "edge buckets: large ones pass for balanced": (
        "mesh/edge_buckets.hpp", "off |= balanced_by_sorting({bucket, n}) ? 0U : 1U;", "",
        "unit/mesh/edge_buckets.cpp"),
    "resolve: edges along which a third facet runs do not part surfaces": (
        "region/resolve.hpp", "if (mate_[c] != no_id && !touched_[c] && !is_cut(mate_[c]))", "if (mate_[c] != no_id)",
        "unit/mesh/resolve.cpp"),
    "resolve: facets that overlap do not cut each other": (
        "region/resolve.hpp", "cut_along_edges(b, a);", "", "unit/mesh/resolve.cpp"),
    "resolve: pieces that coincide are all kept": (
        "region/resolve.hpp", "|| sides.first != f) return Fate::drop;", ") return Fate::drop;",
        "unit/mesh/resolve.cpp"),
    "resolve: collinear segments do not count together": (
        "region/resolve_segments.hpp", "step += segments_[g].line == line ? 1 : -1;", "", "unit/region/resolve.cpp"),
    "resolve segments: a ray from the far side counts what covers its own piece": (
        "region/resolve_segments.hpp", "== Sign::plus ? above : above - step;", "== Sign::plus ? above : above;",
        "unit/region/resolve_segments.cpp"),
    "resolve segments: the middle of a piece is where doubles put it": (
        "region/resolve_segments.hpp",
        "if (after != Sign::zero && after == kernel_.compare(int(u), p, piece.to.point)) return p;", "return p;",
        "unit/region/resolve_segments.cpp"),
    "resolve segments: winding numbers pass through crossings": (
        "region/resolve_segments.hpp", "if (j - i == 2 && ends", "if (j - i >= 2 && ends",
        "unit/region/resolve_segments.cpp"),
    "plane in words: what faces the other way is not turned": (
        "geometry/double_plane.hpp", "c[k].negative = c[k].negative != plane.is_flipped;", "",
        "unit/geometry/double_plane.cpp"),
    "plane in words: common powers of two stay": (
        "geometry/double_plane.hpp", "zeros = std::min(zeros, c[k].trailing_zeros() + shift);", "zeros = 0;",
        "unit/geometry/double_plane.cpp"),
    "crossings: all faces that an edge crosses are one": (
        "setop/crossing_table.hpp", "entries_[at].key != key", "entries_[at].key.edge != key.edge",
        "unit/setop/crossing_table.cpp"),
    "face pairs: the upper half gets what the lower half meets": (
        "setop/face_pairs.hpp", "if (!box.box.disjoint(upper.bounds)) copy.push_back(box);",
        "if (!box.box.disjoint(lower.bounds)) copy.push_back(box);", "unit/setop/face_pairs.cpp"),
    "face pairs: touching is lying apart": (
        "setop/face_pairs.hpp", "return signs != 0 && signs != all_plus;",
        "return (signs & 0b101010U) != signs && (signs & 0b101010U) != 0;", "unit/setop/face_pairs.cpp"),
    "grid meet: coefficients of any length pass": (
        "geometry/grid_meet.hpp", "if (v > most || v < -most) return std::nullopt;", "(void)most;",
        "unit/geometry/grid_meet.cpp"),
    "grid meet: what is no double is rounded": (
        "geometry/grid_meet.hpp", "if (x >= UInt128(1) << 53U) return std::nullopt;  // odd, so no shorter", "",
        "unit/geometry/grid_meet.cpp"),
    "grid meet: a remainder is dropped": (
        "geometry/grid_meet.hpp", "if (x % y != 0) return std::nullopt;", "", "unit/geometry/grid_meet.cpp"),
    "build: a plane across an edge faces any way": (
        "region/build.hpp", "return same_way ? plane : flipped(plane);", "return plane;", "unit/region/build.cpp"),
    "result: a vertex that is a common point has two numbers": (
        "setop/surface_result.hpp", "            points_[own] = no_id;\n", "", "unit/setop/surface_evaluation.cpp"),
    "triangles: two points of a line and any third are straight": (
        "mesh/boundary_triangles.hpp", "of_q.contain(k) && of_r.contain(k)", "of_q.contain(k)",
        "unit/mesh/from_region.cpp"),
    "expression: of an odd number of parts the last one is forgotten": (
        "setop/expression.hpp", "if (regions.size() % 2 == 1) next.push_back(regions.back());", "",
        "unit/setop/expression.cpp"),
    "hull: its facets are left in the polar's coordinates": (
        "shape/polar_hull.hpp", "c[std::size_t(D)] -= c[axis] * centre_[axis];", "", "unit/query/representation.cpp"),
}


def check(name, scratch):
    """None where the mutant is killed, a reason otherwise."""
    header, old, new, test = MUTANTS[name]
    folder = Path(tempfile.mkdtemp(dir=scratch))
    include = folder / "include"
    shutil.copytree(ROOT / "include", include)
    path = include / "cleave" / header
    text = path.read_text(encoding="utf-8")
    if text.count(old) != 1:
        return f"its text is {text.count(old)} times in {header}"
    path.write_text(text.replace(old, new), encoding="utf-8")
    program = folder / "test"
    compiler = os.environ.get("CXX", "c++")
    # Only the framework comes compiled; what is tested is compiled here, from the copy.
    command = [compiler, *FLAGS, f"-I{include}", f"-I{ROOT / 'tests'}", str(ROOT / "tests" / test),
               str(BUILD / "tests" / "libcleave_test_main.a"), "-o", str(program), "-lrapidcheck", "-lgmpxx", "-lgmp"]
    if list((BUILD / "tests").glob("libCatch2*")):
        command.append("-lCatch2")
    built = subprocess.run(command, capture_output=True, text=True)
    if built.returncode != 0:
        return "its test does not compile:\n" + built.stderr[:2000]
    try:
        ran = subprocess.run([program], capture_output=True, timeout=300, cwd=folder)
    except subprocess.TimeoutExpired:
        return None
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return f"{test} passes with it" if ran.returncode == 0 else None


def main():
    parser = argparse.ArgumentParser(description="Checks that tests find named defects.")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("names", nargs="*", help="parts of names; all mutants where none is given")
    arguments = parser.parse_args()
    chosen = [n for n in MUTANTS if not arguments.names or any(part in n for part in arguments.names)]
    if not (BUILD / "tests" / "libcleave_test_main.a").is_file():
        subprocess.run(["cmake", "--preset", "dev"], cwd=ROOT, check=True)
        subprocess.run(["cmake", "--build", "--preset", "dev", "--target", "cleave_test_main"], cwd=ROOT, check=True)
    survivors = 0
    with tempfile.TemporaryDirectory() as scratch, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for name, reason in zip(chosen, pool.map(lambda n: check(n, scratch), chosen)):
            print(f"{'killed' if reason is None else 'ALIVE '}  {name}" + (f": {reason}" if reason else ""), flush=True)
            survivors += reason is not None
    print(f"mutants: {len(chosen)}, {survivors} alive")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
