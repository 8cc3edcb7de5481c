// SPDX-License-Identifier: Apache-2.0
/// Set operations: any Boolean function of regions by either engine, the operators, and comparison.
#ifndef CLEAVE_SETOP_HPP
#define CLEAVE_SETOP_HPP

#include <cleave/setop/apply.hpp>
#include <cleave/setop/boundary_filter.hpp>
#include <cleave/setop/compare.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/expression.hpp>
#include <cleave/setop/expression_text.hpp>
#include <cleave/setop/filter_evaluation.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/setop/options.hpp>
#include <cleave/setop/planar_contacts.hpp>
#include <cleave/setop/planar_evaluation.hpp>
#include <cleave/setop/planar_labels.hpp>
#include <cleave/setop/planar_location.hpp>
#include <cleave/setop/tree_evaluation.hpp>

#endif
