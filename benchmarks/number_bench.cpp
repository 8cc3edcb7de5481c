// SPDX-License-Identifier: Apache-2.0
// What exact arithmetic costs, by number type and width.
//
// Input: 256 tuples of random integers of exactly the given number of bits, random signs (so that no branch on a sign
// is predictable). Every benchmark compares its answers with GMP's before it is timed and fails if one differs. Besides
// the time, `faster_than_mpz` is GMP's time for the same inputs over this one's, both the least of many runs in this
// process; GMP is given its best form: results and temporaries allocated once and reused, mpz_submul instead of a
// product and a difference. `mpz_fresh` is the same with temporaries made for each call, as straightforward code has
// them.
//
//   operation/bits/type      add, multiply, minor (a d - b c), gcd, exact_divide
//   plane_determinant/...    the sign of four planes' determinant: three planes' point against a fourth
#include <cleave/number/fixed_int_determinant.hpp>
#include <cleave/number/integer.hpp>

#include <benchmark/benchmark.h>
#include <gmpxx.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

using namespace cleave;

namespace {

namespace mp = boost::multiprecision;

template <unsigned Bits>
using FixedCppInt = mp::number<mp::cpp_int_backend<Bits, Bits, mp::signed_magnitude, mp::unchecked, void>, mp::et_off>;

constexpr std::size_t tuples = 256;

/// Nanoseconds a call: the least of many batches, which on a busy machine is the least wrong.
template <class Body>
double least_nanoseconds(Body&& body) {
    using Clock = std::chrono::steady_clock;
    const auto budget = std::chrono::milliseconds(std::getenv("CLEAVE_SMOKE") != nullptr ? 1 : 100);
    const auto start = Clock::now();
    double least = 1e300;
    do {
        const auto begin = Clock::now();
        for (std::size_t i = 0; i < tuples; ++i) body(i);
        const std::chrono::duration<double, std::nano> taken = Clock::now() - begin;
        least = std::min(least, taken.count() / double(tuples));
    } while (Clock::now() - start < budget);
    return least;
}

/// GMP's time for an input set, measured once.
double baseline(const std::string& key, const std::function<double()>& measure) {
    static std::map<std::string, double> known;
    const auto found = known.find(key);
    return found != known.end() ? found->second : known.emplace(key, measure()).first->second;
}

mpz_class random_bits(std::mt19937_64& engine, unsigned bits) {
    mpz_class r;
    for (unsigned i = 0; i < (bits + 63) / 64; ++i) r = (r << 64) + mpz_class(static_cast<unsigned long>(engine()));
    mpz_fdiv_r_2exp(r.get_mpz_t(), r.get_mpz_t(), bits);
    mpz_setbit(r.get_mpz_t(), bits - 1);
    return (engine() & 1) != 0 ? mpz_class(-r) : r;
}

// --- one conversion a number type ---------------------------------------------------------------------------------

template <class N>
struct Make {
    static N from(const mpz_class& z) { return N::from_string(z.get_str()); }
    static std::string text(const N& x) { return x.to_string(); }
};
template <>
struct Make<mpz_class> {
    static mpz_class from(const mpz_class& z) { return z; }
    static std::string text(const mpz_class& x) { return x.get_str(); }
};
template <class Backend, mp::expression_template_option Option>
struct Make<mp::number<Backend, Option>> {
    static mp::number<Backend, Option> from(const mpz_class& z) { return mp::number<Backend, Option>(z.get_str()); }
    static std::string text(const mp::number<Backend, Option>& x) { return x.str(); }
};
template <>
struct Make<Int128> {
    static Int128 from(const mpz_class& z) { return static_cast<Int128>(z.get_si()); }  // operands of up to 63 bits
    static std::string text(Int128 x) { return Integer(x).to_string(); }
};

// --- operations ---------------------------------------------------------------------------------------------------

struct Add {
    static constexpr const char* name = "add";
    template <class N>
    static void run(N& r, const std::array<N, 4>& x) {
        r = x[0] + x[1];
    }
};

struct Multiply {
    static constexpr const char* name = "multiply";
    template <class N>
    static void run(N& r, const std::array<N, 4>& x) {
        r = x[0] * x[1];
    }
};

struct Minor {
    static constexpr const char* name = "minor";
    template <class N>
    static void run(N& r, const std::array<N, 4>& x) {
        r = x[0] * x[3] - x[1] * x[2];
    }
    template <unsigned K>
    static void run(BasicInteger<K>& r, const std::array<BasicInteger<K>, 4>& x) {
        r = x[0] * x[3];
        sub_product(r, x[1], x[2]);
    }
    static void run(mpz_class& r, const std::array<mpz_class, 4>& x) {
        mpz_mul(r.get_mpz_t(), x[0].get_mpz_t(), x[3].get_mpz_t());
        mpz_submul(r.get_mpz_t(), x[1].get_mpz_t(), x[2].get_mpz_t());
    }
};

struct Gcd {
    static constexpr const char* name = "gcd";
    template <class N>
    static void run(N& r, const std::array<N, 4>& x) {
        r = gcd(x[0], x[1]);
    }
    static void run(mpz_class& r, const std::array<mpz_class, 4>& x) {
        mpz_gcd(r.get_mpz_t(), x[0].get_mpz_t(), x[1].get_mpz_t());
    }
};

struct ExactDivide {  // x[2] is set to x[0] x[1]
    static constexpr const char* name = "exact_divide";
    template <unsigned K>
    static void run(BasicInteger<K>& r, const std::array<BasicInteger<K>, 4>& x) {
        r = exact_divide(x[2], x[0]);
    }
    static void run(mpz_class& r, const std::array<mpz_class, 4>& x) {
        mpz_divexact(r.get_mpz_t(), x[2].get_mpz_t(), x[0].get_mpz_t());
    }
    template <class N>
    static void run(N& r, const std::array<N, 4>& x) {
        r = x[2] / x[0];
    }
};

template <class Operation>
std::vector<std::array<mpz_class, 4>> inputs(unsigned bits) {
    std::mt19937_64 engine(bits);
    std::vector<std::array<mpz_class, 4>> result(tuples);
    for (auto& tuple : result) {
        for (mpz_class& z : tuple) z = random_bits(engine, bits);
        if constexpr (std::is_same_v<Operation, ExactDivide>) tuple[2] = tuple[0] * tuple[1];
    }
    return result;
}

template <class Operation, class N, unsigned Bits>
void measure(benchmark::State& state) {
    const auto reference = inputs<Operation>(Bits);
    std::vector<std::array<N, 4>> x(tuples);
    for (std::size_t i = 0; i < tuples; ++i) {
        for (std::size_t k = 0; k < 4; ++k) x[i][k] = Make<N>::from(reference[i][k]);
    }
    N r{};
    mpz_class exact;
    for (std::size_t i = 0; i < tuples; ++i) {
        Operation::run(r, x[i]);
        Operation::run(exact, reference[i]);
        if (Make<N>::text(r) != exact.get_str()) {
            state.SkipWithError("wrong answer");
            return;
        }
    }
    const double own = least_nanoseconds([&](std::size_t i) {
        Operation::run(r, x[i]);
        benchmark::DoNotOptimize(r);
    });
    const double mpz = baseline(std::string(Operation::name) + std::to_string(Bits), [&] {
        return least_nanoseconds([&](std::size_t i) {
            Operation::run(exact, reference[i]);
            benchmark::DoNotOptimize(exact);
        });
    });
    std::size_t i = 0;
    for (auto _ : state) {
        Operation::run(r, x[i++ % tuples]);
        benchmark::DoNotOptimize(r);
    }
    state.counters["least_ns"] = own;
    state.counters["faster_than_mpz"] = mpz / own;
}

template <class Operation, class N, unsigned Bits>
void add_benchmark(const char* type) {
    const std::string name = std::string(Operation::name) + "/" + std::to_string(Bits) + "/" + type;
    benchmark::RegisterBenchmark(name.c_str(), measure<Operation, N, Bits>);
}

/// The types that hold products of two numbers of `Bits` bits; `Width` is theirs where it is fixed.
template <class Operation, unsigned Bits, unsigned Width>
void add_types() {
    add_benchmark<Operation, Integer, Bits>("Integer");
    add_benchmark<Operation, WideInteger, Bits>("WideInteger");
    if constexpr (!std::is_same_v<Operation, Gcd> && !std::is_same_v<Operation, ExactDivide>) {
        add_benchmark<Operation, FixedInt<Width>, Bits>("FixedInt");
        if constexpr (Bits < 64) add_benchmark<Operation, Int128, Bits>("int128");
    }
    add_benchmark<Operation, mpz_class, Bits>("mpz_class");
    add_benchmark<Operation, mp::cpp_int, Bits>("cpp_int");
    add_benchmark<Operation, FixedCppInt<Width>, Bits>("cpp_int_fixed");
}

template <class Operation>
void add_widths() {
    add_types<Operation, 56, 128>();
    add_types<Operation, 120, 256>();
    add_types<Operation, 184, 384>();
    add_types<Operation, 250, 512>();
    add_types<Operation, 500, 1024>();
}

// --- the determinant of four planes -------------------------------------------------------------------------------

template <class N>
using Rows = std::array<std::array<N, 4>, 4>;

/// The expansion of `PlaneDeterminant`, for any integer with a product-and-add: temporaries made once a call, or kept.
struct MpzDeterminant {
    mpz_class m01, m02, m03, m12, m13, m23, w, sum;

    Sign operator()(const Rows<mpz_class>& p) {
        const auto minor = [&](mpz_class& m, std::size_t i, std::size_t j) {
            mpz_mul(m.get_mpz_t(), p[i][0].get_mpz_t(), p[j][1].get_mpz_t());
            mpz_submul(m.get_mpz_t(), p[j][0].get_mpz_t(), p[i][1].get_mpz_t());
        };
        minor(m01, 0, 1);
        minor(m02, 0, 2);
        minor(m03, 0, 3);
        minor(m12, 1, 2);
        minor(m13, 1, 3);
        minor(m23, 2, 3);
        const auto term = [&](std::size_t i, const mpz_class& jk, std::size_t j, const mpz_class& ik, std::size_t k,
                              const mpz_class& ij) {
            mpz_mul(w.get_mpz_t(), jk.get_mpz_t(), p[i][2].get_mpz_t());
            mpz_submul(w.get_mpz_t(), ik.get_mpz_t(), p[j][2].get_mpz_t());
            mpz_addmul(w.get_mpz_t(), ij.get_mpz_t(), p[k][2].get_mpz_t());
        };
        term(0, m12, 1, m02, 2, m01);
        mpz_mul(sum.get_mpz_t(), w.get_mpz_t(), p[3][3].get_mpz_t());
        term(0, m13, 1, m03, 3, m01);
        mpz_submul(sum.get_mpz_t(), w.get_mpz_t(), p[2][3].get_mpz_t());
        term(0, m23, 2, m03, 3, m02);
        mpz_addmul(sum.get_mpz_t(), w.get_mpz_t(), p[1][3].get_mpz_t());
        term(1, m23, 2, m13, 3, m12);
        mpz_submul(sum.get_mpz_t(), w.get_mpz_t(), p[0][3].get_mpz_t());
        return sign_of_value(sgn(sum));
    }
};

Sign wide_determinant(const Rows<Integer>& p) {
    const auto minor = [&](std::size_t i, std::size_t j) {
        WideInteger m = WideInteger(p[i][0]) * p[j][1];
        sub_product(m, p[j][0], p[i][1]);
        return m;
    };
    const WideInteger m01 = minor(0, 1);
    const WideInteger m02 = minor(0, 2);
    const WideInteger m03 = minor(0, 3);
    const WideInteger m12 = minor(1, 2);
    const WideInteger m13 = minor(1, 3);
    const WideInteger m23 = minor(2, 3);
    const auto term = [&](std::size_t i, const WideInteger& jk, std::size_t j, const WideInteger& ik, std::size_t k,
                          const WideInteger& ij) {
        WideInteger w = jk * p[i][2];
        sub_product(w, ik, p[j][2]);
        add_product(w, ij, p[k][2]);
        return w;
    };
    WideInteger sum = term(0, m12, 1, m02, 2, m01) * p[3][3];
    sub_product(sum, term(0, m13, 1, m03, 3, m01), p[2][3]);
    add_product(sum, term(0, m23, 2, m03, 3, m02), p[1][3]);
    sub_product(sum, term(1, m23, 2, m13, 3, m12), p[0][3]);
    return sum.sign();
}

template <unsigned NormalBits, unsigned OffsetBits>
struct Planes {
    using Determinant = PlaneDeterminant<NormalBits, OffsetBits>;

    Planes() : gmp(tuples), wide(tuples), fixed(tuples) {
        std::mt19937_64 engine(NormalBits);
        for (std::size_t i = 0; i < tuples; ++i) {
            for (std::size_t row = 0; row < 4; ++row) {
                for (std::size_t column = 0; column < 4; ++column) {
                    const mpz_class z = random_bits(engine, column < 3 ? NormalBits : OffsetBits);
                    gmp[i][row][column] = z;
                    wide[i][row][column] = Integer::from_string(z.get_str());
                    if (column < 3)
                        fixed[i][row].normal[column] = typename Determinant::Normal(wide[i][row][column]);
                    else
                        fixed[i][row].offset = typename Determinant::Offset(wide[i][row][column]);
                }
            }
        }
    }

    std::vector<Rows<mpz_class>> gmp;
    std::vector<Rows<Integer>> wide;
    std::vector<std::array<typename Determinant::Plane, 4>> fixed;
};

enum class Way { fixed, wide, mpz, mpz_fresh };

template <unsigned NormalBits, unsigned OffsetBits>
void measure_determinant(benchmark::State& state, Way way) {
    using Set = Planes<NormalBits, OffsetBits>;
    const Set planes;
    MpzDeterminant reused;
    const auto sign = [&](std::size_t i) {
        switch (way) {
            case Way::fixed:
                return Set::Determinant::sign(planes.fixed[i]);
            case Way::wide:
                return wide_determinant(planes.wide[i]);
            case Way::mpz:
                return reused(planes.gmp[i]);
            default:
                return MpzDeterminant()(planes.gmp[i]);
        }
    };
    for (std::size_t i = 0; i < tuples; ++i) {
        if (sign(i) != reused(planes.gmp[i])) {
            state.SkipWithError("wrong sign");
            return;
        }
        if (Set::Determinant::determinant(planes.fixed[i]).to_fixed().to_string() != reused.sum.get_str()) {
            state.SkipWithError("wrong value");
            return;
        }
    }
    const double own = least_nanoseconds([&](std::size_t i) { benchmark::DoNotOptimize(sign(i)); });
    const double mpz = baseline("determinant" + std::to_string(NormalBits), [&] {
        return least_nanoseconds([&](std::size_t i) { benchmark::DoNotOptimize(reused(planes.gmp[i])); });
    });
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(sign(i++ % tuples));
    state.counters["bits"] = Set::Determinant::Value::bits + 1;
    state.counters["least_ns"] = own;
    state.counters["faster_than_mpz"] = mpz / own;
}

/// Planes through points of a grid |x| <= 2^b.
template <unsigned GridBits>
void add_determinants() {
    const std::string name = "plane_determinant/grid_bits:" + std::to_string(GridBits) + "/";
    const std::pair<const char*, Way> ways[] = {
        {"FixedDigits", Way::fixed}, {"WideInteger", Way::wide}, {"mpz", Way::mpz}, {"mpz_fresh", Way::mpz_fresh}};
    for (const auto& [type, way] : ways) {
        const Way chosen = way;
        benchmark::RegisterBenchmark((name + type).c_str(), [chosen](benchmark::State& state) {
            measure_determinant<2 * GridBits + 2, 3 * GridBits + 2>(state, chosen);
        });
    }
}

[[maybe_unused]] const bool registered = [] {
    add_determinants<12>();
    add_determinants<27>();
    add_determinants<55>();
    add_determinants<114>();
    add_widths<Add>();
    add_widths<Multiply>();
    add_widths<Minor>();
    add_widths<Gcd>();
    add_widths<ExactDivide>();
    return true;
}();

}  // namespace
