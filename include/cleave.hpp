// SPDX-License-Identifier: Apache-2.0
/// Everything in cleave except the opt-in adapters: `execution/tbb`, `number/gmp`, `number/boost_cpp`,
/// `number/boost_gmp`.
#ifndef CLEAVE_HPP
#define CLEAVE_HPP

#include <cleave/algebra.hpp>
#include <cleave/base.hpp>
#include <cleave/bsp.hpp>
#include <cleave/clip.hpp>
#include <cleave/execution.hpp>
#include <cleave/geometry.hpp>
#include <cleave/io.hpp>
#include <cleave/mesh.hpp>
#include <cleave/number.hpp>
#include <cleave/query.hpp>
#include <cleave/region.hpp>
#include <cleave/setop.hpp>
#include <cleave/shape.hpp>

#endif
