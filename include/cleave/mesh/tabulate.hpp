// SPDX-License-Identifier: Apache-2.0
/// `tabulate`: a vector of the values of a function.
#ifndef CLEAVE_MESH_TABULATE_HPP
#define CLEAVE_MESH_TABULATE_HPP

#include <cleave/base/config.hpp>
#include <cleave/execution/chunks.hpp>
#include <cleave/execution/executor.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// What a vector is made from: as much of a random access iterator as its constructor asks for.
template <class F>
class TableIterator {
public:
    using value_type = std::invoke_result_t<const F&, std::size_t>;
    using reference = value_type;
    using pointer = void;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::random_access_iterator_tag;

    TableIterator(const F& f, std::size_t i) : f_(&f), i_(i) {}

    reference operator*() const { return (*f_)(i_); }
    TableIterator& operator++() {
        ++i_;
        return *this;
    }
    TableIterator& operator+=(difference_type n) {
        i_ += static_cast<std::size_t>(n);
        return *this;
    }
    friend TableIterator operator+(TableIterator a, difference_type n) { return a += n; }
    friend difference_type operator-(const TableIterator& a, const TableIterator& b) {
        return static_cast<difference_type>(a.i_ - b.i_);
    }
    friend bool operator==(const TableIterator& a, const TableIterator& b) { return a.i_ == b.i_; }
    friend bool operator!=(const TableIterator& a, const TableIterator& b) { return a.i_ != b.i_; }

private:
    const F* f_;
    std::size_t i_;
};

}  // namespace detail

/// The values f(0), ..., f(n - 1), in a std::vector unless another list is named. Cost: each is written once; to resize
/// a vector and then to assign would write twice, to append would ask each time whether there is room.
template <template <class...> class List = std::vector, class F>
[[nodiscard]] auto tabulate(std::size_t n, const F& f) {
    using Iterator = detail::TableIterator<F>;
    return List<typename Iterator::value_type>(Iterator(f, 0), Iterator(f, n));
}

/// The same, the values asked for in any order or at once. Requires: a default value can be made, and is not bool.
template <template <class...> class List = std::vector, Executor E, class F>
[[nodiscard]] auto tabulate(const E& executor, std::size_t n, const F& f) {
    constexpr std::size_t grain = std::size_t(1) << 13U;
    if (executor.concurrency() == 1 || n <= grain) return tabulate<List>(n, f);
    using Value = std::invoke_result_t<const F&, std::size_t>;
    static_assert(!std::is_same_v<Value, bool>, "neighbours of std::vector<bool> cannot be written at once");
    List<Value> values(n);
    for_each_chunk(executor, n, grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end; ++i) values[i] = f(i);
    });
    return values;
}

CLEAVE_END_NAMESPACE

#endif
