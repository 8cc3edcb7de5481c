// SPDX-License-Identifier: Apache-2.0
/// Which operands contain which vertices, found out patch by patch instead of vertex by vertex.
#ifndef CLEAVE_SETOP_PATCH_LABELS_HPP
#define CLEAVE_SETOP_PATCH_LABELS_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/base/contract.hpp>
#include <cleave/base/disjoint_sets.hpp>
#include <cleave/geometry/handles.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A patch is a set of vertices joined by edges that no operand meets, so all have one label: a bit for each operand
/// [Tarjan-1975]. Patches are linked by edges that only some operands meet; what is known of the others' bits holds on
/// both ends. First everything is said (`join`, `learn`, `link`), then `close` puts it together; later knowledge
/// (`tell`) spreads along the links at once.
class PatchLabels {
public:
    using Bits = BooleanFunction::Bits;

    explicit PatchLabels(std::size_t vertices) : sets_(vertices), patch_(vertices, no_id) {}

    /// The labels of vertices a and b are the same. May be said on several threads at once of vertices that are never
    /// joined with each other's.
    void join(std::uint32_t a, std::uint32_t b) {
        CLEAVE_REQUIRES(!closed_);
        sets_.join(a, b);
    }

    /// The bits `which` of vertex a's label are those of `value`.
    void learn(std::uint32_t a, Bits which, Bits value) {
        CLEAVE_REQUIRES(!closed_);
        if (which != 0) facts_.push_back({which, value, a});
    }

    /// The bits `which` of the labels of a and b are the same.
    void link(std::uint32_t a, std::uint32_t b, Bits which) {
        CLEAVE_REQUIRES(!closed_);
        if (which != 0) links_.push_back({which, {a, b}});
    }

    /// Ends the first stage.
    void close() {
        closed_ = true;
        for (const Fact& f : facts_) set(patch(f.vertex), f.which, f.value);
        for (Link& l : links_)
            for (std::uint32_t& end : l.end) end = patch(end);
        index_links();
        for (std::uint32_t p = 0; p < patches_.size(); ++p)
            if (patches_[p].known != 0) work_.push_back(p);
        spread();
        facts_ = {};
    }

    /// What is known of a label. Bits that are not known have the value 0.
    struct Label {
        Bits known = 0;
        Bits value = 0;
    };

    /// All about a's label. Requires, as for all that follows: closed.
    [[nodiscard]] const Label& at(std::uint32_t a) { return patches_[patch(a)]; }

    /// The bits of a's label that are known.
    [[nodiscard]] Bits known(std::uint32_t a) { return at(a).known; }

    /// The label of a; bits that are not known are 0.
    [[nodiscard]] Bits label(std::uint32_t a) { return at(a).value; }

    /// The bits `which` of vertex a's label are those of `value`.
    void tell(std::uint32_t a, Bits which, Bits value) {
        const std::uint32_t p = patch(a);
        set(p, which, value);
        if (!links_.empty()) {
            work_.push_back(p);
            spread();
        }
    }

    /// Whether nothing that was said contradicts what was said before. What contradicts has no effect.
    [[nodiscard]] bool is_consistent() const noexcept { return consistent_; }

private:
    struct Fact {
        Bits which, value;
        std::uint32_t vertex;
    };
    struct Link {
        Bits which;
        std::array<std::uint32_t, 2> end;
    };

    std::uint32_t patch(std::uint32_t a) {
        CLEAVE_REQUIRES(closed_);
        std::uint32_t& p = patch_[sets_.find(a)];
        if (p == no_id) {
            p = static_cast<std::uint32_t>(patches_.size());
            patches_.emplace_back();
        }
        return p;
    }

    /// Returns: whether anything is new.
    bool set(std::uint32_t p, Bits which, Bits value) {
        Label& label = patches_[p];
        if (((label.value ^ value) & which & label.known) != 0) consistent_ = false;
        const Bits fresh = which & ~label.known;
        label.value |= value & fresh;
        label.known |= fresh;
        return fresh != 0;
    }

    /// Lists each patch's links.
    void index_links() {
        if (links_.empty()) return;
        first_link_.assign(patches_.size() + 1, 0);
        for (const Link& l : links_)
            for (const std::uint32_t end : l.end) ++first_link_[end + 1];
        std::partial_sum(first_link_.begin(), first_link_.end(), first_link_.begin());
        std::vector<std::uint32_t> next(first_link_.begin(), first_link_.end() - 1);
        link_of_.resize(2 * links_.size());
        for (std::uint32_t l = 0; l < links_.size(); ++l)
            for (const std::uint32_t end : links_[l].end) link_of_[next[end]++] = l;
    }

    void spread() {
        while (!work_.empty()) {
            const std::uint32_t p = work_.back();
            work_.pop_back();
            if (p + 1 >= first_link_.size()) continue;  // no links
            for (std::uint32_t n = first_link_[p]; n < first_link_[p + 1]; ++n) {
                const Link& l = links_[link_of_[n]];
                const std::uint32_t other = l.end[0] == p ? l.end[1] : l.end[0];
                if (set(other, l.which & patches_[p].known, patches_[p].value)) work_.push_back(other);
            }
        }
    }

    DisjointSets sets_;
    std::vector<std::uint32_t> patch_;  // of the vertices that name sets
    std::vector<Label> patches_;
    std::vector<Fact> facts_;
    std::vector<Link> links_;  // between vertices, and between patches when closed
    std::vector<std::uint32_t> first_link_, link_of_;
    std::vector<std::uint32_t> work_;
    bool closed_ = false;
    bool consistent_ = true;
};

CLEAVE_END_NAMESPACE

#endif
