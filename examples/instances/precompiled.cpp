// SPDX-License-Identifier: Apache-2.0
// Nothing: CMake precompiles headers for a source file that uses them.
