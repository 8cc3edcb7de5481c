// SPDX-License-Identifier: Apache-2.0
/// The one source of the library's version: CMake reads it, and so does the inline namespace.
#ifndef CLEAVE_VERSION_HPP
#define CLEAVE_VERSION_HPP

#define CLEAVE_VERSION_MAJOR 0
#define CLEAVE_VERSION_MINOR 1
#define CLEAVE_VERSION_PATCH 0
#define CLEAVE_VERSION_STRING "0.1.0"

/// Every declaration lives in `cleave::v0_1`, so that two versions in one program fail to link by name
/// rather than mix silently.
#define CLEAVE_BEGIN_NAMESPACE \
    namespace cleave {         \
    inline namespace v0_1 {
#define CLEAVE_END_NAMESPACE \
    }                        \
    }

#endif
