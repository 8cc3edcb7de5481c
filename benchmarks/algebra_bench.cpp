// SPDX-License-Identifier: Apache-2.0
// Determinants and minors by backend, size and width of the entries. Entries are random integers of the given number of
// bits without structure: no zeros, no common factors. Each timed body checks that the minors are orthogonal to a row,
// or that two forms of the determinant agree, on the first matrix.
#include <cleave/algebra.hpp>
#include <cleave/number/builtin.hpp>
#if defined(CLEAVE_HAS_GMP)
#include <cleave/number/gmp.hpp>
#endif
#if defined(CLEAVE_HAS_BOOST)
#include <cleave/number/boost_cpp.hpp>
#endif

#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <vector>

namespace {

using namespace cleave;

constexpr std::size_t matrix_count = 64;

template <ExactRing N>
N random_number(std::mt19937_64& engine, int bits) {
    Integer x = 0;
    for (int done = 0; done < bits; done += 32) x = (x << 32) + Integer(engine() >> 32);
    x >>= x.bit_length() > static_cast<std::size_t>(bits) ? x.bit_length() - static_cast<std::size_t>(bits) : 0;
    if ((engine() & 1) != 0) x.negate();
    return number_traits<N>::from_integer(x);
}

template <int Rows, int Columns, ExactRing N>
std::vector<Matrix<Rows, Columns, N>> random_matrices(int bits) {
    std::mt19937_64 engine(1);
    std::vector<Matrix<Rows, Columns, N>> matrices(matrix_count);
    for (auto& m : matrices) {
        for (int i = 0; i < Rows; ++i) {
            for (int j = 0; j < Columns; ++j) m(i, j) = random_number<N>(engine, bits);
        }
    }
    return matrices;
}

template <int D, class N, class R = N>
void minors_of(benchmark::State& state) {
    const auto matrices = random_matrices<D, D + 1, N>(static_cast<int>(state.range(0)));
    if (number_traits<R>::sign(dot<R>(minors<R>(matrices[0]), matrices[0].row[0])) != Sign::zero)
        state.SkipWithError("minors are not orthogonal to a row");
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(minors<R>(matrices[k]));
        k = (k + 1) % matrix_count;
    }
}

enum class Form { chosen, laplace, bareiss };

template <int D, class N, Form form, class R = N>
void determinant_of(benchmark::State& state) {
    const auto matrices = random_matrices<D, D, N>(static_cast<int>(state.range(0)));
    const auto compute = [](const Matrix<D, D, N>& m) -> R {
        if constexpr (form == Form::laplace) return determinant_laplace<R>(m);
        if constexpr (form == Form::bareiss) return determinant_bareiss<R>(m);
        return determinant<R>(m);
    };
    if (!(compute(matrices[0]) == determinant<R>(matrices[0])))
        state.SkipWithError("two forms of the determinant differ");
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(compute(matrices[k]));
        k = (k + 1) % matrix_count;
    }
}

// The plane through three points, the point on three planes (entries of 27, 56 and 114 bits).
BENCHMARK(minors_of<2, Integer>)->Arg(27)->Arg(60);
BENCHMARK(minors_of<3, Integer>)->Arg(27)->Arg(56)->Arg(114);
BENCHMARK(minors_of<3, Integer, WideInteger>)->Arg(27)->Arg(56)->Arg(114);
BENCHMARK(minors_of<3, FixedInt<64>, FixedInt<256>>)->Arg(27)->Arg(56);
BENCHMARK(minors_of<4, Integer>)->Arg(27)->Arg(56)->Arg(114);
#if defined(CLEAVE_HAS_GMP)
BENCHMARK(minors_of<3, mpz_class>)->Arg(27)->Arg(56)->Arg(114);
BENCHMARK(minors_of<3, mpq_class>)->Arg(27)->Arg(56);
BENCHMARK(minors_of<4, mpz_class>)->Arg(27)->Arg(56)->Arg(114);
#endif
#if defined(CLEAVE_HAS_BOOST)
BENCHMARK(minors_of<3, boost::multiprecision::cpp_int>)->Arg(27)->Arg(56)->Arg(114);
#endif

BENCHMARK(determinant_of<4, Integer, Form::chosen>)->Arg(27)->Arg(114);
BENCHMARK(determinant_of<4, FixedInt<256>, Form::chosen>)->Arg(27)->Arg(56);
#if defined(CLEAVE_HAS_GMP)
BENCHMARK(determinant_of<4, mpz_class, Form::chosen>)->Arg(27)->Arg(114);
#endif

// Where elimination overtakes expansion.
BENCHMARK(determinant_of<4, Integer, Form::laplace>)->Arg(27);
BENCHMARK(determinant_of<4, Integer, Form::bareiss>)->Arg(27);
BENCHMARK(determinant_of<5, Integer, Form::laplace>)->Arg(27)->Arg(114);
BENCHMARK(determinant_of<5, Integer, Form::bareiss>)->Arg(27)->Arg(114);
BENCHMARK(determinant_of<6, Integer, Form::laplace>)->Arg(27)->Arg(114);
BENCHMARK(determinant_of<6, Integer, Form::bareiss>)->Arg(27)->Arg(114);
BENCHMARK(determinant_of<7, Integer, Form::laplace>)->Arg(27)->Arg(114);
BENCHMARK(determinant_of<7, Integer, Form::bareiss>)->Arg(27)->Arg(114);
BENCHMARK(determinant_of<8, Integer, Form::laplace>)->Arg(27)->Arg(114);
BENCHMARK(determinant_of<8, Integer, Form::bareiss>)->Arg(27)->Arg(114);
#if defined(CLEAVE_HAS_GMP)
BENCHMARK(determinant_of<7, mpz_class, Form::laplace>)->Arg(27)->Arg(114);
BENCHMARK(determinant_of<7, mpz_class, Form::bareiss>)->Arg(27)->Arg(114);
#endif

}  // namespace

BENCHMARK_MAIN();
