// SPDX-License-Identifier: Apache-2.0
/// Conforming faces, under the name of the folder that exports them.
#ifndef CLEAVE_MESH_CONFORM_HPP
#define CLEAVE_MESH_CONFORM_HPP

#include <cleave/region/conform.hpp>

#endif
